! Every function of include/asperity.h, called from Fortran under its own name. What is expected comes from the
! paper's definitions, from closed forms of Hertzian contact, or from a quadrature written here.
program c_interface
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
  use asperity
  use checking
  implicit none

  real(c_double), parameter :: PI = 3.14159265358979323846_c_double

  call versions_and_texts
  call default_parameters
  call dimensionless_parameters
  call material_parameters
  call spectral_moments
  call skewed_heights
  call one_measured_point
  call no_measurements
  call default_strengths
  call pressure_coefficients
  call names
  call surface_texts
  call estimates
  call materials
  call interfaces
  call johnson_heights
  call tabulated_heights
  call life_of_a_model
  call errors_of_values
  call batches
  call values_with_slopes
  call pressures
  call slip_forces
  call batches_beside_friction
  call gaps
  call compiled_table
  call hertzian_states
  call adhesive_summary
  call finish('the C interface from Fortran')

contains

  subroutine versions_and_texts
    character(*), parameter :: DOT = '.'
    character(32) :: version
    integer :: status
    call check('the library has the binary interface of the module', &
               asperity_abi_version() == ASPERITY_HEADER_ABI_VERSION)
    write (version, '(i0, a, i0, a, i0)') ASPERITY_VERSION_MAJOR, DOT, ASPERITY_VERSION_MINOR, DOT, &
                                          ASPERITY_VERSION_PATCH
    call check_text('the version is made of its parts', ASPERITY_HEADER_VERSION, trim(version))
    call check('asperity_version is never NULL', c_associated(asperity_version()))
    call check_text('the library has the version of the module', asperity_version_text(), ASPERITY_HEADER_VERSION)
    call check('a status string is never NULL', c_associated(asperity_status_string(-1_c_int32_t)))
    do status = 1, 6
      call check('a status has a text', len(asperity_status_text(status)) > 0)
      call check('... of its own', asperity_status_text(status) /= asperity_status_text(status - 1))
    end do
  end subroutine versions_and_texts

  subroutine default_parameters
    type(asperity_params) :: p
    call check('asperity_params_init succeeds', asperity_params_init(p) == ASPERITY_OK)
    call check('struct_size is the size of the type', p%struct_size == c_sizeof(p))
    call check('no physical input is set', all(ieee_is_nan([p%composite_modulus, p%effective_shear_modulus, &
               p%work_of_adhesion, p%adhesion_range, p%burgers_vector, p%height_std, p%summit_radius, p%asperity_count])))
    call check('Gaussian heights, attraction on', &
               p%height_distribution == ASPERITY_HEIGHTS_GAUSSIAN .and. p%attraction == 1)
    call check_close('a_1/b of Hurtado and Kim', p%slip_radius_1, 28.0_c_double, 1e-15_c_double)
    call check_close('tau_1/G*', p%slip_stress_1, 1 / 43.0_c_double, 1e-15_c_double)
    call check_close('a_2/b', p%slip_radius_2, 8e4_c_double, 1e-15_c_double)
    call check_close('tau_2/G*', p%slip_stress_2, 1 / 1290.0_c_double, 1e-15_c_double)
    call check('epsilon = 0', identical(p%radius_amplitude, 0.0_c_double))
    call check('rho = 0.5', identical(p%radius_rate, 0.5_c_double))
    call check('coefficients are capped at 1000', identical(p%max_friction_coefficient, 1000.0_c_double))
    call check('skew 0, kurtosis 3', identical(p%skew, 0.0_c_double) .and. identical(p%kurtosis, 3.0_c_double))
    call check('no hardness', identical(p%hardness, 0.0_c_double))
    call check('no pressure coefficient, no bandwidth', identical(p%pressure_coefficient, 0.0_c_double) .and. &
               identical(p%bandwidth, 0.0_c_double))
    call check('no calibration', all(identical([p%calibration_load, p%calibration_friction_force], 0.0_c_double)))
    call check('... but an error of measurements', identical(p%calibration_error, 0.05_c_double))
    call check('no table', .not. c_associated(p%table_height) .and. .not. c_associated(p%table_density) &
               .and. p%table_length == 0)
  end subroutine default_parameters

  subroutine dimensionless_parameters
    type(asperity_params) :: p
    call asperity_check(asperity_params_init(p))
    call asperity_check(asperity_params_set_dimensionless(p, alpha=0.02_c_double, beta=500.0_c_double, &
                        gamma=0.003_c_double, b_over_h=2.0_c_double, poisson=0.25_c_double))
    call check_close('E* = 2/(1 - nu) of the paper', p%composite_modulus, 2 / 0.75_c_double, 1e-15_c_double)
    call check_close('sigma = alpha beta b', p%height_std, 10.0_c_double, 1e-15_c_double)
    call check_close('R = beta b/alpha', p%summit_radius, 25000.0_c_double, 1e-15_c_double)
    call check_close('w = gamma E* b', p%work_of_adhesion, 0.008_c_double, 1e-14_c_double)
    call check_close('h = b/(b/h)', p%adhesion_range, 0.5_c_double, 1e-15_c_double)
    call check_close('G* = 2', p%effective_shear_modulus, 2.0_c_double, 1e-15_c_double)
    call check('b = N = 1', all(identical([p%burgers_vector, p%asperity_count], 1.0_c_double)))
    call check('alpha = 0 is refused', asperity_params_set_dimensionless(p, 0.0_c_double, 500.0_c_double, &
               0.0_c_double, 1.0_c_double, 0.25_c_double) == ASPERITY_INVALID_PARAMETER)
    call check_close('... and the parameters are untouched', p%summit_radius, 25000.0_c_double, 1e-15_c_double)
  end subroutine dimensionless_parameters

  subroutine material_parameters
    real(c_double), parameter :: E1 = 160e9, NU1 = 0.22, E2 = 70e9, NU2 = 0.35
    real(c_double) :: g1, g2
    type(asperity_params) :: p
    p = paper_case()
    call asperity_check(asperity_params_set_materials(p, E1, NU1, E2, NU2))
    g1 = E1 / (2 * (1 + NU1))
    g2 = E2 / (2 * (1 + NU2))
    call check_close('1/E* is the sum over the bodies', p%composite_modulus, &
                     1 / ((1 - NU1**2) / E1 + (1 - NU2**2) / E2), 1e-14_c_double)
    call check_close('G* = 2 G1 G2/(G1 + G2)', p%effective_shear_modulus, 2 * g1 * g2 / (g1 + g2), 1e-14_c_double)
    call asperity_check(asperity_params_set_materials(p, E1, NU1, ieee_value(1.0_c_double, ieee_positive_inf), NU2))
    call check_close('a rigid body adds nothing to 1/E*', p%composite_modulus, E1 / (1 - NU1**2), 1e-14_c_double)
    call check_close('against a rigid body G* = 2 G1', p%effective_shear_modulus, 2 * g1, 1e-14_c_double)
    call asperity_check(asperity_params_set_elastic_plastic(p, 1e9_c_double))
    call check('summits that yield: law, hardness, no adhesion', p%contact_law == ASPERITY_CONTACT_ELASTIC_PLASTIC .and. &
               all(identical([p%hardness, p%work_of_adhesion], [1e9_c_double, 0.0_c_double])))
    call check('... not without a hardness', &
               asperity_params_set_elastic_plastic(p, 0.0_c_double) == ASPERITY_INVALID_PARAMETER)
  end subroutine material_parameters

  subroutine spectral_moments
    real(c_double), parameter :: M0 = 3, M2 = 0.5_c_double, M4 = 0.7_c_double, AREA = 11
    type(asperity_params) :: p
    p = paper_case()
    call asperity_check(asperity_params_set_mccool_summits(p, M0, M2, M4, AREA))
    call check_close('variance of the summit heights', p%height_std**2, (1 - 0.8968_c_double * M2**2 / (M0 * M4)) * M0, &
                     1e-4_c_double)
    call check_close('radius of the summits', p%summit_radius, 0.375_c_double * sqrt(PI / M4), 1e-14_c_double)
    call check_close('number of summits', p%asperity_count, M4 * AREA / (6 * PI * sqrt(3.0_c_double) * M2), &
                     1e-14_c_double)
    call check('a bandwidth below 1.5 is refused', &
               asperity_params_set_spectral_moments(p, M2, M2, 1.49_c_double * M2, AREA) == ASPERITY_INVALID_PARAMETER)
    call check_text('... with a message', asperity_error_message(), &
                    'bandwidth m0 m4/m2^2 = 1.49: must be at least 1.5, the least of isotropic surfaces; ' // &
                    'are all lengths in one unit, Ssc per m and Sds per m^2?')
    call asperity_check(asperity_params_set_spectral_moments(p, M0, M2, 0.0_c_double, AREA))
    call check_close('slope of the surface', p%rms_slope, sqrt(2 * M2), 1e-14_c_double)
    call check('higher asperities are sharper', p%radius_amplitude < 0)
    call check('asperities stand above the mean plane', p%summit_mean_height > sqrt(M0))
  end subroutine spectral_moments

  ! Skew from the moments of the Weibull distribution, B_n = Gamma(1 + n/omega).
  subroutine skewed_heights
    real(c_double), parameter :: SKEWS(3) = [-0.9_c_double, 0.4_c_double, 1.9_c_double]
    type(asperity_params) :: p
    integer :: i
    p = paper_case()
    do i = 1, size(SKEWS)
      call asperity_check(asperity_params_set_skew(p, SKEWS(i)))
      call check('a skew makes the heights Weibull', p%height_distribution == ASPERITY_HEIGHTS_WEIBULL)
      call check_close('the Weibull shape has the skew', weibull_skew(p%weibull_shape), SKEWS(i), 1e-9_c_double)
    end do
    call asperity_check(asperity_params_set_skew(p, 0.0_c_double))
    call check_close('no skew is omega = 3.602, as in the paper', p%weibull_shape, 3.602_c_double, 2e-4_c_double)
    call check('skew -1.2 is outside the family', &
               asperity_params_set_skew(p, -1.2_c_double) == ASPERITY_INVALID_PARAMETER)
  end subroutine skewed_heights

  subroutine materials
    type(asperity_material_data) :: material
    type(asperity_pair_data) :: pair
    type(asperity_params) :: p, expected
    character(200) :: message
    integer :: i, status
    call asperity_material('steel', material)
    call check_close('steel', material%young, 205e9_c_double, 1e-15_c_double)
    call check('its name and source', c_associated(material%name) .and. c_associated(material%reference))
    call asperity_pair('Si/Si', pair)
    call check_close('Si/Si', pair%work_of_adhesion, 0.063_c_double, 1e-15_c_double)
    call check('the C functions list them', c_associated(asperity_material_name(0_c_size_t)) .and. &
               c_associated(asperity_pair_name(0_c_size_t)))
    i = 1
    do while (asperity_material_name_text(i) /= '')
      call asperity_material(asperity_material_name_text(i), material)
      call check('every material is found', material%young > 0 .and. material%poisson > 0)
      i = i + 1
    end do
    call check('there are some thirty', i > 30 .and. asperity_material_name_text(0) == '')
    i = 1
    do while (asperity_pair_name_text(i) /= '')
      call asperity_pair(asperity_pair_name_text(i), pair)
      call check('every pair is found', pair%work_of_adhesion > 0)
      i = i + 1
    end do
    call check('there are some twenty-five', i > 25 .and. asperity_pair_name_text(0) == '')

    p = paper_case()
    expected = p
    call asperity_check(asperity_params_set_materials(expected, 54e9_c_double, 0.1_c_double, 78e9_c_double, 0.44_c_double))
    call asperity_params_set_pair(p, 'Au/mica')
    call check_close('a pair sets the bodies', p%composite_modulus, expected%composite_modulus, 1e-15_c_double)
    call check_close('... the work of adhesion', p%work_of_adhesion, 0.172_c_double, 1e-15_c_double)
    call check_close('... the longer Burgers vector', p%burgers_vector, 0.52e-9_c_double, 1e-15_c_double)
    call check_close('... a measured slip stress', p%slip_stress_1, 0.0108_c_double, 1e-15_c_double)
    call check('... no hardness where one is not known', identical(p%hardness, 0.0_c_double))
    call asperity_params_set_pair(p, 'Si/Si  ')
    call check_close('blanks behind a name are none of it', p%burgers_vector, 0.384e-9_c_double, 1e-15_c_double)
    call check_close('... with the hardness', p%hardness, 12e9_c_double, 1e-15_c_double)

    material%young = 7
    pair%hamaker = 7
    call asperity_material('stel', material, status, message)
    call check('an unknown material', status == ASPERITY_INVALID_PARAMETER .and. identical(material%young, 7.0_c_double) &
               .and. message == 'stel: no material has this name; the nearest is steel')
    call asperity_pair('steel', pair, status, message)
    call check('an unknown pair', status == ASPERITY_INVALID_PARAMETER .and. identical(pair%hamaker, 7.0_c_double))
    call asperity_params_set_pair(p, 'PDMS/PDMS', status, message)
    call check('a body without a Burgers vector leaves it to set', status == ASPERITY_OK .and. ieee_is_nan(p%burgers_vector))
  end subroutine materials

  subroutine interfaces
    type(asperity_interface_data) :: found
    type(asperity_params) :: p
    character(400) :: message
    integer :: i, status
    call asperity_interface('graphite layers', found)
    call check_close('layers of graphite', found%shear_strength, 140e6_c_double, 1e-15_c_double)
    call check('their texts', c_associated(found%name) .and. c_associated(found%conditions) .and. &
               c_associated(found%source) .and. c_associated(found%reference))
    call check('the C function lists them', c_associated(asperity_interface_name(0_c_size_t)))
    i = 1
    do while (asperity_interface_name_text(i) /= '')
      call asperity_interface(asperity_interface_name_text(i), found)
      call check('every interface has a number', found%shear_strength > 0 .or. found%friction_coefficient > 0)
      i = i + 1
    end do
    call check('there are twenty and more', i > 20 .and. asperity_interface_name_text(0) == '')

    p = paper_case()
    call asperity_params_set_pair(p, 'steel/steel')
    call asperity_params_set_interface(p, 'MoS2 film in dry air')
    call check_close('a strength', p%slip_stress_1 * p%effective_shear_modulus, 24.8e6_c_double, 1e-15_c_double)
    call check('... of all sizes', identical(p%slip_stress_2, p%slip_stress_1))
    call check_close('... that grows with pressure', p%pressure_coefficient, 0.001_c_double, 1e-15_c_double)
    call asperity_params_set_interface(p, 'graphite layers')
    call check('no kappa is 0', identical(p%pressure_coefficient, 0.0_c_double))
    call asperity_params_set_interface(p, 'steel/steel dry', status, message)
    call check('a friction coefficient is no strength', status == ASPERITY_INVALID_PARAMETER .and. &
               index(message, 'only a friction coefficient of 0.57 at 12 N') > 0)
    found%load = 7
    call asperity_interface('graphite', found, status, message)
    call check('an unknown interface', status == ASPERITY_INVALID_PARAMETER .and. identical(found%load, 7.0_c_double) &
               .and. index(message, 'graphite: no interface has this name; the nearest is ') == 1)
  end subroutine interfaces

  subroutine names
    character(11), parameter :: BODIES(4) = [character(11) :: 'nu2', 'E1', 'nu1', 'E2']
    character(kind=c_char), target :: name(9) = ['h', 'a', 'r', 'd', 'n', 'e', 's', 's', c_null_char]
    type(c_ptr), target :: first(1)
    type(asperity_params) :: p, expected, copied
    real(c_double), target :: found(1)
    character(200) :: message
    integer :: i, status
    p = paper_case()
    expected = p
    call asperity_check(asperity_params_set_materials(expected, 160e9_c_double, 0.3_c_double, 70e9_c_double, 0.22_c_double))
    call asperity_params_set(p, BODIES, [0.22_c_double, 160e9_c_double, 0.3_c_double, 70e9_c_double])
    call check_close('bodies by name', p%composite_modulus, expected%composite_modulus, 0.0_c_double)
    call asperity_params_set(p, 'hardness ', 3.0_c_double)
    call check_close('a field by name', p%hardness, 3.0_c_double, 0.0_c_double)
    call asperity_params_set(p, 'skew', -0.5_c_double)
    call check('a skew by name is one of Weibull heights', p%height_distribution == ASPERITY_HEIGHTS_WEIBULL)

    call asperity_check(asperity_params_set_value(p, c_loc(name), 4.0_c_double))
    call asperity_check(asperity_params_get_value(p, c_loc(name), c_loc(found)))
    call check_close('the C functions take and give it', found(1), 4.0_c_double, 0.0_c_double)
    first = c_loc(name)
    found = 5
    call asperity_check(asperity_params_set_values(p, 1_c_size_t, c_loc(first), c_loc(found)))
    call check_close('... several of them too', p%hardness, 5.0_c_double, 0.0_c_double)

    call asperity_check(asperity_params_init(copied))
    i = 1
    do while (asperity_params_name_text(i) /= '')
      call asperity_params_set(copied, asperity_params_name_text(i), asperity_params_get(p, asperity_params_name_text(i)))
      i = i + 1
    end do
    call check('the C function lists them', c_associated(asperity_params_name(int(i - 2, c_size_t))) .and. &
               .not. c_associated(asperity_params_name(int(i - 1, c_size_t))))
    call check('there are some twenty-five', i > 25 .and. asperity_params_name_text(0) == '')
    call check('names copy the heights', copied%height_distribution == p%height_distribution)
    call check_close('... their shape', copied%weibull_shape, p%weibull_shape, 0.0_c_double)
    call check_close('... the hardness', copied%hardness, p%hardness, 0.0_c_double)
    call check_close('... the first input', copied%composite_modulus, p%composite_modulus, 0.0_c_double)

    call asperity_params_set(p, 'hardnes', 1.0_c_double, status, message)
    call check('an unknown name', status == ASPERITY_INVALID_PARAMETER .and. &
               message == 'hardnes: no parameter has this name; the nearest is hardness')
    call check('... reads as 0', &
               .not. abs(asperity_params_get(p, 'E1', status, message)) > 0 .and. status == ASPERITY_INVALID_PARAMETER)
    call asperity_params_set(p, BODIES, [1.0_c_double], status, message)
    call check('as many numbers as names', message == 'values: must be as many as names')
    call check_close('what is refused changes nothing', p%hardness, 5.0_c_double, 0.0_c_double)
  end subroutine names

  ! What a text gives is what the calls set, from a string and from a file, and in other units.
  subroutine surface_texts
    character(*), parameter :: LF = new_line('a')
    character(*), parameter :: SURFACE = 'pair = "steel/steel"' // LF // 'contact_law = "elastic-plastic"' // LF // &
      'work_of_adhesion = 0' // LF // 'nominal_area = 1e-4' // LF // 'calibration_load = 1000' // LF // &
      'calibration_friction_coefficient = 0.16' // LF // '[roughness]' // LF // 'm0 = 1e-12' // LF // 'm2 = 0.02' // LF // &
      'm4 = 4e9' // LF
    type(asperity_params) :: p, expected
    character(300) :: path, message
    integer :: unit, stat
    call asperity_check(asperity_params_init(expected))
    call asperity_params_set_pair(expected, 'steel/steel')
    call asperity_check(asperity_params_set_elastic_plastic(expected, expected%hardness))
    call asperity_check(asperity_params_set_spectral_moments(expected, 1e-12_c_double, 0.02_c_double, 4e9_c_double, &
                                                             1e-4_c_double))
    call asperity_check(asperity_params_calibrate(expected, 1000.0_c_double, 0.16_c_double))

    call asperity_check(asperity_params_init(p))
    call asperity_params_set_text(p, SURFACE)
    call check_equal_numbers('a text is what the calls set', p, expected)
    call asperity_check(asperity_params_init(p))
    call asperity_params_set_text(p, asperity_params_text(expected))
    call check_equal_numbers('the text that is written is what is read', p, expected)

    call get_command_argument(0, path)
    path = trim(path) // '.toml'
    open (newunit=unit, file=path, action='write', access='stream', status='replace')
    write (unit) SURFACE
    close (unit)
    call asperity_check(asperity_params_init(p))
    call asperity_params_read(p, path)
    call check_equal_numbers('so is a file', p, expected)
    open (newunit=unit, file=path, status='old')
    close (unit, status='delete')
    call asperity_params_read(p, path, stat, message)
    call check('a file that is not there is named', stat == ASPERITY_INVALID_PARAMETER .and. &
               index(message, trim(path) // ': ') == 1)
    call asperity_params_set_text(p, 'hardness = 1' // LF // 'slip_onset = "hole"', stat, message)
    call check('a wrong text is refused', stat == ASPERITY_INVALID_PARAMETER)
    call check_text('... with its line', message, 'line 2: slip_onset = "hole": must be "partial" or "whole"')
    call check_equal_numbers('... and changes nothing', p, expected)

    call asperity_check(asperity_params_set_units(p, 1e-3_c_double, 1.0_c_double))
    call check_close('moduli in MPa', p%composite_modulus, expected%composite_modulus * 1e-6_c_double, 1e-14_c_double)
    call check_close('lengths in mm', p%summit_radius, expected%summit_radius * 1e3_c_double, 1e-14_c_double)
    call check_close('the measurement too', p%calibration_load, 1000.0_c_double, 0.0_c_double)
    p%contact_law = 7
    message = asperity_params_text(p, stat)
    call check('what has no meaning has no text', stat == ASPERITY_INVALID_PARAMETER .and. message == '')
  end subroutine surface_texts

  ! Friction from a text alone.
  subroutine estimates
    character(*), parameter :: LF = new_line('a')
    character(*), parameter :: SURFACE = 'pair = "steel/steel"' // LF // 'nominal_area = 1e-4' // LF // &
      'measured = [1000, 0.16]' // LF // '[roughness]' // LF // 'process = "ground"' // LF // 'Ra = 0.8e-6' // LF
    type(asperity_estimate) :: found(2), none(0)
    type(asperity_params) :: params
    character(300) :: message
    integer :: stat
    call asperity_estimate_at_loads(SURFACE, [10.0_c_double, 1000.0_c_double], found)
    call check_close('the measured point is met', found(2)%friction_coefficient, 0.16_c_double, 1e-6_c_double)
    call check('another load has its band', found(1)%low > 0.16 .and. found(1)%low < found(1)%friction_coefficient &
               .and. found(1)%friction_coefficient < found(1)%high .and. found(1)%high < 0.23)
    call check('... and what it rests on', found(1)%strength_source == ASPERITY_STRENGTH_MEASURED)
    call check('so has its text', index(asperity_estimate_text(SURFACE, [10.0_c_double]), &
                                        'mu(10 N) = 0.194, 95 % band 0.167 to 0.221' // LF) == 1)
    call asperity_check(asperity_params_init(params))
    call asperity_params_set_estimate(params, SURFACE)
    call check('a model of it takes its contact law', params%contact_law == ASPERITY_CONTACT_ELASTIC_PLASTIC)
    call check('... of many contacts', found(1)%contacts > 20 .and. found(1)%specimen_scatter < 0.05)
    call asperity_params_set_estimate(params, 'mu = 1', stat)
    call check('... whole or not at all', stat == ASPERITY_INVALID_PARAMETER .and. &
               identical(params%calibration_load, 1000.0_c_double))
    call asperity_estimate_at_loads(SURFACE, [real(c_double) ::], none)
    call asperity_estimate_at_loads('measured = 0.16', [1.0_c_double], found, stat, message)
    call check('what is wrong is named', stat == ASPERITY_INVALID_PARAMETER .and. &
               index(message, 'line 1: measured = 0.16: must be points') == 1)
    message = asperity_estimate_text('', [1.0_c_double], stat)
    call check('... and has no text', stat == ASPERITY_INVALID_PARAMETER .and. message == '')
  end subroutine estimates

  subroutine check_equal_numbers(claim, p, expected)
    character(*), intent(in) :: claim
    type(asperity_params), intent(in) :: p, expected
    character(:), allocatable :: name
    integer :: i
    i = 1
    name = asperity_params_name_text(i)
    do while (name /= '')
      call check(claim // ': ' // name, identical(asperity_params_get(p, name), asperity_params_get(expected, name)))
      i = i + 1
      name = asperity_params_name_text(i)
    end do
    call check(claim // ': the measurement', identical(p%calibration_load, expected%calibration_load) .and. &
               identical(p%calibration_friction_force, expected%calibration_friction_force))
  end subroutine check_equal_numbers

  ! mu = 0.31 at a load of 4: the law passes through the point, its strength alone has changed, and the point is remembered.
  subroutine one_measured_point
    real(c_double), parameter :: LOAD = 4, MU = 0.31_c_double, KAPPA = 0.05_c_double
    type(asperity_params) :: p, before, kept
    type(asperity_state) :: state
    type(c_ptr) :: model
    p = paper_case()
    p%calibration_error = 0.1_c_double
    before = p
    call asperity_check(asperity_params_calibrate(p, LOAD, MU))
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    call asperity_check(asperity_state_at_load(model, LOAD, state))
    call check_close('the law passes through the measured point', state%friction_coefficient, MU, 1e-9_c_double)
    call check_close('... compiled too', asperity_friction_at_load(model, LOAD), MU, 2e-9_c_double)
    call asperity_check(asperity_get_params(model, kept))
    call check('the model remembers it', all(identical([kept%calibration_load, kept%calibration_error], &
                                                       [LOAD, 0.1_c_double])))
    call check_close('... as a force', kept%calibration_friction_force, MU * LOAD, 1e-15_c_double)
    call asperity_free(model)
    call check_close('both slip stresses have one factor', p%slip_stress_1 / before%slip_stress_1, &
                     p%slip_stress_2 / before%slip_stress_2, 1e-14_c_double)
    call check('... and nothing else changes', identical(p%height_std, before%height_std) .and. &
               identical(p%pressure_coefficient, 0.0_c_double) .and. p%struct_size == before%struct_size)
    kept = before
    call asperity_check(asperity_params_calibrate_force(kept, LOAD, MU * LOAD))
    call check('the force says the same', identical(kept%slip_stress_1, p%slip_stress_1))
    kept = before
    call asperity_params_set(kept, [character(32) :: 'calibration_load', 'calibration_friction_coefficient'], [LOAD, MU])
    call check('... and so do the names', identical(kept%slip_stress_1, p%slip_stress_1))
    kept%effective_shear_modulus = 80e9_c_double
    call asperity_params_set_interface(kept, 'MoS2 film in dry air')
    call check('a strength by name forgets the measurement', identical(kept%calibration_load, 0.0_c_double) .and. &
               identical(kept%calibration_friction_force, 0.0_c_double))

    p = before
    p%pressure_coefficient = KAPPA
    call asperity_check(asperity_params_calibrate(p, LOAD, MU))
    call check('the pressure coefficient stays', identical(p%pressure_coefficient, KAPPA))
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    call check_close('... and the point is met', asperity_friction_at_load(model, LOAD), MU, 2e-9_c_double)
    call asperity_free(model)
  end subroutine one_measured_point

  subroutine no_measurements
    real(c_double), parameter :: LOAD = 4
    type(asperity_params) :: p
    p = paper_case()
    call refused_point(p, LOAD, 20.1_c_double, &
                       'calibration_friction_coefficient = 20.1: must be > 0 and at most 20; is it a force?')
    call refused_point(p, LOAD, -0.1_c_double, 'calibration_friction_coefficient = -0.1: must be > 0')
    call refused_point(p, 0.0_c_double, 0.31_c_double, 'calibration_load = 0: must be > 0; at zero load')
    p%pressure_coefficient = 0.5_c_double
    call refused_point(p, LOAD, 0.31_c_double, 'friction_force = 1.24 at load = 4: must be above 3.82567')
    call check('a load that is NaN is refused', asperity_params_calibrate(p, nan(), 0.3_c_double) == ASPERITY_INVALID_LOAD)
    call check('a force of zero is refused', &
               asperity_params_calibrate_force(p, LOAD, 0.0_c_double) == ASPERITY_INVALID_PARAMETER)
  end subroutine no_measurements

  subroutine refused_point(p, load, mu, message)
    type(asperity_params), intent(in) :: p
    real(c_double), intent(in) :: load, mu
    character(*), intent(in) :: message
    type(asperity_params) :: changed
    character(300) :: said
    changed = p
    call check(message, asperity_params_calibrate(changed, load, mu) == ASPERITY_INVALID_PARAMETER)
    said = asperity_error_message()
    call check_text('the message', said(:len(message)), message)
    call check('... and untouched', all(identical([changed%slip_stress_1, changed%slip_stress_2, changed%calibration_load], &
                                                  [p%slip_stress_1, p%slip_stress_2, p%calibration_load])))
  end subroutine refused_point

  ! A strength that nobody measured is warned of: of one summit as of many, whatever the slip radii are.
  subroutine default_strengths
    real(c_double), parameter :: COUNTS(2) = [1.0_c_double, 1e4_c_double]
    type(asperity_params) :: p
    integer :: i
    do i = 1, 2
      p = paper_case()
      p%asperity_count = COUNTS(i)
      call check('the default is warned of', is_warned_of(p))
      p%slip_radius_1 = 30
      call check('... at other slip radii too', is_warned_of(p))
      call asperity_check(asperity_params_calibrate(p, COUNTS(i), 0.3_c_double))
      call check('... until it is calibrated', .not. is_warned_of(p))
    end do
  end subroutine default_strengths

  function is_warned_of(p) result(warned)
    type(asperity_params), intent(in) :: p
    logical :: warned
    type(c_ptr) :: model
    integer(c_int64_t) :: warnings
    model = c_null_ptr
    warnings = 0
    call asperity_check(asperity_create(p, model))
    call asperity_check(asperity_check_loads(model, p%asperity_count, p%asperity_count, warnings))
    call asperity_free(model)
    warned = iand(warnings, ASPERITY_WARNING_UNCALIBRATED) /= 0
  end function is_warned_of

  ! Of Hertz' contacts without a strength F is kappa P, at every load.
  subroutine pressure_coefficients
    real(c_double), parameter :: KAPPA = 0.2_c_double, LOAD(3) = [0.1_c_double, 4.0_c_double, 1e3_c_double]
    type(asperity_params) :: p
    type(asperity_state) :: state
    type(asperity_sensitivities) :: by
    type(c_ptr) :: model
    real(c_double) :: plain(3)
    character(120) :: message
    integer :: i
    p = paper_case()
    p%work_of_adhesion = 0
    p%attraction = 0
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    do i = 1, 3
      plain(i) = asperity_friction_force_at_load(model, LOAD(i))
    end do
    p%pressure_coefficient = KAPPA
    call asperity_check(asperity_set_params(model, p))
    do i = 1, 3
      call check_close('without adhesion kappa adds kappa P', asperity_friction_force_at_load(model, LOAD(i)), &
                       plain(i) + KAPPA * LOAD(i), 1e-10_c_double)
      call asperity_check(asperity_state_at_load(model, LOAD(i), state))
      call check_close('Hertz'' contacts carry the load', state%hertz_load, LOAD(i), 1e-9_c_double)
      call check_close('the sum of the radii is the stiffness over 8 G^', state%contact_radius_sum, &
                       state%tangential_stiffness * 2 * (p%composite_modulus + p%effective_shear_modulus) / &
                       (8 * p%composite_modulus * p%effective_shear_modulus), 1e-9_c_double)
      call check('one summit: no scatter, no bias', identical(state%friction_scatter, 0.0_c_double) .and. &
                 identical(state%friction_bias, 0.0_c_double))
      call asperity_check(asperity_sensitivities_at_load(model, LOAD(i), by))
      call check_close('d(ln F)/d(kappa) = P/F', by%pressure_coefficient, LOAD(i) / state%friction_force, 1e-8_c_double)
    end do
    p%slip_stress_1 = 0
    p%slip_stress_2 = 0
    call asperity_check(asperity_set_params(model, p))
    do i = 1, 3
      call check_close('a strength of zero leaves Amontons'' law', asperity_friction_at_load(model, LOAD(i)), KAPPA, &
                       1e-9_c_double)
    end do
    p%pressure_coefficient = -KAPPA
    call check('a negative pressure coefficient is refused', asperity_set_params(model, p) == ASPERITY_INVALID_PARAMETER)
    message = asperity_error_message()
    call check('... by name', index(message, 'pressure_coefficient = -0.2: must be finite and >= 0') == 1)
    call asperity_free(model)
  end subroutine pressure_coefficients

  function weibull_skew(omega) result(skew)
    real(c_double), intent(in) :: omega
    real(c_double) :: skew, b1, b2, b3
    b1 = gamma(1 + 1 / omega)
    b2 = gamma(1 + 2 / omega)
    b3 = gamma(1 + 3 / omega)
    skew = (b3 - 3 * b1 * b2 + 2 * b1**3) / sqrt(b2 - b1**2)**3
  end function weibull_skew

  subroutine johnson_heights
    type(asperity_params) :: p
    type(asperity_summary) :: s
    type(c_ptr) :: model
    p = paper_case()
    p%height_distribution = ASPERITY_HEIGHTS_JOHNSON
    p%skew = -0.4_c_double
    p%kurtosis = 3.8_c_double
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    call asperity_check(asperity_summary_of(model, s))
    call check_close('the skew of the heights', s%skew, p%skew, 1e-9_c_double)
    call check_close('... and their kurtosis', s%kurtosis, p%kurtosis, 1e-9_c_double)
    p%kurtosis = 1
    call check('no distribution has less than skew**2 + 1', &
               asperity_set_params(model, p) == ASPERITY_INVALID_PARAMETER)
    p%kurtosis = 1.86_c_double + 1.25_c_double * p%skew**2
    call check('heights have at least 1.87 + 1.25 skew**2', asperity_set_params(model, p) == ASPERITY_OUT_OF_RANGE)
    p%kurtosis = 101
    call check('... and at most 100', asperity_set_params(model, p) == ASPERITY_OUT_OF_RANGE)
    call asperity_free(model)
  end subroutine johnson_heights

  ! A triangle about 3: no skew, kurtosis 2.4.
  subroutine tabulated_heights
    real(c_double), target :: height(5), density(5)
    real(c_double), pointer :: kept(:)
    type(asperity_params) :: p, back
    type(asperity_summary) :: s
    type(c_ptr) :: model
    height = [1, 2, 3, 4, 5]
    density = [0, 1, 2, 1, 0]
    p = paper_case()
    p%height_distribution = ASPERITY_HEIGHTS_TABULATED
    p%table_height = c_loc(height)
    p%table_density = c_loc(density)
    p%table_length = size(height)
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    height = 0
    call asperity_check(asperity_summary_of(model, s))
    call check('a symmetric table has no skew', abs(s%skew) < 1e-12_c_double)
    call check_close('... and the kurtosis of a triangle', s%kurtosis, 2.4_c_double, 0.02_c_double)
    call asperity_check(asperity_get_params(model, back))
    call c_f_pointer(back%table_height, kept, [back%table_length])
    call check('the model has its own table', size(kept) == 5 .and. identical(kept(5), 5.0_c_double))
    call asperity_check(asperity_set_params(model, back))
    call check('heights that do not increase are refused', &
               asperity_set_params(model, p) == ASPERITY_INVALID_PARAMETER)
    call check_text('... with a message', asperity_error_message(), &
                    'table_height[1] = 0: must be greater than the height before it')
    call asperity_free(model)
  end subroutine tabulated_heights

  subroutine life_of_a_model
    type(asperity_params) :: p, back
    type(c_ptr) :: model, untouched
    p = paper_case()
    model = c_null_ptr
    p%height_std = -1
    call check('a negative height_std is refused', asperity_create(p, model) == ASPERITY_INVALID_PARAMETER)
    call check('... and the handle is untouched', .not. c_associated(model))
    call check_text('... with a message', asperity_error_message(), 'height_std = -1: must be finite and > 0')
    p%height_std = 10
    call asperity_check(asperity_create(p, model))
    p%asperity_count = 7
    call asperity_check(asperity_set_params(model, p))
    back%asperity_count = 0
    call asperity_check(asperity_get_params(model, back))
    call check('parameters come back as they were set', identical(back%asperity_count, 7.0_c_double))
    untouched = model
    p%attraction = 2
    call check('attraction = 2 is refused', asperity_set_params(model, p) == ASPERITY_INVALID_PARAMETER)
    call asperity_check(asperity_get_params(untouched, back))
    call check('... and the model is as before', back%attraction == 1)
    call asperity_free(model)
    call asperity_free(c_null_ptr)
  end subroutine life_of_a_model

  subroutine errors_of_values
    type(asperity_params) :: p
    type(c_ptr) :: model
    character(kind=c_char), target :: few(6)
    integer(c_size_t) :: length
    p = paper_case()
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    call check('mu at NaN is NaN', ieee_is_nan(asperity_friction_at_load(model, nan())))
    call check('F at infinity is NaN', &
               ieee_is_nan(asperity_friction_force_at_load(model, ieee_value(1.0_c_double, ieee_positive_inf))))
    call check('mu of no model is NaN', ieee_is_nan(asperity_friction_at_load(c_null_ptr, 1.0_c_double)))
    call check('parameters of no model', asperity_get_params(c_null_ptr, p) == ASPERITY_NULL_POINTER)
    length = asperity_last_error(c_null_ptr, 0_c_size_t)
    call check('the length of the message without a buffer', length == len(asperity_error_message()))
    call check('a short buffer does not change the length', asperity_last_error(c_loc(few), 6_c_size_t) == length)
    call check('a message is cut to fit and ended', few(5) == 'l' .and. few(6) == c_null_char)
    call asperity_free(model)
  end subroutine errors_of_values

  subroutine batches
    integer, parameter :: N = 6
    type(asperity_params) :: p
    type(c_ptr) :: model
    real(c_double), target :: load(N), mu(N), slope(N), force(N), dforce(N)
    integer :: i
    p = paper_case()
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    load = [(10.0_c_double**(i - 2), i=1, N)]
    call asperity_check(asperity_friction_at_loads(model, int(N, c_size_t), c_loc(load), c_loc(mu), c_loc(slope)))
    call asperity_check(asperity_friction_force_at_loads(model, int(N, c_size_t), c_loc(load), c_loc(force), &
                                                         c_loc(dforce)))
    do i = 1, N
      call check('an element is as the scalar call gives it', &
                 identical(mu(i), asperity_friction_at_load(model, load(i))) .and. &
                 identical(force(i), asperity_friction_force_at_load(model, load(i))))
      call check_close('F = mu P', mu(i) * load(i), force(i), 1e-15_c_double)
      call check_close('dF/dP = mu + P d(mu)/dP', mu(i) + load(i) * slope(i), dforce(i), 1e-13_c_double)
    end do
    call asperity_check(asperity_friction_at_loads(model, int(N, c_size_t), c_loc(load), c_null_ptr, c_loc(slope)))
    load(3) = nan()
    call check('NaN among the loads', asperity_friction_at_loads(model, int(N, c_size_t), c_loc(load), c_loc(mu), &
               c_null_ptr) == ASPERITY_INVALID_LOAD)
    call check('... all elements are filled nevertheless', ieee_is_nan(mu(3)) .and. mu(N) > 0)
    call check('no loads, no work', asperity_friction_at_loads(model, 0_c_size_t, c_null_ptr, c_null_ptr, &
               c_null_ptr) == ASPERITY_OK)
    call asperity_free(model)
  end subroutine batches

  subroutine values_with_slopes
    type(c_ptr) :: model
    real(c_double), target :: load(1), slope(1), at_once
    integer :: i
    model = default_model()
    do i = -2, 5
      load = 10.0_c_double**i
      call check('mu with its slope is mu', identical(asperity_friction_at_load(model, load(1)), &
                 asperity_friction_and_slope_at_load(model, load(1), c_loc(at_once))))
      call asperity_check(asperity_friction_at_loads(model, 1_c_size_t, c_loc(load), c_null_ptr, c_loc(slope)))
      call check('... and its slope that of the batch', identical(at_once, slope(1)))
      call check('F with its slope is F', identical(asperity_friction_force_at_load(model, load(1)), &
                 asperity_friction_force_and_slope_at_load(model, load(1), c_loc(at_once))))
      call asperity_check(asperity_friction_force_at_loads(model, 1_c_size_t, c_loc(load), c_null_ptr, c_loc(slope)))
      call check('... and its slope that of the batch', identical(at_once, slope(1)))
    end do
    call check('the slope may be left out', asperity_friction_and_slope_at_load(model, 1.0_c_double, c_null_ptr) > 0 &
               .and. asperity_friction_force_and_slope_at_load(model, 1.0_c_double, c_null_ptr) > 0)
    call asperity_free(model)
  end subroutine values_with_slopes

  ! A pressure is the load on a unit of area, for two areas that do not round alike.
  subroutine pressures
    real(c_double), parameter :: AREAS(2) = [3e-7_c_double, 40.0_c_double], WRONG(4) = [0d0, -1d0, 1d-101, 1d101]
    type(c_ptr) :: model
    real(c_double), target :: slope, at_pressure
    real(c_double) :: load, p, mu, stress
    integer :: i, k
    model = default_model()
    do i = 1, size(AREAS)
      do k = -2, 5
        load = 3 * 10.0_c_double**k
        p = load / AREAS(i)
        mu = asperity_friction_and_slope_at_load(model, p * AREAS(i), c_loc(slope))
        call check('mu at a pressure is mu at its load', &
                   identical(asperity_friction_at_pressure(model, p, AREAS(i), c_loc(at_pressure)), mu))
        call check_close('d(mu)/dp = A d(mu)/dP', at_pressure, AREAS(i) * slope, 1e-15_c_double)
        stress = asperity_shear_stress_at_pressure(model, p, AREAS(i), c_loc(at_pressure))
        call check_close('the stress is mu p', stress, mu * p, 1e-15_c_double)
        call check_close('... its slope mu + p d(mu)/dp', at_pressure, mu + load * slope, 1e-13_c_double)
      end do
      call check_close('friction without pressure', &
                       AREAS(i) * asperity_shear_stress_at_pressure(model, 0.0_c_double, AREAS(i), c_null_ptr), &
                       asperity_friction_force_at_load(model, 0.0_c_double), 1e-15_c_double)
    end do
    do i = 1, size(WRONG)
      slope = 0
      call check('no friction for an area that is not allowed', &
                 ieee_is_nan(asperity_friction_at_pressure(model, 1.0_c_double, WRONG(i), c_loc(slope))))
      call check('... nor a slope', ieee_is_nan(slope))
      call check('... nor a stress', &
                 ieee_is_nan(asperity_shear_stress_at_pressure(model, 1.0_c_double, WRONG(i), c_null_ptr)))
    end do
    call check('nor for an area that is NaN', &
               ieee_is_nan(asperity_friction_at_pressure(model, 1.0_c_double, nan(), c_null_ptr)))
    call check('nor for a pressure that is', &
               ieee_is_nan(asperity_shear_stress_at_pressure(model, nan(), 1.0_c_double, c_null_ptr)))
    call asperity_free(model)
  end subroutine pressures

  ! F(P) tanh(v/v0): sign, size and both slopes, these against differences of fourth order.
  subroutine slip_forces
    real(c_double), parameter :: V0 = 0.02_c_double, RATES(5) = V0 * [0.0_c_double, 0.1_c_double, 0.7_c_double, &
                                                                      1.0_c_double, 2.5_c_double]
    integer, parameter :: AT(4) = [-2, -1, 1, 2]
    type(c_ptr) :: model
    real(c_double), target :: by_load, by_rate
    real(c_double) :: force, values(4), p, step
    integer :: i, j, k
    model = default_model()
    do i = -1, 4
      p = 2 * 10.0_c_double**i
      do j = 1, size(RATES)
        force = asperity_slip_force(model, p, RATES(j), V0, c_loc(by_load), c_loc(by_rate))
        call check_close('F tanh(v/v0)', force, asperity_friction_force_at_load(model, p) * tanh(RATES(j) / V0), &
                         1e-14_c_double)
        call check('odd in the slip rate', &
                   identical(asperity_slip_force(model, p, -RATES(j), V0, c_null_ptr, c_null_ptr), -force))
        step = p / 100
        values = [(asperity_slip_force(model, p + AT(k) * step, RATES(j), V0, c_null_ptr, c_null_ptr), k=1, 4)]
        call check_close('its slope by load is the secant', by_load, difference(values, step), 1e-6_c_double)
        step = V0 / 200
        values = [(asperity_slip_force(model, p, RATES(j) + AT(k) * step, V0, c_null_ptr, c_null_ptr), k=1, 4)]
        call check_close('... and by slip rate', by_rate, difference(values, step), 1e-6_c_double)
      end do
    end do
    call check('fast slip has the friction of the law', &
               identical(asperity_slip_force(model, 5.0_c_double, 1e90_c_double, V0, c_null_ptr, c_null_ptr), &
                         asperity_friction_force_at_load(model, 5.0_c_double)))
    call check('a transition rate of zero is not allowed', ieee_is_nan( &
               asperity_slip_force(model, 5.0_c_double, 1.0_c_double, 0.0_c_double, c_null_ptr, c_null_ptr)))
    call asperity_free(model)
  end subroutine slip_forces

  ! Batches by pressure, of slip forces and of several models have the numbers of one call a contact.
  subroutine batches_beside_friction
    real(c_double), target :: p(3) = [0.5_c_double, 2.0_c_double, 40.0_c_double]
    real(c_double), target :: v(3) = [-0.1_c_double, 0.0_c_double, 0.3_c_double]
    real(c_double), target :: value(3), slope(3), by_rate(3), by_load, by_slip
    integer(c_int32_t), target :: which(3) = [1_c_int32_t, 0_c_int32_t, 2_c_int32_t]
    type(c_ptr), target :: models(2)
    type(c_ptr) :: model
    real(c_double) :: one
    integer :: i
    model = default_model()
    call asperity_check(asperity_friction_at_pressures(model, 3_c_size_t, c_loc(p), 2.0_c_double, c_loc(value), &
                                                       c_loc(slope)))
    do i = 1, 3
      one = asperity_friction_at_pressure(model, p(i), 2.0_c_double, c_loc(by_load))
      call check('mu at a pressure of many', identical(value(i), one) .and. identical(slope(i), by_load))
    end do
    call asperity_check(asperity_shear_stresses_at_pressures(model, 3_c_size_t, c_loc(p), 2.0_c_double, c_loc(value), &
                                                             c_loc(slope)))
    do i = 1, 3
      one = asperity_shear_stress_at_pressure(model, p(i), 2.0_c_double, c_loc(by_load))
      call check('a stress of many', identical(value(i), one) .and. identical(slope(i), by_load))
    end do
    call asperity_check(asperity_slip_forces(model, 3_c_size_t, c_loc(p), c_loc(v), 0.5_c_double, c_loc(value), &
                                             c_loc(slope), c_loc(by_rate)))
    do i = 1, 3
      one = asperity_slip_force(model, p(i), v(i), 0.5_c_double, c_loc(by_load), c_loc(by_slip))
      call check('a slip force of many', identical(value(i), one) .and. identical(slope(i), by_load) .and. &
                 identical(by_rate(i), by_slip))
    end do
    models = model
    call check('an index of no model is refused', &
               asperity_friction_force_at_loads_of(c_loc(models), 2_c_size_t, 3_c_size_t, c_loc(which), c_loc(p), &
                                                   c_loc(value), c_loc(slope)) == ASPERITY_INVALID_PARAMETER)
    call check('... and its force is NaN', ieee_is_nan(value(3)))
    call check('the others have theirs', identical(value(1), asperity_friction_force_at_load(model, p(1))))
    call asperity_free(model)
  end subroutine batches_beside_friction

  ! The load at a gap, of one and of many, and by the table.
  subroutine gaps
    real(c_double), target :: at(2), load(2), slope(2), one
    type(asperity_state) :: state
    type(asperity_table) :: table
    type(c_ptr) :: model
    model = default_model()
    call asperity_check(asperity_state_at_load(model, 3.0_c_double, state))
    at = [state%gap, 1e6_c_double]
    call check('surfaces apart are reported', &
               asperity_loads_at_gaps(model, 2_c_size_t, c_loc(at), c_loc(load), c_loc(slope)) == ASPERITY_SEPARATED)
    call check_close('the load at a gap', load(1), 3.0_c_double, 1e-8_c_double)
    call check_close('its slope', slope(1), state%dload_dgap, 1e-6_c_double)
    call check('apart there is none', identical(load(2), 0.0_c_double))
    call check('one as many', identical(asperity_load_at_gap(model, at(1)), load(1)))
    call check('with its slope', identical(asperity_load_and_slope_at_gap(model, at(1), c_loc(one)), load(1)))
    call check('... too', identical(one, slope(1)))
    call asperity_check(asperity_load_table_of(model, table))
    call check('the table has rows', table%row_count > 50 .and. -table%pull_off_load > at(1))
    call asperity_free(model)
  end subroutine gaps

  pure function difference(value, step)
    real(c_double), intent(in) :: value(4), step  ! values at -2, -1, 1 and 2 steps
    real(c_double) :: difference
    difference = (8 * (value(3) - value(2)) - (value(4) - value(1))) / (12 * step)
  end function difference

  ! The law from the rows alone, as the header describes them.
  subroutine compiled_table
    type(c_ptr) :: model
    type(asperity_table) :: table
    type(asperity_summary) :: s
    real(c_double), pointer :: rows(:,:)
    real(c_double) :: load
    integer :: i, answered
    model = default_model()
    call asperity_check(asperity_summary_of(model, s))
    call check('struct_size is the size of the type', table%struct_size == c_sizeof(table))
    call asperity_check(asperity_table_of(model, table))
    call check('the layout is the one of the module', table%layout_version == ASPERITY_TABLE_LAYOUT)
    call check('the pull-off load is that of the model', identical(table%pull_off_load, s%pull_off_load))
    call check('the cap is that of the parameters', identical(table%max_friction_coefficient, 1000.0_c_double))
    call check_close('... and its inverse', table%inverse_cap, 1e-3_c_double, 1e-15_c_double)
    call c_f_pointer(table%rows, rows, [8_c_int64_t, table%row_count])
    answered = 0
    do i = 0, 99
      load = 1e-2_c_double * 1.2_c_double**i
      if (.not. is_in(table, load)) cycle
      answered = answered + 1
      call check_close('F is the polynomial of its row', from_row(table, rows, load), &
                       asperity_friction_force_at_load(model, load), 1e-14_c_double)
    end do
    call check('the table answers for most loads', answered > 90)
    call check('beyond its range it does not', .not. is_in(table, 4 * s%max_table_load))
    call check('no table of no model', asperity_table_of(c_null_ptr, table) == ASPERITY_NULL_POINTER)
    table%struct_size = 0
    call check('a table whose size is not set is refused', &
               asperity_table_of(model, table) == ASPERITY_INVALID_PARAMETER)
    call asperity_free(model)
  end subroutine compiled_table

  function row_of(table, load) result(row)
    type(asperity_table), intent(in) :: table
    real(c_double), intent(in) :: load
    integer(c_int64_t) :: row  ! from 0
    row = shiftr(transfer(load - table%pull_off_load, row), table%shift) - table%base
  end function row_of

  function is_in(table, load)
    type(asperity_table), intent(in) :: table
    real(c_double), intent(in) :: load
    logical :: is_in
    is_in = row_of(table, load) >= 0 .and. row_of(table, load) < table%row_count
  end function is_in

  function from_row(table, rows, load) result(force)
    type(asperity_table), intent(in) :: table
    real(c_double), intent(in) :: rows(:,:), load
    real(c_double) :: force, t
    integer(c_int64_t) :: bits
    integer :: k
    bits = transfer(load - table%pull_off_load, bits)
    bits = ior(iand(bits, shiftl(1_c_int64_t, table%shift) - 1), transfer(1.0_c_double, bits))
    t = transfer(bits, t) - 1
    force = sum([(rows(k, row_of(table, load) + 1) * t**(k - 1), k=1, 8)])
  end function from_row

  function default_model() result(model)
    type(c_ptr) :: model
    model = c_null_ptr
    call asperity_check(asperity_create(paper_case(), model))
  end function default_model

  ! Without adhesion, with the shear strength of small contacts everywhere: Greenwood and Williamson's closed forms.
  !   n = N/2 erfc(t/sqrt 2)    A = pi N R sigma (phi(t) - t n/N)    F = tau_1 A    t = d/sigma
  subroutine hertzian_states
    real(c_double), parameter :: T(3) = [-0.5_c_double, 1.0_c_double, 3.0_c_double]
    real(c_double), target :: overlap(3) = [0.1_c_double, 2.0_c_double, 8.0_c_double]
    real(c_double), target :: load(3), radius(3)
    real(c_double) :: fraction, area
    type(asperity_params) :: p
    type(asperity_state) :: state, at_load
    type(asperity_sensitivities) :: sensitivities
    type(c_ptr) :: model
    integer(c_int64_t) :: warnings
    real(c_double), target :: warned(2), memory(42), increment(2), force(2)
    type(asperity_microslip) :: step
    integer :: i
    warnings = 0
    p = paper_case()
    p%work_of_adhesion = 0
    p%hardness = 0.02_c_double
    p%asperity_count = 1000
    p%slip_radius_1 = 1e6_c_double
    p%slip_radius_2 = 1e7_c_double
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    do i = 1, size(T)
      call asperity_check(asperity_state_at_gap(model, T(i) * p%height_std, state))
      fraction = erfc(T(i) / sqrt(2.0_c_double)) / 2
      area = PI * p%asperity_count * p%summit_radius * p%height_std * (normal_density(T(i)) - T(i) * fraction)
      call check_close('n = N/2 erfc(t/sqrt 2)', state%contacting, p%asperity_count * fraction, 1e-10_c_double)
      call check_close('A = pi N R sigma (phi - t Q)', state%real_area, area, 1e-10_c_double)
      call check_close('P = 4/3 N E* R^1/2 sigma^3/2 I', state%load, hertz_load(p, T(i)), 1e-10_c_double)
      call check_close('F = tau_1 A', state%friction_force, p%slip_stress_1 * p%effective_shear_modulus * area, &
                       1e-10_c_double)
      call check('without adhesion nothing attracts', identical(state%attracted, 0.0_c_double))
      call check_close('the mean pressure is P/A', state%mean_asperity_pressure, state%load / area, 1e-10_c_double)
      call check_close('the fraction in contact', state%fraction_in_contact, fraction, 1e-10_c_double)
      call check_close('small contacts everywhere', state%fraction_below_slip_radius_1, 1.0_c_double, 1e-12_c_double)
      call check('... and no others', identical(state%fraction_between_slip_radii, 0.0_c_double) .and. &
                 identical(state%fraction_above_slip_radius_2, 0.0_c_double))
      call check('contacts have a radius', state%mean_contact_radius > 0 .and. &
                 state%max_contact_radius > state%mean_contact_radius)
      call check_close('plasticity index', state%plasticity_index, p%composite_modulus / p%hardness &
                       * sqrt(p%height_std / p%summit_radius), 1e-14_c_double)
      call check('... above 1 warns', iand(state%warnings, ASPERITY_WARNING_PLASTIC) /= 0)
      call asperity_check(asperity_check_loads(model, state%load, state%load, warnings))
      call check('the warnings of one load are those of its state', warnings == state%warnings)
      call check('... and texts have a length', asperity_warnings_text(ASPERITY_WARNING_FEW, c_null_ptr, 0_c_size_t) > 20)
      call asperity_check(asperity_warning_loads(model, ASPERITY_WARNING_PLASTIC, c_loc(warned(1)), c_loc(warned(2))))
      call check('... with the loads at which they hold', warned(1) <= state%load .and. warned(2) >= state%load)
      call check('... and have texts', c_associated(asperity_warning_string(ASPERITY_WARNING_PLASTIC)))
      call asperity_check(asperity_state_at_load(model, state%load, at_load))
      call check_close('the state at that load is the state', at_load%gap, state%gap, 1e-9_c_double)
      call check_close('... and so is its friction', at_load%friction_force, state%friction_force, 1e-9_c_double)
      load(1) = state%load
      call check_close('the stiffness is that of the state', asperity_tangential_stiffness_at_load(model, load(1)), &
                       state%tangential_stiffness, 1e-9_c_double)
      call asperity_check(asperity_tangential_stiffness_at_loads(model, 1_c_size_t, c_loc(load), c_loc(radius)))
      call check('... and so is that of many', identical(radius(1), asperity_tangential_stiffness_at_load(model, load(1))))
      call asperity_check(asperity_contact_radius_sum_at_loads(model, 1_c_size_t, c_loc(load), c_loc(radius), c_null_ptr))
      call check_close('the sum of the radii is that of the state', radius(1), state%contact_radius_sum, 1e-8_c_double)
      call check('... one as many', identical(radius(1), asperity_contact_radius_sum_at_load(model, load(1))))
      call asperity_check(asperity_tangential_at_load(model, load(1), 1e9_c_double, c_loc(radius), c_null_ptr))
      call check_close('far displaced all contacts slip', radius(1), state%friction_force, 1e-9_c_double)
      call check('a contact remembers so many numbers', asperity_microslip_length(model) == size(memory, kind=c_size_t))
      memory = 0
      increment = [1e-3_c_double, 0.0_c_double] * state%friction_force / state%tangential_stiffness
      call asperity_check(asperity_microslip_step(model, load(1), c_loc(increment), c_loc(memory), c_loc(memory), step))
      call check_close('it begins with the stiffness', step%force(1), 1e-3_c_double * state%friction_force, 1e-9_c_double)
      call asperity_check(asperity_microslip_turn(c_loc(memory), 0.0_c_double, -1.0_c_double))
      increment = 1e9_c_double
      call asperity_check(asperity_microslip_steps(model, 1_c_size_t, c_loc(load), c_loc(increment), c_loc(memory), &
                                                   c_null_ptr, c_loc(force), c_null_ptr))
      call check_close('and ends at the friction force', norm2(force), state%friction_force, 1e-9_c_double)
      call asperity_check(asperity_sensitivities_at_load(model, state%load, sensitivities))
      call check_close('F = tau A: E* takes from F what it adds to the load', sensitivities%composite_modulus, &
                       -state%dforce_dload * state%load / state%friction_force, 1e-8_c_double)
      call check_close('F = tau_1 A', sensitivities%slip_stress_1, 1.0_c_double, 1e-12_c_double)
      call check('without adhesion none is read', identical(sensitivities%work_of_adhesion, 0.0_c_double))
    end do
    call check('single summits are evaluated', &
               asperity_summits_at_overlaps(model, 3_c_size_t, c_loc(overlap), c_null_ptr, c_loc(load), c_null_ptr, &
                                            c_loc(radius)) == ASPERITY_OK)
    do i = 1, 3
      call check_close('a^2 = R u', radius(i)**2, p%summit_radius * overlap(i), 1e-13_c_double)
      call check_close('P = 4/3 E* a^3/R', load(i), 4 * p%composite_modulus * radius(i)**3 / (3 * p%summit_radius), &
                       1e-13_c_double)
    end do
    call check('without adhesion there is no contact at negative load', &
               asperity_state_at_load(model, -1.0_c_double, state) == ASPERITY_SEPARATED)
    call asperity_free(model)
  end subroutine hertzian_states

  pure function normal_density(t) result(density)
    real(c_double), intent(in) :: t
    real(c_double) :: density
    density = exp(-t**2 / 2) / sqrt(2 * PI)
  end function normal_density

  ! The integral of (z - t)^(3/2) phi(z), with z = t + s^2, by Simpson's rule.
  pure function hertz_load(p, t) result(load)
    type(asperity_params), intent(in) :: p
    real(c_double), intent(in) :: t
    integer, parameter :: PANELS = 2000
    real(c_double) :: load, s, step
    integer :: i
    step = 4.0_c_double / PANELS
    load = 0
    do i = 1, PANELS
      s = i * step
      load = load + merge(4, 2, mod(i, 2) == 1) * 2 * s**4 * normal_density(t + s**2)
    end do
    load = load * step / 3
    load = 4 * p%asperity_count * p%composite_modulus * sqrt(p%summit_radius) * sqrt(p%height_std)**3 / 3 * load
  end function hertz_load

  subroutine adhesive_summary
    type(asperity_params) :: p
    type(asperity_summary) :: s
    type(asperity_state) :: state
    type(c_ptr) :: model
    p = paper_case()
    model = c_null_ptr
    call asperity_check(asperity_create(p, model))
    call asperity_check(asperity_summary_of(model, s))
    call check('struct_size is the size of the type', s%struct_size == c_sizeof(s) .and. &
               state%struct_size == c_sizeof(state))
    call check_close('alpha', s%alpha, 0.01_c_double, 1e-14_c_double)
    call check_close('beta', s%beta, 1000.0_c_double, 1e-14_c_double)
    call check_close('gamma', s%gamma, 0.001_c_double, 1e-14_c_double)
    call check_close('lambda^3 = 9 beta gamma^2/(2 pi alpha), with b = h', s%lambda**3, &
                     9 * s%beta * s%gamma**2 / (2 * PI * s%alpha), 1e-13_c_double)
    call check('Gaussian heights have no skew', identical(s%skew, 0.0_c_double))
    call check('... and kurtosis 3', identical(s%kurtosis, 3.0_c_double))
    call check('adhesion holds the surfaces at some negative load', s%pull_off_load < 0)
    call check('friction grows from pull-off to zero load', &
               s%pull_off_friction_force > 0 .and. s%zero_load_friction_force > s%pull_off_friction_force)
    call asperity_check(asperity_state_at_load(model, 0.0_c_double, state))
    call check_close('friction at zero load', state%friction_force, s%zero_load_friction_force, &
                     2 * s%table_error + 1e-11_c_double)
    call check('the table covers a range', s%min_table_load < s%max_table_load)
    call check('the table is accurate', s%table_error >= 0 .and. s%table_error < 1e-6_c_double)
    call check('a state whose size is not set is refused', wrong_size_is_refused(model))
    call asperity_free(model)
  end subroutine adhesive_summary

  function wrong_size_is_refused(model) result(refused)
    type(c_ptr), intent(in) :: model
    logical :: refused
    type(asperity_state) :: state
    state%struct_size = 0
    refused = asperity_state_at_load(model, 1.0_c_double, state) == ASPERITY_INVALID_PARAMETER
  end function wrong_size_is_refused

  function nan()
    real(c_double) :: nan
    nan = ieee_value(1.0_c_double, ieee_quiet_nan)
  end function nan

end program c_interface
