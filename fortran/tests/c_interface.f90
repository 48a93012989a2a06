! What the module makes of the C interface for Fortran: strings, names, texts and files, tables of heights, views of rows,
! messages. The numbers themselves are asked by the tests of the library.
program c_interface
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
  use asperity
  use checking
  implicit none

  character(*), parameter :: LF = new_line('a')

  call versions_and_texts
  call default_parameters
  call parameters_by_name
  call names_and_descriptions
  call pairs
  call surface_texts
  call estimates
  call tabulated_heights
  call messages
  call sizes_of_types
  call rows_of_a_table
  call finish('what the module makes of the C interface')

contains

  subroutine versions_and_texts
    character(*), parameter :: DOT = '.'
    character(32) :: version
    call check('the library has the binary interface of the module', &
               asperity_abi_version() == ASPERITY_HEADER_ABI_VERSION)
    write (version, '(i0, a, i0, a, i0)') ASPERITY_VERSION_MAJOR, DOT, ASPERITY_VERSION_MINOR, DOT, &
                                          ASPERITY_VERSION_PATCH
    call check_text('the version is made of its parts', ASPERITY_HEADER_VERSION, trim(version))
    call check_text('the library has the version of the module', asperity_version_text(), ASPERITY_HEADER_VERSION)
    call check_text('a status has a text', asperity_status_text(-1_c_int32_t), 'unknown status')
  end subroutine versions_and_texts

  subroutine default_parameters
    type(asperity_params) :: p
    call check('asperity_params_init succeeds', asperity_params_init(p) == ASPERITY_OK)
    call check('struct_size is the size of the type', p%struct_size == c_sizeof(p))
    call check('no physical input is set', all(ieee_is_nan([p%composite_modulus, p%effective_shear_modulus, &
               p%work_of_adhesion, p%adhesion_range, p%burgers_vector, p%height_std, p%summit_radius, p%asperity_count])))
    call check('integers are where they belong', p%height_distribution == ASPERITY_HEIGHTS_GAUSSIAN .and. p%attraction == 1)
    call check('the last fields are too', identical(p%calibration_error, 0.05_c_double))
    call check('no table', .not. c_associated(p%table_height) .and. .not. c_associated(p%table_density) &
               .and. p%table_length == 0)
  end subroutine default_parameters

  subroutine parameters_by_name
    character(11), parameter :: BODIES(4) = [character(11) :: 'nu2', 'E1', 'nu1', 'E2']
    type(asperity_params) :: p, expected
    character(200) :: message
    integer :: status
    p = paper_case()
    expected = p
    call asperity_check(asperity_params_set_materials(expected, 160e9_c_double, 0.3_c_double, 70e9_c_double, 0.22_c_double))
    call asperity_params_set(p, BODIES, [0.22_c_double, 160e9_c_double, 0.3_c_double, 70e9_c_double])
    call check_close('bodies by name', p%composite_modulus, expected%composite_modulus, 0.0_c_double)
    call asperity_params_set(p, 'hardness ', 3.0_c_double)
    call check_close('a field by name', asperity_params_get(p, 'hardness'), 3.0_c_double, 0.0_c_double)
    call asperity_params_set(p, 'hardnes', 1.0_c_double, status, message)
    call check('an unknown name', status == ASPERITY_INVALID_PARAMETER .and. &
               message == 'hardnes: no parameter has this name; the nearest is hardness')
    call check('... reads as 0', &
               .not. abs(asperity_params_get(p, 'E1', status, message)) > 0 .and. status == ASPERITY_INVALID_PARAMETER)
    call asperity_params_set(p, BODIES, [1.0_c_double], status, message)
    call check('as many numbers as names', message == 'values: must be as many as names')
    call check_close('what is refused changes nothing', p%hardness, 3.0_c_double, 0.0_c_double)
  end subroutine parameters_by_name

  ! The lists end, and all that they name can be asked for.
  subroutine names_and_descriptions
    integer(c_int32_t), parameter :: KINDS(6) = [ASPERITY_NAMES_PARAMETERS, ASPERITY_NAMES_MATERIALS, ASPERITY_NAMES_PAIRS, &
                                                 ASPERITY_NAMES_INTERFACES, ASPERITY_NAMES_WARNINGS, ASPERITY_NAMES_STATUSES]
    character(300) :: message
    integer :: i, k, stat
    do k = 1, size(KINDS)
      i = 1
      do while (asperity_name_text(KINDS(k), i) /= '')
        call check('every name is described', &
                   index(asperity_describe(KINDS(k), asperity_name_text(KINDS(k), i)), 'name = "') == 1)
        i = i + 1
      end do
      call check('there are several', i > 6 .and. asperity_name_text(KINDS(k), 0) == '')
    end do
    call check('blanks behind a name are none of it', &
               asperity_describe(ASPERITY_NAMES_MATERIALS, 'steel  ') == asperity_describe(ASPERITY_NAMES_MATERIALS, 'steel'))
    message = asperity_describe(ASPERITY_NAMES_MATERIALS, 'stel', stat)
    call check('an unknown name has no description', stat == ASPERITY_INVALID_PARAMETER .and. message == '')
    call check('an unknown kind has no names', asperity_name_text(77_c_int32_t, 1) == '')
  end subroutine names_and_descriptions

  subroutine pairs
    type(asperity_params) :: p
    character(200) :: message
    integer :: status
    p = paper_case()
    call asperity_params_set_pair(p, 'Si/Si  ')
    call check_close('blanks behind the name of a pair are none of it', p%burgers_vector, 0.384e-9_c_double, 1e-15_c_double)
    call asperity_params_set_pair(p, 'Si/Is', status, message)
    call check('an unknown body is named', status == ASPERITY_INVALID_PARAMETER .and. index(message, 'Is: ') > 0)
  end subroutine pairs

  ! What a text gives is what the calls set, from a string and from a file.
  subroutine surface_texts
    character(*), parameter :: SURFACE = 'pair = "steel/steel"' // LF // 'contact_law = "elastic-plastic"' // LF // &
      'work_of_adhesion = 0' // LF // 'nominal_area = 1e-4' // LF // 'calibration_load = 1000' // LF // &
      'calibration_friction_coefficient = 0.16' // LF // '[roughness]' // LF // 'm0 = 1e-12' // LF // 'm2 = 0.02' // LF // &
      'm4 = 4e9' // LF
    type(asperity_params) :: p, expected
    character(300) :: path, message
    integer :: unit, stat
    call asperity_check(asperity_params_init(expected))
    call asperity_params_set_pair(expected, 'steel/steel')
    expected%contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC
    expected%work_of_adhesion = 0
    call asperity_check(asperity_params_set_spectral_moments(expected, 1e-12_c_double, 0.02_c_double, 4e9_c_double, &
                                                             1e-4_c_double))
    call asperity_check(asperity_params_calibrate(expected, 1000.0_c_double, 0.16_c_double))

    call asperity_check(asperity_params_init(p))
    call asperity_params_set_text(p, SURFACE)
    ! The strength is that of the text's estimate, whose size effect is not known.
    expected%slip_stress_1 = p%slip_stress_1
    expected%slip_stress_2 = p%slip_stress_2
    expected%pressure_coefficient = p%pressure_coefficient
    call check('an estimate has a size effect', p%slip_stress_2 < p%slip_stress_1 .and. p%slip_stress_2 > p%slip_stress_1 / 30)
    call check_text('a text is what the calls set', asperity_params_text(p), asperity_params_text(expected))
    call asperity_check(asperity_params_init(p))
    call asperity_params_set_text(p, asperity_params_text(expected))
    call check_text('the text that is written is what is read', asperity_params_text(p), asperity_params_text(expected))

    call get_command_argument(0, path)
    path = trim(path) // '.toml'
    open (newunit=unit, file=path, action='write', access='stream', status='replace')
    write (unit) SURFACE
    close (unit)
    call asperity_check(asperity_params_init(p))
    call asperity_params_read(p, path)
    call check_text('so is a file', asperity_params_text(p), asperity_params_text(expected))
    open (newunit=unit, file=path, status='old')
    close (unit, status='delete')
    call asperity_params_read(p, path, stat, message)
    call check('a file that is not there is named', stat == ASPERITY_INVALID_PARAMETER .and. &
               index(message, trim(path) // ': ') == 1)
    call asperity_params_set_text(p, 'hardness = 1' // LF // 'slip_onset = "hole"', stat, message)
    call check('a wrong text is refused', stat == ASPERITY_INVALID_PARAMETER)
    call check_text('... with its line', message, 'line 2: slip_onset = "hole": must be "partial" or "whole"')
    call check_text('... and changes nothing', asperity_params_text(p), asperity_params_text(expected))
    p%contact_law = 7
    message = asperity_params_text(p, stat)
    call check('what has no meaning has no text', stat == ASPERITY_INVALID_PARAMETER .and. message == '')
  end subroutine surface_texts

  ! Friction from a text alone.
  subroutine estimates
    character(*), parameter :: SURFACE = 'pair = "steel/steel"' // LF // 'nominal_area = 1e-4' // LF // &
      'measured = [1000, 0.16]' // LF // '[roughness]' // LF // 'process = "ground"' // LF // 'Ra = 0.8e-6' // LF
    type(asperity_estimate) :: found(2), none(0)
    type(asperity_params) :: params
    character(300) :: message
    integer :: stat
    call asperity_estimate_at_loads(SURFACE, [10.0_c_double, 1000.0_c_double], found)
    call check_close('the measured point is met', found(2)%friction_coefficient, 0.16_c_double, 1e-6_c_double)
    call check('another load has its band', found(1)%low > 0.1 .and. found(1)%low < found(1)%friction_coefficient &
               .and. found(1)%friction_coefficient < found(1)%high .and. found(1)%high < 0.29)
    call check('... and what it rests on', found(1)%strength_source == ASPERITY_STRENGTH_MEASURED)
    call check('so has its text', index(asperity_estimate_text(SURFACE, [10.0_c_double]), &
                                        'mu(10 N) = 0.173, 95 % band 0.108 to 0.279' // LF) == 1)
    call asperity_check(asperity_params_init(params))
    call asperity_params_set_text(params, SURFACE)
    call check('a model of it takes its contact law', params%contact_law == ASPERITY_CONTACT_ELASTIC_PLASTIC)
    call asperity_estimate_at_loads(SURFACE, [real(c_double) ::], none)
    call asperity_estimate_at_loads('measured = 0.16', [1.0_c_double], found, stat, message)
    call check('what is wrong is named', stat == ASPERITY_INVALID_PARAMETER .and. &
               index(message, 'line 1: measured = 0.16: must be points') == 1)
    message = asperity_estimate_text('', [1.0_c_double], stat)
    call check('... and has no text', stat == ASPERITY_INVALID_PARAMETER .and. message == '')
  end subroutine estimates

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

  subroutine messages
    type(asperity_params) :: p
    character(kind=c_char), target :: few(6)
    integer(c_size_t) :: length
    call check('parameters of no model', asperity_get_params(c_null_ptr, p) == ASPERITY_NULL_POINTER)
    length = asperity_last_error(c_null_ptr, 0_c_size_t)
    call check('the length of the message without a buffer', length == len(asperity_error_message()))
    call check('a short buffer does not change the length', asperity_last_error(c_loc(few), 6_c_size_t) == length)
    call check('a message is cut to fit and ended', few(5) == 'l' .and. few(6) == c_null_char)
    call check('mu of no model is NaN', ieee_is_nan(asperity_friction_at_load(c_null_ptr, 1.0_c_double)))
  end subroutine messages

  ! Types that the library fills say their size themselves, and it is looked at.
  subroutine sizes_of_types
    type(asperity_state) :: state
    type(asperity_summary) :: summary
    type(asperity_table) :: table
    type(c_ptr) :: model
    model = c_null_ptr
    call asperity_check(asperity_create(paper_case(), model))
    call asperity_check(asperity_state_at_load(model, 1.0_c_double, state))
    call asperity_check(asperity_summary_of(model, summary))
    call check_close('K_t over the sum of the radii', state%tangential_stiffness / state%contact_radius_sum, &
                     summary%stiffness_per_radius, 1e-12_c_double)
    state%struct_size = 0
    call check('a state whose size is not set is refused', &
               asperity_state_at_load(model, 1.0_c_double, state) == ASPERITY_INVALID_PARAMETER)
    table%struct_size = 0
    call check('... and a table', asperity_table_of(model, ASPERITY_TABLE_FRICTION, table) == ASPERITY_INVALID_PARAMETER)
    call asperity_free(model)
  end subroutine sizes_of_types

  ! The law from the rows alone, as the header describes them.
  subroutine rows_of_a_table
    type(c_ptr) :: model
    type(asperity_table) :: table
    real(c_double), pointer :: rows(:,:)
    real(c_double) :: load
    integer :: i, answered
    model = c_null_ptr
    call asperity_check(asperity_create(paper_case(), model))
    call asperity_check(asperity_table_of(model, ASPERITY_TABLE_FRICTION, table))
    call check('the layout is the one of the module', table%layout_version == ASPERITY_TABLE_LAYOUT)
    call c_f_pointer(table%rows, rows, [8_c_int64_t, table%row_count])
    answered = 0
    do i = 0, 99
      load = 1e-2_c_double * 1.2_c_double**i
      if (row_of(table, load) < 0 .or. row_of(table, load) >= table%row_count) cycle
      answered = answered + 1
      call check_close('F is the polynomial of its row', from_row(table, rows, load), &
                       asperity_friction_force_at_load(model, load), 1e-14_c_double)
    end do
    call check('the table answers for most loads', answered > 90)
    call asperity_free(model)
  end subroutine rows_of_a_table

  function row_of(table, load) result(row)
    type(asperity_table), intent(in) :: table
    real(c_double), intent(in) :: load
    integer(c_int64_t) :: row  ! from 0
    row = shiftr(transfer(load - table%pull_off_load, row), table%shift) - table%base
  end function row_of

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

end program c_interface
