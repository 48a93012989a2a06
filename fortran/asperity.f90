! asperity: friction laws from contact physics, callable from any solver. Fortran 2008.
!
! The first part is the C interface of include/asperity.h under its own names, argument by argument. The second part,
! type(friction_model), is what most programs use: it frees itself, takes scalars and arrays, and reports errors the
! Fortran way, by stat= and errmsg=, or by stopping with the message where stat= is absent.
!
! Units: one consistent system of the caller's choice. Loads, forces and areas are totals over asperity_count summits.
! Threads: a model may be shared by all calls that take it intent(in); not while it is changed or freed.
! Two C constants have the names of functions, which Fortran does not tell apart; here they are
! ASPERITY_HEADER_VERSION and ASPERITY_HEADER_ABI_VERSION. A C function that takes the size of a struct has in its place a
! function of this module, which passes it.
module asperity
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int32_t, c_int64_t, c_loc, &
                                         c_null_char, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  private

  ! ---- The C interface: constants ----

  character(*), parameter, public :: ASPERITY_HEADER_VERSION = '0.1.0'
  integer(c_int32_t), parameter, public :: ASPERITY_VERSION_MAJOR = 0
  integer(c_int32_t), parameter, public :: ASPERITY_VERSION_MINOR = 1
  integer(c_int32_t), parameter, public :: ASPERITY_VERSION_PATCH = 0
  integer(c_int32_t), parameter, public :: ASPERITY_HEADER_ABI_VERSION = 1  ! compare with asperity_abi_version()

  integer(c_int32_t), parameter, public :: ASPERITY_OK = 0
  integer(c_int32_t), parameter, public :: ASPERITY_NULL_POINTER = 1
  integer(c_int32_t), parameter, public :: ASPERITY_INVALID_PARAMETER = 2
  integer(c_int32_t), parameter, public :: ASPERITY_INVALID_LOAD = 3     ! NaN or infinite
  integer(c_int32_t), parameter, public :: ASPERITY_SEPARATED = 4        ! load below the pull-off load
  integer(c_int32_t), parameter, public :: ASPERITY_OUT_OF_RANGE = 5     ! finite, but beyond what can be evaluated
  integer(c_int32_t), parameter, public :: ASPERITY_NOT_CONVERGED = 6
  integer(c_int32_t), parameter, public :: ASPERITY_OUT_OF_MEMORY = 7    ! nothing was made or changed
  integer(c_int32_t), parameter, public :: ASPERITY_INTERNAL = 255       ! a bug in the library

  integer(c_int32_t), parameter, public :: ASPERITY_HEIGHTS_GAUSSIAN = 0
  integer(c_int32_t), parameter, public :: ASPERITY_HEIGHTS_WEIBULL = 1
  integer(c_int32_t), parameter, public :: ASPERITY_HEIGHTS_JOHNSON = 2
  integer(c_int32_t), parameter, public :: ASPERITY_HEIGHTS_TABULATED = 3

  integer(c_int32_t), parameter, public :: ASPERITY_CONTACT_MAUGIS = 0           ! elastic, with adhesion
  integer(c_int32_t), parameter, public :: ASPERITY_CONTACT_ELASTIC_PLASTIC = 1  ! summits yield; needs hardness, no adhesion

  integer(c_int32_t), parameter, public :: ASPERITY_SLIP_PARTIAL = 0             ! contacts slip from their rims inwards
  integer(c_int32_t), parameter, public :: ASPERITY_SLIP_WHOLE = 1               ! ... all at once

  ! Bits of warnings; asperity_warning_text tells what to do about each.
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_PLASTIC = 1  ! summits yield, the contact law is elastic
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_CROWDED = 2  ! summits do not act independently
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_STEEP = 4    ! contacts too large for their summits
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_ATOMIC = 8   ! contacts too small for continuum mechanics
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_FEW = 16     ! fewer than 20 contacts: averages are not reliable
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_ADHESIVE = 32 ! adhesion presses with more than the load
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_UNCALIBRATED = 64 ! the strength is the default, not a measured one
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_BROAD = 128 ! a bandwidth above 6
  integer(c_int64_t), parameter, public :: ASPERITY_WARNING_STRONG = 256 ! stronger than the softer body

  integer(c_int32_t), parameter, public :: ASPERITY_TABLE_LAYOUT = 1     ! compare with asperity_table%layout_version

  ! ---- The C interface: types ----

  ! Two rough elastic surfaces, as the equivalent rough surface against a flat. Start from asperity_params_of, or from
  ! asperity_params_init.
  type, bind(c), public :: asperity_params
    integer(c_int64_t) :: struct_size = 0         ! set by asperity_params_init
    real(c_double) :: composite_modulus           ! E* [stress], > 0
    real(c_double) :: effective_shear_modulus     ! G* [stress], > 0
    real(c_double) :: work_of_adhesion            ! w [force/length], >= 0; 0 is Hertzian contact
    real(c_double) :: adhesion_range              ! h [length], > 0
    real(c_double) :: burgers_vector              ! b [length], > 0
    real(c_double) :: height_std                  ! sigma [length], > 0: standard deviation of summit heights
    real(c_double) :: summit_radius               ! R [length], > 0: mean radius of the summits
    real(c_double) :: asperity_count              ! N [-], > 0: summit density times nominal area; need not be an integer
    integer(c_int32_t) :: height_distribution     ! one of ASPERITY_HEIGHTS_
    integer(c_int32_t) :: attraction              ! 1: summits out of contact attract; 0: they do not
    real(c_double) :: weibull_shape               ! omega [-], 1 to 200; read only for ASPERITY_HEIGHTS_WEIBULL
    real(c_double) :: radius_amplitude            ! epsilon [-], -1 to 1: how much the radius grows with height
    real(c_double) :: radius_rate                 ! rho [-], > 0: how fast it does
    real(c_double) :: slip_radius_1               ! a_1/b [-], >= 1: shear strength is slip_stress_1 up to this radius
    real(c_double) :: slip_stress_1               ! tau_1/G* [-], > 0 and at most 1; 0 where kappa > 0
    real(c_double) :: slip_radius_2               ! a_2/b [-], > slip_radius_1: it is slip_stress_2 from this one on
    real(c_double) :: slip_stress_2               ! tau_2/G* [-], > 0 and at most 1; 0 where kappa > 0
    real(c_double) :: max_friction_coefficient    ! cap on every coefficient returned [-], > 0; infinity allowed
    real(c_double) :: skew                        ! of the heights [-]; read only for ASPERITY_HEIGHTS_JOHNSON
    real(c_double) :: kurtosis                    ! of the heights [-], 1.87 + 1.25 skew**2 to 100; likewise
    real(c_double) :: hardness                    ! H [stress], to judge whether contacts are elastic; 0: not known
    type(c_ptr) :: table_height = c_null_ptr      ! table_length real(c_double), increasing: heights in any unit and
                                                  ! from any origin; read only for ASPERITY_HEIGHTS_TABULATED
    type(c_ptr) :: table_density = c_null_ptr     ! as many, >= 0: the density at each, of any scale
    integer(c_int64_t) :: table_length = 0        ! 3 to 256
    real(c_double) :: tangential_modulus          ! G^ [stress], >= 0: 1/G^ = (2 - nu1)/G1 + (2 - nu2)/G2; 0 is
                                                  ! E* G* / (2 (E* + G*))
    real(c_double) :: nominal_area                ! [length^2], >= 0: what warnings compare the real area with; 0: not known
    integer(c_int32_t) :: contact_law             ! one of ASPERITY_CONTACT_
    integer(c_int32_t) :: slip_onset              ! one of ASPERITY_SLIP_: how a contact begins to slip
    real(c_double) :: pressure_coefficient        ! kappa [-], >= 0: a contact's friction is pi a**2 tau(a) + kappa P_H, P_H
                                                  ! the load of Hertz' contact of its radius; 0: strength does not grow
    real(c_double) :: bandwidth                   ! Nayak's m0 m4/m2**2 of the surface [-], >= 1.5; 0: not known
    real(c_double) :: calibration_load            ! of the measurement that set the strength [force]; 0 if there was none
    real(c_double) :: calibration_friction_force  ! measured at that load [force]; 0: not calibrated
    real(c_double) :: calibration_error           ! its relative standard error [-], > 0 and at most 1
  end type asperity_params

  ! The exact state of the contact, in the units of the parameters.
  type, bind(c), public :: asperity_state
    integer(c_int64_t) :: struct_size = 224       ! bytes of this type; leave it
    real(c_double) :: load                        ! P [force]; negative pulls
    real(c_double) :: separation                  ! d [length], flat to mean of the summit heights
    real(c_double) :: friction_force              ! F [force]
    real(c_double) :: friction_coefficient        ! F/P [-], capped
    real(c_double) :: dforce_dload                ! dF/dP [-]; infinity at the pull-off load itself
    real(c_double) :: dmu_dload                   ! d(F/P)/dP [1/force]; 0 where the coefficient is capped
    real(c_double) :: dload_dseparation           ! dP/dd [force/length]: minus the contact stiffness
    real(c_double) :: real_area                   ! real area of contact [length^2]
    real(c_double) :: contacting                  ! number of summits in contact
    real(c_double) :: attracted                   ! number of summits that attract without contact
    real(c_double) :: attraction_load             ! part of the load carried by those [force], <= 0
    real(c_double) :: mean_contact_radius         ! mean radius of the contacts [length]; 0 without contacts
    real(c_double) :: max_contact_radius          ! expected radius of the largest contact [length]; not below the mean
    real(c_double) :: fraction_below_slip_radius_1 ! fraction of the contacts up to slip_radius_1 [-]
    real(c_double) :: fraction_between_slip_radii ! fraction of the contacts between the two [-]
    real(c_double) :: fraction_above_slip_radius_2 ! fraction of the contacts from slip_radius_2 on [-]
    real(c_double) :: fraction_in_contact         ! fraction of the summits [-]
    real(c_double) :: mean_asperity_pressure      ! load of the summits in contact over the real area [stress]
    real(c_double) :: plasticity_index            ! E* (sigma/R)**0.5/H [-]; 0 where hardness is not given
    integer(c_int64_t) :: warnings                ! bits ASPERITY_WARNING_; 0 if nothing is known to fail
    real(c_double) :: tangential_stiffness        ! K_t [force/length], while all contacts stick
    real(c_double) :: fraction_elastic            ! fraction of the contacts below first yield [-]
    real(c_double) :: fraction_flowing            ! fraction of the contacts that are fully plastic [-]
    real(c_double) :: contact_radius_sum          ! sum of the radii of all contacts [length]
    real(c_double) :: hertz_load                  ! sum of the loads of Hertz' contacts of the same radii [force]
    real(c_double) :: friction_scatter            ! standard deviation over mean of F among nominally equal contacts [-];
                                                  ! 0 if asperity_count is 1
    real(c_double) :: friction_bias               ! mean F of those over friction_force, less 1 [-]; 0 if asperity_count is 1
  end type asperity_state

  ! What resists a displacement in a step of a contact that remembers.
  type, bind(c), public :: asperity_microslip
    integer(c_int64_t) :: struct_size = 88        ! bytes of this type; leave it
    real(c_double) :: force(2)                    ! T [force], along both directions
    real(c_double) :: stiffness(4)                ! dT/d(increment) [force/length], symmetric: 11, 12, 21, 22
    real(c_double) :: dforce_dload(2)             ! dT/d(load) [-]
    real(c_double) :: dissipated                  ! work that slip turned into heat in the step [force length], >= 0
    real(c_double) :: slipping                    ! fraction of the strength that slips [-]; 1 is gross slip
  end type asperity_microslip

  ! Constants of a model, in the units of the parameters.
  type, bind(c), public :: asperity_summary
    integer(c_int64_t) :: struct_size = 104       ! bytes of this type; leave it
    real(c_double) :: alpha                       ! (sigma/R)^(1/2) [-]
    real(c_double) :: beta                        ! (R sigma)^(1/2)/b [-]
    real(c_double) :: gamma                       ! w/(E* b) [-]
    real(c_double) :: lambda                      ! Maugis' adhesion parameter [-]
    real(c_double) :: skew                        ! of the summit heights [-]
    real(c_double) :: kurtosis                    ! of the summit heights [-]; 3 for Gaussian
    real(c_double) :: pull_off_load               ! the least load that holds the surfaces together [force], <= 0
    real(c_double) :: pull_off_friction_force     ! F there [force]
    real(c_double) :: zero_load_friction_force    ! F at zero load [force]
    real(c_double) :: min_table_load              ! the lightest load of the compiled law [force]
    real(c_double) :: max_table_load              ! the heaviest load of the compiled law [force]
    real(c_double) :: table_error                 ! largest relative error at samples; between, up to 4 times that, or 2e-10 [-]
  end type asperity_summary

  ! A read-only view of the compiled law, for code that cannot call the library. A row is a polynomial of degree 7 in t
  ! for a piece of a binade of x = load - pull_off_load. From the bits of x, as integers: its index, from 0, is
  ! shiftr(bits, shift) - base, and the table does not answer where that is not in 0 to row_count - 1; t + 1 has the
  ! bits of x below `shift` as its mantissa. It gives F; its derivative by t, over 2^(exponent of x), is dF/d(load). A
  ! row whose first coefficient is NaN is a link to its parts, or left out, as asperity.h says.
  type, bind(c), public :: asperity_table
    integer(c_int64_t) :: struct_size = 120       ! bytes of this type; leave it
    type(c_ptr) :: rows = c_null_ptr              ! total_count rows of 8 real(c_double): rows(8, total_count) in Fortran
    integer(c_int64_t) :: row_count               ! number of rows
    integer(c_int64_t) :: base                    ! shifted bits of x at which the first row begins
    integer(c_int32_t) :: shift                   ! how far the bits of x are shifted
    integer(c_int32_t) :: layout_version          ! ASPERITY_TABLE_LAYOUT
    real(c_double) :: pull_off_load               ! the pull-off load [force]
    real(c_double) :: max_friction_coefficient    ! cap on the friction coefficient [-]
    real(c_double) :: inverse_cap                 ! loads up to this times F have the capped coefficient
    integer(c_int64_t) :: total_count             ! number of rows and their parts
    real(c_double) :: pull_off_force              ! friction force at the pull-off load [force]
    real(c_double) :: light_slope                 ! of the straight line from there to the first row
    real(c_double) :: zero_force                  ! friction force at zero load [force]
    real(c_double) :: zero_slope                  ! and its slope
    real(c_double) :: separated_slope             ! dF/d(load) below the pull-off load
    real(c_double) :: heavy_force                 ! friction force of loads beyond the last row [force]
  end type asperity_table

  ! What the friction force F at constant load changes by with each parameter p: d(ln F)/d(ln p), but d(ln F)/dp for
  ! radius_amplitude, skew and pressure_coefficient [-]. 0 for a parameter that the model does not read.
  type, bind(c), public :: asperity_sensitivities
    integer(c_int64_t) :: struct_size = 160       ! bytes of this type; leave it
    real(c_double) :: composite_modulus           ! to E*
    real(c_double) :: effective_shear_modulus     ! to G*: 1
    real(c_double) :: work_of_adhesion            ! to w; 0 where w is 0
    real(c_double) :: adhesion_range              ! to h; 0 where w is 0
    real(c_double) :: burgers_vector              ! to b; the slip radii grow with it
    real(c_double) :: height_std                  ! to sigma
    real(c_double) :: summit_radius               ! to R
    real(c_double) :: asperity_count              ! to N
    real(c_double) :: weibull_shape               ! to omega; 0 unless heights are Weibull's
    real(c_double) :: radius_amplitude            ! to epsilon: d(ln F)/d(epsilon)
    real(c_double) :: radius_rate                 ! to rho; 0 where epsilon is 0
    real(c_double) :: slip_radius_1               ! to a_1/b
    real(c_double) :: slip_stress_1               ! to tau_1/G*
    real(c_double) :: slip_radius_2               ! to a_2/b
    real(c_double) :: slip_stress_2               ! to tau_2/G*
    real(c_double) :: skew                        ! d(ln F)/d(skew) at this kurtosis; 0 unless heights are Johnson's
    real(c_double) :: kurtosis                    ! at this skew; 0 unless heights are Johnson's
    real(c_double) :: hardness                    ! to H; 0 where contacts are elastic
    real(c_double) :: pressure_coefficient        ! d(ln F)/d(kappa), also where kappa is 0
  end type asperity_sensitivities

  ! What is known of a material, in SI units; 0 is what no source is known for.
  type, bind(c), public :: asperity_material_data
    integer(c_int64_t) :: struct_size = 88        ! bytes of this type; leave it
    real(c_double) :: young                       ! Young's modulus [Pa]
    real(c_double) :: young_low                   ! the least published value [Pa]
    real(c_double) :: young_high                  ! the largest published value [Pa]
    real(c_double) :: poisson                     ! Poisson's ratio [-]
    real(c_double) :: hardness                    ! indentation hardness [Pa]
    real(c_double) :: hardness_low                ! the least published value [Pa]
    real(c_double) :: hardness_high               ! the largest published value [Pa]
    real(c_double) :: burgers_vector              ! [m]; of a glass the distance of like atoms
    type(c_ptr) :: name = c_null_ptr              ! a C string; asperity_material_name_text gives it as characters
    type(c_ptr) :: reference = c_null_ptr         ! a C string: where the numbers are from
  end type asperity_material_data

  ! What is known of two bodies in contact, in SI units; 0 is what no source is known for.
  type, bind(c), public :: asperity_pair_data
    integer(c_int64_t) :: struct_size = 64        ! bytes of this type; leave it
    real(c_double) :: work_of_adhesion            ! w [J/m^2]
    real(c_double) :: work_of_adhesion_low        ! the least measurement or estimate [J/m^2]
    real(c_double) :: work_of_adhesion_high       ! the largest measurement or estimate [J/m^2]
    real(c_double) :: hamaker                     ! the Hamaker constant that w is estimated from [J]
    real(c_double) :: slip_stress_1               ! measured shear strength of small contacts over G* [-]
    type(c_ptr) :: name = c_null_ptr              ! a C string; asperity_pair_name_text gives it as characters
    type(c_ptr) :: reference = c_null_ptr         ! a C string: where w and the strength are from
  end type asperity_pair_data

  ! What was measured of the strength of an interface, in SI units; 0 is what no source is known for.
  type, bind(c), public :: asperity_interface_data
    integer(c_int64_t) :: struct_size = 72        ! bytes of this type; leave it
    real(c_double) :: shear_strength              ! tau_0 [Pa] at no pressure; 0: only a friction coefficient is known
    real(c_double) :: pressure_coefficient        ! kappa [-]; 0 if it is not known
    real(c_double) :: friction_coefficient        ! of many contacts [-], where the strength of one is not known
    real(c_double) :: load                        ! the lightest load of that measurement [N]; 0 if it is not known
    type(c_ptr) :: name = c_null_ptr              ! a C string; asperity_interface_name_text gives it as characters
    type(c_ptr) :: conditions = c_null_ptr        ! a C string: bodies, film, surroundings, loads
    type(c_ptr) :: source = c_null_ptr            ! a C string: read in the reference, or quoted
    type(c_ptr) :: reference = c_null_ptr         ! a C string: where the numbers are from
  end type asperity_interface_data

  ! ---- The C interface: functions ----
  ! A model is a type(c_ptr). All functions of type integer(c_int32_t) return a status.

  interface
    ! The binary interface of the library loaded.
    function asperity_abi_version() result(version) bind(c)
      import :: c_int32_t
      integer(c_int32_t) :: version
    end function asperity_abi_version

    ! The version of the library loaded: a C string; asperity_version_text() is the Fortran one.
    function asperity_version() result(version) bind(c)
      import :: c_ptr
      type(c_ptr) :: version
    end function asperity_version

    ! What a status means: a C string; asperity_status_text() is the Fortran one.
    function asperity_status_string(status) result(text) bind(c)
      import :: c_int32_t, c_ptr
      integer(c_int32_t), intent(in), value :: status
      type(c_ptr) :: text
    end function asperity_status_string

    ! Copies this thread's last message out; asperity_error_message() is the Fortran way.
    function asperity_last_error(buffer, length) result(whole_length) bind(c)
      import :: c_ptr, c_size_t
      type(c_ptr), intent(in), value :: buffer            ! receives `length` bytes at most; c_null_ptr: only ask
      integer(c_size_t), intent(in), value :: length
      integer(c_size_t) :: whole_length                   ! of the message, without its final NUL
    end function asperity_last_error

    ! Defaults for all but the eight physical inputs, which are left unset.
    function asperity_params_init_c(params, struct_size) result(status) bind(c, name='asperity_params_init')
      import :: asperity_params, c_int32_t, c_size_t
      type(asperity_params), intent(inout) :: params      ! untouched on failure
      integer(c_size_t), intent(in), value :: struct_size ! c_sizeof(params)
      integer(c_int32_t) :: status
    end function asperity_params_init_c

    ! Sets material, adhesion and roughness from the paper's groups; loads are then P/(N G b^2).
    function asperity_params_set_dimensionless(params, alpha, beta, gamma, b_over_h, poisson) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      real(c_double), intent(in), value :: alpha          ! (sigma/R)^(1/2) > 0
      real(c_double), intent(in), value :: beta           ! (R sigma)^(1/2)/b > 0
      real(c_double), intent(in), value :: gamma          ! w/(E* b) >= 0
      real(c_double), intent(in), value :: b_over_h       ! > 0, typically 1
      real(c_double), intent(in), value :: poisson        ! above -1, at most 0.5
      integer(c_int32_t) :: status
    end function asperity_params_set_dimensionless

    ! Sets E* and G* from Young's modulus [stress] and Poisson's ratio of the two bodies; E1 or E2 may be infinite.
    function asperity_params_set_materials(params, E1, nu1, E2, nu2) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      real(c_double), intent(in), value :: E1, nu1, E2, nu2
      integer(c_int32_t) :: status
    end function asperity_params_set_materials

    ! Sets height_std, summit_radius and asperity_count from the profiles of an isotropic Gaussian surface; the moments
    ! of two surfaces add. m0 m4/m2**2 is at least 1.5.
    function asperity_params_set_spectral_moments(params, m0, m2, m4, nominal_area) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      real(c_double), intent(in), value :: m0             ! variance of the heights [length^2]
      real(c_double), intent(in), value :: m2             ! variance of the slopes [-]
      real(c_double), intent(in), value :: m4             ! variance of the curvatures [1/length^2]
      real(c_double), intent(in), value :: nominal_area   ! [length^2]
      integer(c_int32_t) :: status
    end function asperity_params_set_spectral_moments

    ! As asperity_params_set_spectral_moments, with the heights and radii of Nayak's joint distribution: also sets
    ! Johnson's heights, radius_amplitude and radius_rate.
    function asperity_params_set_nayak_summits(params, m0, m2, m4, nominal_area) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      real(c_double), intent(in), value :: m0             ! variance of the heights [length^2]
      real(c_double), intent(in), value :: m2             ! variance of the slopes [-]
      real(c_double), intent(in), value :: m4             ! variance of the curvatures [1/length^2]
      real(c_double), intent(in), value :: nominal_area   ! [length^2]
      integer(c_int32_t) :: status
    end function asperity_params_set_nayak_summits

    ! Chooses Weibull heights with this skew, above -1.13955.
    function asperity_params_set_skew(params, skew) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      real(c_double), intent(in), value :: skew
      integer(c_int32_t) :: status
    end function asperity_params_set_skew

    ! Sets one parameter by its name, which ends in c_null_char; asperity_params_set takes names of Fortran.
    function asperity_params_set_value(params, name, value) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t, c_ptr
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      type(c_ptr), intent(in), value :: name              ! c_loc of its characters
      real(c_double), intent(in), value :: value
      integer(c_int32_t) :: status
    end function asperity_params_set_value

    ! Sets parameters by their names, all or none; asperity_params_set takes names of Fortran.
    function asperity_params_set_values(params, count, names, values) result(status) bind(c)
      import :: asperity_params, c_int32_t, c_ptr, c_size_t
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      integer(c_size_t), intent(in), value :: count
      type(c_ptr), intent(in), value :: names             ! c_loc of count c_ptr, each to characters
      type(c_ptr), intent(in), value :: values            ! c_loc of count real(c_double)
      integer(c_int32_t) :: status
    end function asperity_params_set_values

    ! Reads one parameter by its name, which ends in c_null_char; asperity_params_get takes names of Fortran.
    function asperity_params_get_value(params, name, value) result(status) bind(c)
      import :: asperity_params, c_int32_t, c_ptr
      type(asperity_params), intent(in) :: params         ! initialised
      type(c_ptr), intent(in), value :: name              ! c_loc of its characters
      type(c_ptr), intent(in), value :: value             ! c_loc of a real(c_double); untouched on failure
      integer(c_int32_t) :: status
    end function asperity_params_get_value

    ! The names of the parameters that are one number, index from 0; asperity_params_name_text gives it as characters.
    function asperity_params_name(index) result(name) bind(c)
      import :: c_ptr, c_size_t
      integer(c_size_t), intent(in), value :: index
      type(c_ptr) :: name                                 ! c_null_ptr after the last
    end function asperity_params_name

    ! A material by its name, which ends in c_null_char; asperity_material_of takes names of Fortran.
    function asperity_material(name, material) result(status) bind(c)
      import :: asperity_material_data, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: name              ! c_loc of its characters
      type(asperity_material_data), intent(inout) :: material ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_material

    ! The names of the materials, index from 0; asperity_material_name_text gives it as characters.
    function asperity_material_name(index) result(name) bind(c)
      import :: c_ptr, c_size_t
      integer(c_size_t), intent(in), value :: index
      type(c_ptr) :: name                                 ! c_null_ptr after the last
    end function asperity_material_name

    ! A pair by its name, which ends in c_null_char; asperity_pair_of takes names of Fortran.
    function asperity_pair(name, pair) result(status) bind(c)
      import :: asperity_pair_data, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: name              ! c_loc of its characters
      type(asperity_pair_data), intent(inout) :: pair     ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_pair

    ! The names of the pairs, index from 0; asperity_pair_name_text gives it as characters.
    function asperity_pair_name(index) result(name) bind(c)
      import :: c_ptr, c_size_t
      integer(c_size_t), intent(in), value :: index
      type(c_ptr) :: name                                 ! c_null_ptr after the last
    end function asperity_pair_name

    ! Sets all that a pair of materials tells; the name ends in c_null_char. asperity_params_use_pair takes names of Fortran.
    function asperity_params_set_pair(params, name) result(status) bind(c)
      import :: asperity_params, c_int32_t, c_ptr
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      type(c_ptr), intent(in), value :: name              ! c_loc of its characters
      integer(c_int32_t) :: status
    end function asperity_params_set_pair

    ! An interface by its name, which ends in c_null_char; asperity_interface_of takes names of Fortran.
    function asperity_interface(name, data) result(status) bind(c)
      import :: asperity_interface_data, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: name              ! c_loc of its characters
      type(asperity_interface_data), intent(inout) :: data ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_interface

    ! The names of the interfaces, index from 0, c_null_ptr after the last; asperity_interface_name_text gives it as characters.
    function asperity_interface_name(index) result(name) bind(c)
      import :: c_ptr, c_size_t
      integer(c_size_t), intent(in), value :: index
      type(c_ptr) :: name
    end function asperity_interface_name

    ! Sets the measured strength of an interface, in SI units; the name ends in c_null_char. asperity_params_use_interface takes
    ! names of Fortran.
    function asperity_params_set_interface(params, name) result(status) bind(c)
      import :: asperity_params, c_int32_t, c_ptr
      type(asperity_params), intent(inout) :: params      ! whose bodies are set, in SI units; untouched on failure
      type(c_ptr), intent(in), value :: name              ! c_loc of its characters
      integer(c_int32_t) :: status
    end function asperity_params_set_interface

    ! Chooses summits that yield: sets contact_law, hardness, and work_of_adhesion to 0.
    function asperity_params_set_elastic_plastic(params, hardness) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! initialised; untouched on failure
      real(c_double), intent(in), value :: hardness       ! of the softer body [stress], > 0
      integer(c_int32_t) :: status
    end function asperity_params_set_elastic_plastic

    ! Scales slip_stress_1 and slip_stress_2 by one factor, so that the friction coefficient at this load is the one that was
    ! measured. Call it last, with the surfaces of the measurement; pressure_coefficient stays as it is.
    function asperity_params_calibrate(params, load, friction_coefficient) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! all set; untouched on failure
      real(c_double), intent(in), value :: load           ! of the measurement [force], > 0, a total over asperity_count
      real(c_double), intent(in), value :: friction_coefficient ! measured at that load [-], > 0 and at most 20
      integer(c_int32_t) :: status
    end function asperity_params_calibrate

    ! The same from a friction force, for measurements at zero load, or where the load pulls.
    function asperity_params_calibrate_force(params, load, friction_force) result(status) bind(c)
      import :: asperity_params, c_double, c_int32_t
      type(asperity_params), intent(inout) :: params      ! all set; untouched on failure
      real(c_double), intent(in), value :: load           ! of the measurement [force], a total over asperity_count
      real(c_double), intent(in), value :: friction_force ! measured at that load [force], > 0
      integer(c_int32_t) :: status
    end function asperity_params_calibrate_force

    ! Makes a model; free it with asperity_free.
    function asperity_create(params, model) result(status) bind(c)
      import :: asperity_params, c_int32_t, c_ptr
      type(asperity_params), intent(in) :: params
      type(c_ptr), intent(inout) :: model                 ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_create

    ! Gives a model other parameters, all or nothing.
    function asperity_set_params(model, params) result(status) bind(c)
      import :: asperity_params, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      type(asperity_params), intent(in) :: params
      integer(c_int32_t) :: status
    end function asperity_set_params

    ! Copies the parameters of a model.
    function asperity_get_params_c(model, params) result(status) bind(c, name='asperity_get_params')
      import :: asperity_params, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      type(asperity_params), intent(inout) :: params      ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_get_params_c

    ! Frees a model, once; c_null_ptr is fine.
    subroutine asperity_free(model) bind(c)
      import :: c_ptr
      type(c_ptr), intent(in), value :: model
    end subroutine asperity_free

    ! Friction coefficient [-] at a load [force]; NaN for a load that is not finite, or for c_null_ptr.
    pure function asperity_friction_at_load(model, load) result(mu) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      real(c_double) :: mu
    end function asperity_friction_at_load

    ! Friction force [force] at a load [force]; NaN for a load that is not finite, or for c_null_ptr.
    pure function asperity_friction_force_at_load(model, load) result(force) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      real(c_double) :: force
    end function asperity_friction_force_at_load

    ! Friction coefficients at many loads, and their slopes. Every element is filled, then the first invalid one reported.
    function asperity_friction_at_loads(model, n, load, mu, dmu_dload) result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: load              ! n real(c_double) [force]
      type(c_ptr), intent(in), value :: mu                ! receives n real(c_double) [-]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dmu_dload         ! receives n real(c_double) [1/force]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_friction_at_loads

    ! Friction forces at many loads, and their slopes. Every element is filled, then the first invalid one reported.
    function asperity_friction_force_at_loads(model, n, load, force, dforce_dload) result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: load              ! n real(c_double) [force]
      type(c_ptr), intent(in), value :: force             ! receives n real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dforce_dload      ! receives n real(c_double) [-]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_friction_force_at_loads

    ! Tangential stiffness [force/length] at a load [force]: force by displacement while all contacts stick.
    function asperity_tangential_stiffness_at_load(model, load) result(stiffness) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      real(c_double) :: stiffness
    end function asperity_tangential_stiffness_at_load

    ! Tangential stiffnesses at many loads. Every element is filled, then the first invalid one reported.
    function asperity_tangential_stiffness_at_loads(model, n, load, stiffness) result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: load              ! n real(c_double) [force]
      type(c_ptr), intent(in), value :: stiffness         ! receives n real(c_double) [force/length]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_tangential_stiffness_at_loads

    ! Tangential force at a load and a displacement, by integration over the summits.
    function asperity_tangential_at_load(model, load, displacement, force, stiffness) result(status) bind(c)
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load           ! [force]
      real(c_double), intent(in), value :: displacement   ! [length]
      type(c_ptr), intent(in), value :: force             ! receives a real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: stiffness         ! receives a real(c_double) [force/length]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_tangential_at_load

    ! How many real(c_double) the state of a contact that remembers takes.
    function asperity_microslip_length(model) result(length) bind(c)
      import :: c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t) :: length
    end function asperity_microslip_length

    ! One step of a contact that remembers.
    function asperity_microslip_step(model, load, increment, before, after, out) result(status) bind(c)
      import :: asperity_microslip, c_double, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load           ! [force]
      type(c_ptr), intent(in), value :: increment         ! 2 real(c_double) [length]
      type(c_ptr), intent(in), value :: before            ! the state before the step
      type(c_ptr), intent(in), value :: after             ! receives the state after it; c_null_ptr: none
      type(asperity_microslip), intent(inout) :: out
      integer(c_int32_t) :: status
    end function asperity_microslip_step

    ! One step of many contacts. Every element is filled, then the first invalid one reported.
    function asperity_microslip_steps(model, n, load, increment, before, after, force, stiffness) result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: load              ! n real(c_double) [force]
      type(c_ptr), intent(in), value :: increment         ! (2, n) real(c_double) [length]
      type(c_ptr), intent(in), value :: before            ! n states
      type(c_ptr), intent(in), value :: after             ! receives n states; c_null_ptr: none
      type(c_ptr), intent(in), value :: force             ! receives (2, n) real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: stiffness         ! receives (2, 2, n) real(c_double) [force/length]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_microslip_steps

    ! The exact state at a load [force], from the pull-off load upwards.
    function asperity_state_at_load(model, load, state) result(status) bind(c)
      import :: asperity_state, c_double, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      type(asperity_state), intent(inout) :: state        ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_state_at_load

    ! The exact state at a separation [length], also beyond the pull-off point.
    function asperity_state_at_separation(model, separation, state) result(status) bind(c)
      import :: asperity_state, c_double, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: separation
      type(asperity_state), intent(inout) :: state        ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_state_at_separation

    ! The warnings of all states from one load [force] to a heavier one.
    function asperity_check_loads(model, lightest, heaviest, warnings) result(status) bind(c)
      import :: c_double, c_int32_t, c_int64_t, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: lightest, heaviest
      integer(c_int64_t), intent(inout) :: warnings       ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_check_loads

    ! What one warning says, a C string; asperity_warning_text is easier.
    function asperity_warning_string(warning) result(text) bind(c)
      import :: c_int64_t, c_ptr
      integer(c_int64_t), intent(in), value :: warning
      type(c_ptr) :: text
    end function asperity_warning_string

    ! What warnings say, a line for each; asperity_warning_text is easier.
    function asperity_warnings_text(warnings, buffer, length) result(whole) bind(c)
      import :: c_int64_t, c_ptr, c_size_t
      integer(c_int64_t), intent(in), value :: warnings
      type(c_ptr), intent(in), value :: buffer            ! length characters, or c_null_ptr
      integer(c_size_t), intent(in), value :: length
      integer(c_size_t) :: whole                          ! without the c_null_char
    end function asperity_warnings_text

    ! Between which loads of the table [force] a warning holds; NaN if it holds at none.
    function asperity_warning_loads(model, warning, lightest, heaviest) result(status) bind(c)
      import :: c_double, c_int32_t, c_int64_t, c_ptr
      type(c_ptr), intent(in), value :: model
      integer(c_int64_t), intent(in), value :: warning    ! one bit ASPERITY_WARNING_
      type(c_ptr), intent(in), value :: lightest, heaviest ! c_loc of a real(c_double) each; untouched on failure
      integer(c_int32_t) :: status
    end function asperity_warning_loads

    ! Single summits, each at an overlap. Every element is filled, then the first invalid one reported.
    function asperity_summits_at_overlaps(model, n, overlap, height, load, force, radius) result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: overlap           ! n real(c_double) [length]
      type(c_ptr), intent(in), value :: height            ! n real(c_double) [length]; c_null_ptr: the mean height
      type(c_ptr), intent(in), value :: load              ! receives n real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: force             ! receives n real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: radius            ! receives n real(c_double) [length]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_summits_at_overlaps

    ! The constants of a model: dimensionless groups, pull-off, extent and error of the table.
    function asperity_summary_of(model, summary) result(status) bind(c)
      import :: asperity_summary, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      type(asperity_summary), intent(inout) :: summary    ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_summary_of

    ! A view of the compiled law, valid until the model is changed or freed.
    function asperity_table_of(model, table) result(status) bind(c)
      import :: asperity_table, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      type(asperity_table), intent(inout) :: table        ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_table_of

    ! The sensitivities of the friction force at a load [force], above the pull-off load.
    function asperity_sensitivities_at_load(model, load, sensitivities) result(status) bind(c)
      import :: asperity_sensitivities, c_double, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      type(asperity_sensitivities), intent(inout) :: sensitivities    ! untouched on failure
      integer(c_int32_t) :: status
    end function asperity_sensitivities_at_load

    ! Friction coefficient [-] at a load [force], and its slope.
    function asperity_friction_and_slope_at_load(model, load, dmu_dload) result(mu) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      type(c_ptr), intent(in), value :: dmu_dload         ! receives a real(c_double) [1/force]; c_null_ptr: none
      real(c_double) :: mu
    end function asperity_friction_and_slope_at_load

    ! Friction force [force] at a load [force], and its slope.
    function asperity_friction_force_and_slope_at_load(model, load, dforce_dload) result(force) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      type(c_ptr), intent(in), value :: dforce_dload      ! receives a real(c_double) [-]; c_null_ptr: none
      real(c_double) :: force
    end function asperity_friction_force_and_slope_at_load

    ! Friction coefficient [-] at a contact pressure, and its slope: the load is the pressure times the nominal area.
    function asperity_friction_at_pressure(model, pressure, nominal_area, dmu_dpressure) result(mu) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: pressure       ! [stress], positive in compression
      real(c_double), intent(in), value :: nominal_area   ! that carries asperity_count summits [length^2]
      type(c_ptr), intent(in), value :: dmu_dpressure     ! receives a real(c_double) [1/stress]; c_null_ptr: none
      real(c_double) :: mu
    end function asperity_friction_at_pressure

    ! Friction force per nominal area [stress] at a contact pressure, and its slope.
    function asperity_shear_stress_at_pressure(model, pressure, nominal_area, dstress_dpressure) result(stress) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: pressure       ! [stress], positive in compression
      real(c_double), intent(in), value :: nominal_area   ! that carries asperity_count summits [length^2]
      type(c_ptr), intent(in), value :: dstress_dpressure ! receives a real(c_double) [-]; c_null_ptr: none
      real(c_double) :: stress
    end function asperity_shear_stress_at_pressure

    ! Friction force [force] with a smooth sign, F(load) tanh(slip_rate/transition_rate), and its slopes.
    function asperity_slip_force(model, load, slip_rate, transition_rate, dforce_dload, dforce_dslip_rate) &
        result(force) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: load
      real(c_double), intent(in), value :: slip_rate      ! [length/time], signed
      real(c_double), intent(in), value :: transition_rate ! [length/time], 1e-60 to 1e60
      type(c_ptr), intent(in), value :: dforce_dload      ! receives a real(c_double) [-]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dforce_dslip_rate ! receives one [force time/length]; c_null_ptr: none
      real(c_double) :: force
    end function asperity_slip_force

    ! Friction coefficients at many pressures, and their slopes. Every element is filled, then the first invalid one reported.
    function asperity_friction_at_pressures(model, n, pressure, nominal_area, mu, dmu_dpressure) result(status) bind(c)
      import :: c_double, c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: pressure          ! n real(c_double) [stress], positive in compression
      real(c_double), intent(in), value :: nominal_area   ! that carries asperity_count summits [length^2]
      type(c_ptr), intent(in), value :: mu                ! receives n real(c_double) [-]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dmu_dpressure     ! receives n real(c_double) [1/stress]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_friction_at_pressures

    ! Shear stresses at many pressures, and their slopes, likewise.
    function asperity_shear_stresses_at_pressures(model, n, pressure, nominal_area, stress, dstress_dpressure) &
        result(status) bind(c)
      import :: c_double, c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: pressure          ! n real(c_double) [stress], positive in compression
      real(c_double), intent(in), value :: nominal_area   ! that carries asperity_count summits [length^2]
      type(c_ptr), intent(in), value :: stress            ! receives n real(c_double) [stress]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dstress_dpressure ! receives n real(c_double) [-]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_shear_stresses_at_pressures

    ! Friction forces of many sliding contacts, and their slopes, likewise.
    function asperity_slip_forces(model, n, load, slip_rate, transition_rate, force, dforce_dload, dforce_dslip_rate) &
        result(status) bind(c)
      import :: c_double, c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: load              ! n real(c_double) [force]
      type(c_ptr), intent(in), value :: slip_rate         ! n real(c_double) [length/time], signed
      real(c_double), intent(in), value :: transition_rate ! [length/time], 1e-60 to 1e60
      type(c_ptr), intent(in), value :: force             ! receives n real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dforce_dload      ! receives n real(c_double) [-]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dforce_dslip_rate ! receives n [force time/length]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_slip_forces

    ! Load [force] at a separation [length] of the mean planes; 0 at pull-off and beyond.
    function asperity_load_at_separation(model, separation) result(load) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: separation
      real(c_double) :: load
    end function asperity_load_at_separation

    ! Load [force] at a separation [length], and its slope: minus the normal stiffness.
    function asperity_load_and_slope_at_separation(model, separation, dload_dseparation) result(load) bind(c)
      import :: c_double, c_ptr
      type(c_ptr), intent(in), value :: model
      real(c_double), intent(in), value :: separation
      type(c_ptr), intent(in), value :: dload_dseparation ! receives a real(c_double) [force/length]; c_null_ptr: none
      real(c_double) :: load
    end function asperity_load_and_slope_at_separation

    ! Loads at many separations, and their slopes. Every element is filled, then the first invalid one reported.
    function asperity_loads_at_separations(model, n, separation, load, dload_dseparation) result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: separation        ! n real(c_double) [length]
      type(c_ptr), intent(in), value :: load              ! receives n real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dload_dseparation ! receives n real(c_double) [force/length]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_loads_at_separations

    ! Friction forces of contacts that belong to several models. Every element is filled, then the first invalid one reported.
    function asperity_friction_force_at_loads_of(models, models_length, n, which, load, force, dforce_dload) &
        result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: models            ! models_length type(c_ptr), none of them c_null_ptr
      integer(c_size_t), intent(in), value :: models_length
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: which             ! n integer(c_int32_t): the index of the model, from 0
      type(c_ptr), intent(in), value :: load              ! n real(c_double) [force]
      type(c_ptr), intent(in), value :: force             ! receives n real(c_double) [force]; c_null_ptr: none
      type(c_ptr), intent(in), value :: dforce_dload      ! receives n real(c_double) [-]; c_null_ptr: none
      integer(c_int32_t) :: status
    end function asperity_friction_force_at_loads_of

    ! The compiled load against separation for other evaluators: minus the separation in place of a load.
    function asperity_load_table_of(model, table) result(status) bind(c)
      import :: asperity_table, c_int32_t, c_ptr
      type(c_ptr), intent(in), value :: model
      type(asperity_table), intent(inout) :: table
      integer(c_int32_t) :: status
    end function asperity_load_table_of
  end interface

  public :: asperity_abi_version, asperity_version, asperity_status_string, asperity_last_error
  public :: asperity_params_set_dimensionless, asperity_params_set_elastic_plastic
  public :: asperity_params_set_materials, asperity_params_set_spectral_moments, asperity_params_set_nayak_summits
  public :: asperity_params_set_skew, asperity_params_calibrate, asperity_params_calibrate_force
  public :: asperity_params_set_value, asperity_params_set_values, asperity_params_get_value, asperity_params_name
  public :: asperity_material, asperity_material_name, asperity_pair, asperity_pair_name, asperity_params_set_pair
  public :: asperity_interface, asperity_interface_name, asperity_params_set_interface
  public :: asperity_create, asperity_set_params, asperity_free
  public :: asperity_friction_at_load, asperity_friction_force_at_load, asperity_friction_at_loads
  public :: asperity_friction_force_at_loads, asperity_state_at_load, asperity_state_at_separation, asperity_summary_of
  public :: asperity_sensitivities_at_load
  public :: asperity_check_loads, asperity_warning_string, asperity_warnings_text, asperity_warning_loads
  public :: asperity_summits_at_overlaps
  public :: asperity_table_of, asperity_friction_and_slope_at_load, asperity_friction_force_and_slope_at_load
  public :: asperity_friction_at_pressure, asperity_shear_stress_at_pressure, asperity_slip_force
  public :: asperity_friction_at_pressures, asperity_shear_stresses_at_pressures, asperity_slip_forces
  public :: asperity_load_at_separation, asperity_load_and_slope_at_separation, asperity_loads_at_separations
  public :: asperity_friction_force_at_loads_of, asperity_load_table_of
  public :: asperity_tangential_stiffness_at_load, asperity_tangential_stiffness_at_loads, asperity_tangential_at_load
  public :: asperity_microslip_length, asperity_microslip_step, asperity_microslip_steps

  ! ---- The Fortran interface ----

  ! A friction law that frees itself.
  !
  !     type(friction_model) :: law
  !     call law%create(params)
  !     mu = law%friction_at_load(load)
  !
  ! b = a makes a model of its own for b. A model belongs to the variable that it was created in: a bitwise copy of
  ! the variable, as allocate(source=) makes, never frees it, and is refused until create is called on it. The same
  ! holds for a law in a type that is assigned as a whole, where the compiler (gfortran 12) moves bits: assign the law.
  !
  ! In every procedure below
  !   stat    integer, intent(out), optional: 0 or one of the ASPERITY_ statuses; without it an error stops the
  !           program with the message on the error unit
  !   errmsg  character(*), intent(inout), optional: the message, cut or padded; as it was if there is no error
  type, public :: friction_model
    private
    type(c_ptr) :: handle = c_null_ptr
    type(c_ptr) :: owner = c_null_ptr      ! address of `handle` in the variable that the model was created in
  contains
    ! call law%create(params [, stat] [, errmsg])
    !   params  type(asperity_params), intent(in)
    ! Makes the model. A model that was there before is freed; on failure it stays.
    procedure, public :: create => create_model

    ! call law%set_params(params [, stat] [, errmsg])    other parameters, all or nothing; no other thread may use law
    ! call law%get_params(params [, stat] [, errmsg])    params: type(asperity_params), intent(out)
    procedure, public :: set_params => set_model_params
    procedure, public :: get_params => get_model_params

    ! call law%free()    frees the model now; the main program's variables are not freed by the language
    ! law%c_model()      the type(c_ptr) for the functions of the C interface; law still owns it
    procedure, public :: free => free_model
    procedure, public :: c_model

    ! mu = law%friction_at_load(load [, slope] [, stat] [, errmsg])
    !   load   real(c_double), intent(in), rank 0 to 3 [force]
    !   mu     real(c_double), of the shape of load [-]: F/load for load > 0, at most max_friction_coefficient, which
    !          it is also where pull-off <= load <= 0; 0 below pull-off; NaN for a load that is not finite
    !   slope  real(c_double), intent(out), optional, of the shape of load: d(mu)/d(load) [1/force], 0 where mu is
    !          capped
    ! A load below pull-off is no error: the contact is open and its friction 0. Only a scalar tells, by
    ! stat = ASPERITY_SEPARATED; among the elements of an array open contacts are ordinary.
    ! All elements are filled before an error is reported: a load that is not finite, ASPERITY_INVALID_LOAD, or too heavy to
    ! be evaluated, ASPERITY_OUT_OF_RANGE, both with NaN. errmsg counts them from 1, in array element order. A slope of
    ! another shape than load always stops the program.
    generic, public :: friction_at_load => friction_rank_0, friction_rank_1, friction_rank_2, friction_rank_3

    ! force = law%friction_force_at_load(load [, slope] [, stat] [, errmsg])
    !   the same for F [force] and dF/d(load) [-]; finite down to pull-off, where the slope is infinite
    generic, public :: friction_force_at_load => force_rank_0, force_rank_1, force_rank_2, force_rank_3

    ! mu = law%friction_at_pressure(pressure, nominal_area [, slope] [, stat] [, errmsg])
    !   pressure      real(c_double), intent(in) [stress], positive in compression; not beyond 1e120
    !   nominal_area  real(c_double), intent(in) [length^2], 1e-60 to 1e60: the area that carries asperity_count
    !                 summits; the area of a mesh or of an integration point plays no part
    !   mu            real(c_double) [-]: friction_at_load of pressure times nominal_area
    !   slope         real(c_double), intent(out), optional: d(mu)/d(pressure) [1/stress]
    ! stress = law%shear_stress_at_pressure(pressure, nominal_area [, slope] [, stat] [, errmsg])
    !   the same for friction force over nominal_area [stress] and d(stress)/d(pressure) [-]; finite down to pull-off
    ! What is not allowed gives NaN, with a slope of NaN, and ASPERITY_INVALID_PARAMETER or ASPERITY_INVALID_LOAD.
    procedure, public :: friction_at_pressure => model_friction_at_pressure
    procedure, public :: shear_stress_at_pressure => model_shear_stress_at_pressure

    ! force = law%slip_force(load, slip_rate, transition_rate [, dforce_dload] [, dforce_dslip_rate] [, stat] &
    !                        [, errmsg])
    !   slip_rate          real(c_double), intent(in) [length/time], signed
    !   transition_rate    real(c_double), intent(in) [length/time], 1e-60 to 1e60
    !   force              real(c_double) [force]: F(load) tanh(slip_rate/transition_rate), for solvers that integrate
    !                      through zero slip rate; it opposes the slip: give it the opposite sign on the body that slips
    !   dforce_dload       real(c_double), intent(out), optional [-]
    !   dforce_dslip_rate  real(c_double), intent(out), optional [force time/length]
    procedure, public :: slip_force => model_slip_force

    ! stiffness = law%tangential_stiffness_at_load(load [, stat] [, errmsg])
    !   load       real(c_double), intent(in), rank 0 or 1 [force]
    !   stiffness  real(c_double), of the shape of load [force/length]: tangential force by displacement while all
    !              contacts stick; 0 below pull-off. Errors as for friction_at_load
    ! call law%tangential_at_load(load, displacement, force [, slope] [, stat] [, errmsg])
    !   displacement  real(c_double), intent(in) [length]
    !   force         real(c_double), intent(inout) [force]: exact; as it was on failure
    !   slope         real(c_double), intent(inout), optional [force/length]: d(force)/d(displacement)
    ! The force rises from stiffness times displacement to the friction force; it is odd in the displacement.
    generic, public :: tangential_stiffness_at_load => stiffness_rank_0, stiffness_rank_1
    procedure, public :: tangential_at_load => model_tangential_at_load

    ! length = law%microslip_length()    the doubles in the state of a contact that remembers, all 0 when it has just closed
    ! call law%microslip_step(load, increment, before, after, out [, stat] [, errmsg])
    !   increment  real(c_double), intent(in), (2) [length]: the displacement since before, along both directions
    !   before     real(c_double), intent(in), (length): the state before the step, which an iteration passes again and again
    !   after      real(c_double), intent(inout), (length): the state after it, which the accepted step keeps; as it was on
    !              failure
    !   out        type(asperity_microslip), intent(inout): force, tangents and work; as it was on failure
    ! call law%microslip_steps(load, increment, before, after, force, stiffness [, stat] [, errmsg])    many contacts
    !   load (n), increment (2, n), before and after (length, n), force (2, n), stiffness (2, 2, n)
    ! Below pull-off the contact is open: force, tangents and after are 0. That is no error, but stat tells it.
    procedure, public :: microslip_length => model_microslip_length
    procedure, public :: microslip_step => model_microslip_step
    procedure, public :: microslip_steps => model_microslip_steps

    ! load = law%load_at_separation(separation [, slope] [, stat] [, errmsg])
    !   separation  real(c_double), intent(in) [length] of the mean planes, as for state_at_separation
    !   load        real(c_double) [force]: negative where adhesion pulls, 0 at pull-off and beyond
    !   slope       real(c_double), intent(out), optional: d(load)/d(separation) [force/length], minus the normal stiffness
    ! A separation that is not finite gives NaN, with a slope of NaN, and ASPERITY_INVALID_PARAMETER.
    procedure, public :: load_at_separation => model_load_at_separation

    ! call law%state_at_load(load, state [, stat] [, errmsg])                the exact state at a load [force]
    ! call law%state_at_separation(separation, state [, stat] [, errmsg])    the same at a separation [length]
    !   state  type(asperity_state), intent(inout); as it was on failure
    procedure, public :: state_at_load => model_state_at_load
    procedure, public :: state_at_separation => model_state_at_separation

    ! call law%sensitivities_at_load(load, sensitivities [, stat] [, errmsg])    what F at a load [force] changes by
    !   sensitivities  type(asperity_sensitivities), intent(inout); as it was on failure
    procedure, public :: sensitivities_at_load => model_sensitivities_at_load

    ! call law%warning_loads(warning, lightest, heaviest [, stat] [, errmsg])
    !   warning             integer(c_int64_t), intent(in): one bit ASPERITY_WARNING_
    !   lightest, heaviest  real(c_double), intent(inout) [force]: between which loads of the table it holds; NaN if it holds at
    !                       none; as they were on failure
    procedure, public :: warning_loads => model_warning_loads

    ! call law%check_loads(lightest, heaviest, warnings [, stat] [, errmsg])
    !   lightest, heaviest  real(c_double), intent(in) [force]
    !   warnings            integer(c_int64_t), intent(inout): the bits ASPERITY_WARNING_ of all states between, 0 if
    !                       nothing is known to fail; as it was on failure
    procedure, public :: check_loads => model_check_loads

    ! call law%summits_at_overlaps(overlap, load, force, radius [, height] [, stat] [, errmsg])    single summits
    !   overlap  real(c_double), intent(in) [length], (n): the height of a summit less the separation
    !   load     real(c_double), intent(out) [force], (n); negative where a summit pulls
    !   force    real(c_double), intent(out) [force], (n): the friction force, 0 out of contact
    !   radius   real(c_double), intent(out) [length], (n): of the contact, 0 out of contact
    !   height   real(c_double), intent(in), optional [length], (n): from the mean of the summit heights, on which radii
    !            depend where radius_amplitude is not 0; by default the mean height
    procedure, public :: summits_at_overlaps => model_summits_at_overlaps

    ! call law%summary(constants [, stat] [, errmsg])
    !   constants  type(asperity_summary), intent(inout); as it was on failure
    procedure, public :: summary => model_summary

    ! call law%table(view [, rows] [, stat] [, errmsg])    the compiled law, for code that cannot call the library
    !   view  type(asperity_table), intent(inout); as it was on failure
    !   rows  real(c_double), pointer, intent(out), optional: its rows(8, row_count), only to be read; disassociated on
    !         failure
    ! Both are valid until law is changed or freed.
    procedure, public :: table => model_table

    generic, public :: assignment(=) => copy_model
    procedure, private :: copy_model
    procedure, private :: friction_rank_0, friction_rank_1, friction_rank_2, friction_rank_3
    procedure, private :: force_rank_0, force_rank_1, force_rank_2, force_rank_3
    procedure, private :: stiffness_rank_0, stiffness_rank_1
    final :: finalise_model
  end type friction_model

  interface asperity_params_set
    module procedure set_by_name, set_by_names
  end interface asperity_params_set

  public :: asperity_params_init, asperity_get_params
  public :: asperity_params_set, asperity_params_get, asperity_params_name_text
  public :: asperity_material_of, asperity_pair_of, asperity_material_name_text, asperity_pair_name_text
  public :: asperity_interface_of, asperity_interface_name_text
  public :: asperity_params_use_pair, asperity_params_use_interface
  public :: asperity_params_of, asperity_check, asperity_error_message, asperity_status_text, asperity_version_text
  public :: asperity_warning_text

  abstract interface
    function batch_function(model, n, load, value, slope) result(status) bind(c)
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), intent(in), value :: model
      integer(c_size_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: load, value, slope
      integer(c_int32_t) :: status
    end function batch_function
  end interface

  character(*), parameter :: NOT_CREATED = 'friction_model: no model here: call create on this variable first; a ' // &
                                           'bitwise copy, as allocate(source=) makes, has none'

  ! Areas and rates lie between the inverse of this and this, pressures up to its square.
  real(c_double), parameter :: LARGEST = 1e60_c_double
  character(*), parameter :: FROM_TO = 'from 1e-60 to 1e60'
  integer(c_int64_t), parameter :: INFINITY_BITS = int(z'7FF0000000000000', c_int64_t)

contains

  ! Defaults for all but the eight physical inputs, composite_modulus to asperity_count, which are NaN until they are set:
  ! asperity_create names the first that was not, 'asperity_count: must be set'.
  function asperity_params_init(params) result(status)
    type(asperity_params), intent(out) :: params
    integer(c_int32_t) :: status
    status = asperity_params_init_c(params, c_sizeof(params))
  end function asperity_params_init

  ! Parameters of a surface of your own, all that no default can stand for: name the arguments, and the compiler asks for
  ! the one that you forget. In one consistent system of units; heights and what else has a default are set afterwards.
  function asperity_params_of(E1, nu1, E2, nu2, work_of_adhesion, adhesion_range, burgers_vector, height_std, &
                              summit_radius, asperity_count, stat, errmsg) result(params)
    real(c_double), intent(in) :: E1, nu1, E2, nu2        ! Young's moduli [stress], one may be infinite; Poisson's ratios
    real(c_double), intent(in) :: work_of_adhesion        ! [force/length], 0 for none
    real(c_double), intent(in) :: adhesion_range          ! [length]
    real(c_double), intent(in) :: burgers_vector          ! [length]
    real(c_double), intent(in) :: height_std              ! of the summits [length]
    real(c_double), intent(in) :: summit_radius           ! [length]
    real(c_double), intent(in) :: asperity_count          ! summit density times nominal area [-]
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(asperity_params) :: params
    integer(c_int32_t) :: status
    status = asperity_params_init(params)
    if (status == ASPERITY_OK) status = asperity_params_set_materials(params, E1, nu1, E2, nu2)
    params%work_of_adhesion = work_of_adhesion
    params%adhesion_range = adhesion_range
    params%burgers_vector = burgers_vector
    params%height_std = height_std
    params%summit_radius = summit_radius
    params%asperity_count = asperity_count
    call report(status, stat, errmsg)
  end function asperity_params_of

  ! Sets one parameter by its name: call asperity_params_set(params, 'hardness', 9.8e9_c_double). Integers too.
  subroutine set_by_name(params, name, value, stat, errmsg)
    type(asperity_params), intent(inout) :: params        ! initialised; untouched on failure
    character(*), intent(in) :: name                      ! one of asperity_params_name_text
    real(c_double), intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call set_by_names(params, [name], [value], stat, errmsg)
  end subroutine set_by_name

  ! Sets parameters by their names, in any order, all or none; E1, nu1, E2 and nu2 go together, and m0, m2 and m4.
  subroutine set_by_names(params, names, values, stat, errmsg)
    type(asperity_params), intent(inout) :: params        ! initialised; untouched on failure
    character(*), intent(in) :: names(:)
    real(c_double), intent(in) :: values(:)               ! as many
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(kind=c_char), target :: text(len(names) + 1, size(names))
    type(c_ptr), target :: first(size(names))
    real(c_double), target :: numbers(size(values))
    integer :: i
    if (size(names) /= size(values)) then
      call report_message(ASPERITY_INVALID_PARAMETER, 'values: must be as many as names', stat, errmsg)
      return
    end if
    do i = 1, size(names)
      text(:, i) = c_string(names(i), size(text, 1))
      first(i) = c_loc(text(1, i))
    end do
    numbers = values
    call report(asperity_params_set_values(params, size(names, kind=c_size_t), c_loc(first), c_loc(numbers)), stat, errmsg)
  end subroutine set_by_names

  ! A parameter by its name.
  function asperity_params_get(params, name, stat, errmsg) result(number)
    type(asperity_params), intent(in) :: params           ! initialised
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: number                              ! 0 on failure
    real(c_double), target :: found
    character(kind=c_char), target :: text(len(name) + 1)
    text = c_string(name, size(text))
    found = 0
    call report(asperity_params_get_value(params, c_loc(text), c_loc(found)), stat, errmsg)
    number = found
  end function asperity_params_get

  ! The names of the parameters that are one number; empty after the last.
  function asperity_params_name_text(index) result(text)
    integer, intent(in) :: index                          ! from 1
    character(:), allocatable :: text
    text = listed(asperity_params_name, index)
  end function asperity_params_name_text

  ! A material by its name, one of asperity_material_name_text: material = asperity_material_of('steel').
  function asperity_material_of(name, stat, errmsg) result(material)
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(asperity_material_data) :: material              ! zeros on failure
    character(kind=c_char), target :: text(len(name) + 1)
    text = c_string(name, size(text))
    material = asperity_material_data(young=0, young_low=0, young_high=0, poisson=0, hardness=0, hardness_low=0, &
                                      hardness_high=0, burgers_vector=0)
    call report(asperity_material(c_loc(text), material), stat, errmsg)
  end function asperity_material_of

  ! A pair of materials by its name, one of asperity_pair_name_text, in either order.
  function asperity_pair_of(name, stat, errmsg) result(pair)
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(asperity_pair_data) :: pair                      ! zeros on failure
    character(kind=c_char), target :: text(len(name) + 1)
    text = c_string(name, size(text))
    pair = asperity_pair_data(work_of_adhesion=0, work_of_adhesion_low=0, work_of_adhesion_high=0, hamaker=0, &
                              slip_stress_1=0)
    call report(asperity_pair(c_loc(text), pair), stat, errmsg)
  end function asperity_pair_of

  ! Sets all that is known of two materials, in SI units, all but the roughness: call asperity_params_use_pair(params,
  ! 'steel/steel'). What is not known is left to set.
  subroutine asperity_params_use_pair(params, name, stat, errmsg)
    type(asperity_params), intent(inout) :: params        ! initialised; untouched on failure
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(kind=c_char), target :: text(len(name) + 1)
    text = c_string(name, size(text))
    call report(asperity_params_set_pair(params, c_loc(text)), stat, errmsg)
  end subroutine asperity_params_use_pair

  ! An interface by its name, one of asperity_interface_name_text: what was measured of its strength.
  function asperity_interface_of(name, stat, errmsg) result(found)
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(asperity_interface_data) :: found                ! zeros on failure
    character(kind=c_char), target :: text(len(name) + 1)
    text = c_string(name, size(text))
    found = asperity_interface_data(shear_strength=0, pressure_coefficient=0, friction_coefficient=0, load=0)
    call report(asperity_interface(c_loc(text), found), stat, errmsg)
  end function asperity_interface_of

  ! Sets the measured strength of an interface, in SI units, of bodies that are set: call
  ! asperity_params_use_interface(params, 'MoS2 film in dry air').
  subroutine asperity_params_use_interface(params, name, stat, errmsg)
    type(asperity_params), intent(inout) :: params        ! whose bodies are set; untouched on failure
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(kind=c_char), target :: text(len(name) + 1)
    text = c_string(name, size(text))
    call report(asperity_params_set_interface(params, c_loc(text)), stat, errmsg)
  end subroutine asperity_params_use_interface

  ! The names of the materials; empty after the last.
  function asperity_material_name_text(index) result(text)
    integer, intent(in) :: index                          ! from 1
    character(:), allocatable :: text
    text = listed(asperity_material_name, index)
  end function asperity_material_name_text

  ! The names of the pairs; empty after the last.
  function asperity_pair_name_text(index) result(text)
    integer, intent(in) :: index                          ! from 1
    character(:), allocatable :: text
    text = listed(asperity_pair_name, index)
  end function asperity_pair_name_text

  ! The names of the interfaces; empty after the last.
  function asperity_interface_name_text(index) result(text)
    integer, intent(in) :: index                          ! from 1
    character(:), allocatable :: text
    text = listed(asperity_interface_name, index)
  end function asperity_interface_name_text

  ! The name that a list of the library has at an index, from 1; empty beside its ends.
  function listed(name_of, index) result(text)
    interface
      function name_of(index) result(name) bind(c)
        import :: c_ptr, c_size_t
        integer(c_size_t), intent(in), value :: index
        type(c_ptr) :: name
      end function name_of
    end interface
    integer, intent(in) :: index
    character(:), allocatable :: text
    type(c_ptr) :: name
    text = ''
    if (index < 1) return
    name = name_of(int(index - 1, c_size_t))
    if (c_associated(name)) text = fortran_text(name)
  end function listed

  ! So many characters, of which those after the text are c_null_char.
  pure function c_string(text, length) result(characters)
    character(*), intent(in) :: text
    integer, intent(in) :: length
    character(kind=c_char) :: characters(length)
    integer :: i
    characters = c_null_char
    do i = 1, len_trim(text)
      characters(i) = text(i:i)
    end do
  end function c_string

  ! Copies the parameters of a model out. Pointers to a table are those of the model's own copy, valid until the model
  ! is changed or freed.
  function asperity_get_params(model, params) result(status)
    type(c_ptr), intent(in) :: model
    type(asperity_params), intent(inout) :: params        ! as it was on failure, but for its size
    integer(c_int32_t) :: status
    params%struct_size = int(c_sizeof(params), c_int64_t)
    status = asperity_get_params_c(model, params)
  end function asperity_get_params

  ! Stops the program with the message if a status is not ASPERITY_OK:
  !     call asperity_check(asperity_params_set_skew(params, -0.5_c_double))
  subroutine asperity_check(status)
    integer(c_int32_t), intent(in) :: status
    if (status /= ASPERITY_OK) call stop_with(asperity_error_message())
  end subroutine asperity_check

  ! This thread's last message; empty if there was none.
  function asperity_error_message() result(message)
    character(:), allocatable :: message
    character(kind=c_char), target :: buffer(1024)
    integer :: length
    length = int(asperity_last_error(c_loc(buffer), size(buffer, kind=c_size_t)))
    message = joined(buffer(:min(length, size(buffer) - 1)))
  end function asperity_error_message

  ! What a status means.
  function asperity_status_text(status) result(text)
    integer(c_int32_t), intent(in) :: status
    character(:), allocatable :: text
    text = fortran_text(asperity_status_string(status))
  end function asperity_status_text

  ! What warnings say, a line for each: what fails and what to do about it.
  function asperity_warning_text(warning) result(text)
    integer(c_int64_t), intent(in) :: warning
    character(:), allocatable :: text
    character(kind=c_char), allocatable, target :: buffer(:)
    integer :: length
    length = int(asperity_warnings_text(warning, c_null_ptr, 0_c_size_t))
    allocate(buffer(length + 1))
    length = int(asperity_warnings_text(warning, c_loc(buffer), size(buffer, kind=c_size_t)))
    text = joined(buffer(:length))
  end function asperity_warning_text

  ! The version of the library loaded, 'major.minor.patch'.
  function asperity_version_text() result(text)
    character(:), allocatable :: text
    text = fortran_text(asperity_version())
  end function asperity_version_text

  ! ---- Making and freeing ----

  subroutine create_model(self, params, stat, errmsg)
    class(friction_model), intent(inout), target :: self
    type(asperity_params), intent(in) :: params
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    made = c_null_ptr
    status = asperity_create(params, made)
    if (status == ASPERITY_OK) call take(self, made)
    call report(status, stat, errmsg)
  end subroutine create_model

  subroutine set_model_params(self, params, stat, errmsg)
    class(friction_model), intent(inout), target :: self
    type(asperity_params), intent(in) :: params
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_set_params(self%handle, params), stat, errmsg)
  end subroutine set_model_params

  subroutine get_model_params(self, params, stat, errmsg)
    class(friction_model), intent(in), target :: self
    type(asperity_params), intent(out) :: params
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_get_params(self%handle, params), stat, errmsg)
  end subroutine get_model_params

  subroutine free_model(self)
    class(friction_model), intent(inout), target :: self
    if (owns(self)) call asperity_free(self%handle)
    self%handle = c_null_ptr
    self%owner = c_null_ptr
  end subroutine free_model

  function c_model(self) result(model)
    class(friction_model), intent(in), target :: self
    type(c_ptr) :: model
    model = c_null_ptr
    if (owns(self)) model = self%handle
  end function c_model

  subroutine copy_model(self, other)
    class(friction_model), intent(inout), target :: self
    class(friction_model), intent(in), target :: other
    type(asperity_params) :: params
    if (c_associated(c_loc(self%handle), c_loc(other%handle))) return
    if (.not. c_associated(other%handle)) then
      call free_model(self)
      return
    end if
    ! `other` may be a temporary that the compiler made of its variable: it need not own the model to be read.
    call asperity_check(asperity_get_params(other%handle, params))
    call create_model(self, params)
  end subroutine copy_model

  impure elemental subroutine finalise_model(self)  ! elemental: for arrays of any rank
    type(friction_model), intent(inout) :: self
    call free_model(self)
  end subroutine finalise_model

  subroutine take(self, made)
    class(friction_model), intent(inout), target :: self
    type(c_ptr), intent(in) :: made
    call free_model(self)
    self%handle = made
    self%owner = c_loc(self%handle)
  end subroutine take

  function owns(self)
    class(friction_model), intent(in), target :: self
    logical :: owns
    owns = c_associated(self%owner, c_loc(self%handle))
  end function owns

  ! ---- Evaluation ----

  subroutine model_state_at_load(self, load, state, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: load
    type(asperity_state), intent(inout) :: state
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_state_at_load(self%handle, load, state), stat, errmsg)
  end subroutine model_state_at_load

  subroutine model_state_at_separation(self, separation, state, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: separation
    type(asperity_state), intent(inout) :: state
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_state_at_separation(self%handle, separation, state), stat, errmsg)
  end subroutine model_state_at_separation

  subroutine model_sensitivities_at_load(self, load, sensitivities, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: load
    type(asperity_sensitivities), intent(inout) :: sensitivities
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_sensitivities_at_load(self%handle, load, sensitivities), stat, errmsg)
  end subroutine model_sensitivities_at_load

  subroutine model_warning_loads(self, warning, lightest, heaviest, stat, errmsg)
    class(friction_model), intent(in), target :: self
    integer(c_int64_t), intent(in) :: warning
    real(c_double), intent(inout), target :: lightest, heaviest
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_warning_loads(self%handle, warning, c_loc(lightest), c_loc(heaviest)), stat, errmsg)
  end subroutine model_warning_loads

  subroutine model_check_loads(self, lightest, heaviest, warnings, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: lightest, heaviest
    integer(c_int64_t), intent(inout) :: warnings
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_check_loads(self%handle, lightest, heaviest, warnings), stat, errmsg)
  end subroutine model_check_loads

  subroutine model_summits_at_overlaps(self, overlap, load, force, radius, height, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: overlap(:)
    real(c_double), intent(out), contiguous, target :: load(:), force(:), radius(:)
    real(c_double), intent(in), optional, contiguous, target :: height(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call require_same_shape(shape(overlap), shape(load))
    call require_same_shape(shape(overlap), shape(force))
    call require_same_shape(shape(overlap), shape(radius))
    if (present(height)) call require_same_shape(shape(overlap), shape(height))
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_summits_at_overlaps(self%handle, size(overlap, kind=c_size_t), address(overlap), &
                                             address(height), address(load), address(force), address(radius)), &
                stat, errmsg)
  end subroutine model_summits_at_overlaps

  subroutine model_summary(self, constants, stat, errmsg)
    class(friction_model), intent(in), target :: self
    type(asperity_summary), intent(inout) :: constants
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. is_created(self, stat, errmsg)) return
    call report(asperity_summary_of(self%handle, constants), stat, errmsg)
  end subroutine model_summary

  subroutine model_table(self, view, rows, stat, errmsg)
    class(friction_model), intent(in), target :: self
    type(asperity_table), intent(inout) :: view
    real(c_double), pointer, intent(out), optional :: rows(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    if (present(rows)) nullify(rows)
    if (.not. is_created(self, stat, errmsg)) return
    status = asperity_table_of(self%handle, view)
    if (present(rows) .and. status == ASPERITY_OK) call c_f_pointer(view%rows, rows, [8_c_int64_t, view%row_count])
    call report(status, stat, errmsg)
  end subroutine model_table

  function model_friction_at_pressure(self, pressure, nominal_area, slope, stat, errmsg) result(mu)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: pressure, nominal_area
    real(c_double), intent(out), optional, target :: slope
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: mu
    mu = asperity_friction_at_pressure(c_model(self), pressure, nominal_area, scalar_address(slope))
    call report_at_pressure(self, mu, pressure, nominal_area, stat, errmsg)
  end function model_friction_at_pressure

  function model_shear_stress_at_pressure(self, pressure, nominal_area, slope, stat, errmsg) result(stress)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: pressure, nominal_area
    real(c_double), intent(out), optional, target :: slope
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: stress
    stress = asperity_shear_stress_at_pressure(c_model(self), pressure, nominal_area, scalar_address(slope))
    call report_at_pressure(self, stress, pressure, nominal_area, stat, errmsg)
  end function model_shear_stress_at_pressure

  function model_slip_force(self, load, slip_rate, transition_rate, dforce_dload, dforce_dslip_rate, stat, errmsg) &
      result(force)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: load, slip_rate, transition_rate
    real(c_double), intent(out), optional, target :: dforce_dload, dforce_dslip_rate
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: force
    force = asperity_slip_force(c_model(self), load, slip_rate, transition_rate, scalar_address(dforce_dload), &
                                scalar_address(dforce_dslip_rate))
    if (needs_no_report(force, stat)) return
    if (.not. is_created(self, stat, errmsg)) return
    if (size_bits(slip_rate) >= INFINITY_BITS) then
      call report_refused('slip_rate', slip_rate, 'finite', ASPERITY_INVALID_PARAMETER, stat, errmsg)
    else if (.not. is_allowed(transition_rate)) then
      call report_refused('transition_rate', transition_rate, FROM_TO, ASPERITY_INVALID_PARAMETER, stat, errmsg)
    else
      call report_at_load(self, load, stat, errmsg)
    end if
  end function model_slip_force

  function model_load_at_separation(self, separation, slope, stat, errmsg) result(load)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: separation
    real(c_double), intent(out), optional, target :: slope
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: load
    real(c_double), target :: at(1)
    load = asperity_load_and_slope_at_separation(c_model(self), separation, scalar_address(slope))
    if (.not. is_created(self, stat, errmsg)) return
    at(1) = separation
    call report(open_is_an_answer(asperity_loads_at_separations(self%handle, 1_c_size_t, c_loc(at), c_null_ptr, &
                                                                c_null_ptr)), stat, errmsg)
  end function model_load_at_separation

  ! Surfaces apart carry no load: that is no failure.
  pure function open_is_an_answer(status) result(found)
    integer(c_int32_t), intent(in) :: status
    integer(c_int32_t) :: found
    found = merge(int(ASPERITY_OK, c_int32_t), status, status == ASPERITY_SEPARATED)
  end function open_is_an_answer

  function friction_rank_0(self, load, slope, stat, errmsg) result(mu)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), target :: load
    real(c_double), intent(out), optional, target :: slope
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: mu
    if (owns(self) .and. .not. present(slope) .and. .not. present(stat)) then
      mu = asperity_friction_at_load(self%handle, load)
      if (.not. is_nan(mu)) return
    end if
    call evaluate(asperity_friction_at_loads, self, 1_c_size_t, c_loc(load), c_loc(mu), scalar_address(slope), &
                  stat, errmsg, tells_open=.true.)
  end function friction_rank_0

  function force_rank_0(self, load, slope, stat, errmsg) result(force)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), target :: load
    real(c_double), intent(out), optional, target :: slope
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: force
    if (owns(self) .and. .not. present(slope) .and. .not. present(stat)) then
      force = asperity_friction_force_at_load(self%handle, load)
      if (.not. is_nan(force)) return
    end if
    call evaluate(asperity_friction_force_at_loads, self, 1_c_size_t, c_loc(load), c_loc(force), &
                  scalar_address(slope), stat, errmsg, tells_open=.true.)
  end function force_rank_0

  function friction_rank_1(self, load, slope, stat, errmsg) result(mu)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:)
    real(c_double), intent(out), optional, contiguous, target :: slope(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: mu(size(load))
    if (present(slope)) call require_same_shape(shape(load), shape(slope))
    call evaluate(asperity_friction_at_loads, self, size(load, kind=c_size_t), address(load), &
                  address(mu), address(slope), stat, errmsg)
  end function friction_rank_1

  function friction_rank_2(self, load, slope, stat, errmsg) result(mu)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:,:)
    real(c_double), intent(out), optional, contiguous, target :: slope(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: mu(size(load, 1), size(load, 2))
    if (present(slope)) call require_same_shape(shape(load), shape(slope))
    call evaluate(asperity_friction_at_loads, self, size(load, kind=c_size_t), address(load), &
                  address(mu), address(slope), stat, errmsg)
  end function friction_rank_2

  function friction_rank_3(self, load, slope, stat, errmsg) result(mu)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:,:,:)
    real(c_double), intent(out), optional, contiguous, target :: slope(:,:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: mu(size(load, 1), size(load, 2), size(load, 3))
    if (present(slope)) call require_same_shape(shape(load), shape(slope))
    call evaluate(asperity_friction_at_loads, self, size(load, kind=c_size_t), address(load), &
                  address(mu), address(slope), stat, errmsg)
  end function friction_rank_3

  function force_rank_1(self, load, slope, stat, errmsg) result(force)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:)
    real(c_double), intent(out), optional, contiguous, target :: slope(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: force(size(load))
    if (present(slope)) call require_same_shape(shape(load), shape(slope))
    call evaluate(asperity_friction_force_at_loads, self, size(load, kind=c_size_t), address(load), &
                  address(force), address(slope), stat, errmsg)
  end function force_rank_1

  function force_rank_2(self, load, slope, stat, errmsg) result(force)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:,:)
    real(c_double), intent(out), optional, contiguous, target :: slope(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: force(size(load, 1), size(load, 2))
    if (present(slope)) call require_same_shape(shape(load), shape(slope))
    call evaluate(asperity_friction_force_at_loads, self, size(load, kind=c_size_t), address(load), &
                  address(force), address(slope), stat, errmsg)
  end function force_rank_2

  function force_rank_3(self, load, slope, stat, errmsg) result(force)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:,:,:)
    real(c_double), intent(out), optional, contiguous, target :: slope(:,:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: force(size(load, 1), size(load, 2), size(load, 3))
    if (present(slope)) call require_same_shape(shape(load), shape(slope))
    call evaluate(asperity_friction_force_at_loads, self, size(load, kind=c_size_t), address(load), &
                  address(force), address(slope), stat, errmsg)
  end function force_rank_3

  function stiffness_rank_0(self, load, stat, errmsg) result(stiffness)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), target :: load
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: stiffness
    if (owns(self) .and. .not. present(stat)) then
      stiffness = asperity_tangential_stiffness_at_load(self%handle, load)
      if (.not. is_nan(stiffness)) return
    end if
    call evaluate(stiffnesses, self, 1_c_size_t, c_loc(load), c_loc(stiffness), c_null_ptr, stat, errmsg, &
                  tells_open=.true.)
  end function stiffness_rank_0

  function stiffness_rank_1(self, load, stat, errmsg) result(stiffness)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: stiffness(size(load))
    call evaluate(stiffnesses, self, size(load, kind=c_size_t), address(load), address(stiffness), c_null_ptr, &
                  stat, errmsg)
  end function stiffness_rank_1

  ! The stiffness has no slope.
  function stiffnesses(model, n, load, value, slope) result(status) bind(c, name='')
    type(c_ptr), intent(in), value :: model
    integer(c_size_t), intent(in), value :: n
    type(c_ptr), intent(in), value :: load, value, slope
    integer(c_int32_t) :: status
    if (c_associated(slope)) call stop_with('friction_model: the stiffness has no slope')
    status = asperity_tangential_stiffness_at_loads(model, n, load, value)
  end function stiffnesses

  subroutine model_tangential_at_load(self, load, displacement, force, slope, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: load, displacement
    real(c_double), intent(inout), target :: force
    real(c_double), intent(inout), optional, target :: slope
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: at_slope
    if (.not. is_created(self, stat, errmsg)) return
    at_slope = c_null_ptr
    if (present(slope)) at_slope = c_loc(slope)
    call report(asperity_tangential_at_load(self%handle, load, displacement, c_loc(force), at_slope), stat, errmsg)
  end subroutine model_tangential_at_load

  function model_microslip_length(self) result(length)
    class(friction_model), intent(in) :: self
    integer :: length
    length = int(asperity_microslip_length(self%handle))
  end function model_microslip_length

  subroutine model_microslip_step(self, load, increment, before, after, out, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: load
    real(c_double), intent(in), target :: increment(2)
    real(c_double), intent(in), contiguous, target :: before(:)
    real(c_double), intent(inout), contiguous, target :: after(:)
    type(asperity_microslip), intent(inout) :: out
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    if (.not. is_created(self, stat, errmsg)) return
    call require_shape('before', shape(before), [model_microslip_length(self)])
    call require_shape('after', shape(after), shape(before))
    status = asperity_microslip_step(self%handle, load, c_loc(increment), address(before), address(after), out)
    if (status == ASPERITY_SEPARATED .and. .not. present(stat)) return
    call report(status, stat, errmsg)
  end subroutine model_microslip_step

  subroutine model_microslip_steps(self, load, increment, before, after, force, stiffness, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), contiguous, target :: load(:)
    real(c_double), intent(in), contiguous, target :: increment(:,:), before(:,:)
    real(c_double), intent(inout), contiguous, target :: after(:,:), force(:,:), stiffness(:,:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    integer :: n
    if (.not. is_created(self, stat, errmsg)) return
    n = size(load)
    call require_shape('increment', shape(increment), [2, n])
    call require_shape('before', shape(before), [model_microslip_length(self), n])
    call require_shape('after', shape(after), shape(before))
    call require_shape('force', shape(force), [2, n])
    call require_shape('stiffness', shape(stiffness), [2, 2, n])
    status = asperity_microslip_steps(self%handle, int(n, c_size_t), address(load), address(increment), &
                                      address(before), address(after), address(force), address(stiffness))
    if (status == ASPERITY_SEPARATED .and. .not. present(stat)) return
    call report(status, stat, errmsg)
  end subroutine model_microslip_steps

  ! Every rank ends here, as the array that it is in memory.
  subroutine evaluate(batch, self, n, load, value, slope, stat, errmsg, tells_open)
    procedure(batch_function) :: batch
    class(friction_model), intent(in), target :: self
    integer(c_size_t), intent(in) :: n
    type(c_ptr), intent(in) :: load, value, slope
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    logical, intent(in), optional :: tells_open    ! a scalar, whose stat says that the contact is open
    real(c_double), pointer :: values(:)
    integer(c_int32_t) :: status
    if (.not. is_created(self, stat, errmsg)) then
      call c_f_pointer(value, values, [n])
      values = asperity_friction_at_load(c_null_ptr, 0.0_c_double)  ! a quiet NaN
      return
    end if
    status = batch(self%handle, n, load, value, slope)
    if (status == ASPERITY_SEPARATED) then
      if (.not. present(tells_open)) then
        call report_hidden(self, n, load, value, stat, errmsg)
        return
      else if (.not. present(stat)) then
        return
      end if
    end if
    call report(status, stat, errmsg)
  end subroutine evaluate

  ! Of many loads the library reports the first invalid load alone: an open contact, which is none here, may hide another.
  subroutine report_hidden(self, n, load, value, stat, errmsg)
    class(friction_model), intent(in), target :: self
    integer(c_size_t), intent(in) :: n
    type(c_ptr), intent(in) :: load, value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), pointer :: loads(:), values(:)
    type(asperity_state) :: state
    integer(c_int32_t) :: status
    integer(c_size_t) :: i
    character(20) :: number
    if (present(stat)) stat = 0
    call c_f_pointer(load, loads, [n])
    call c_f_pointer(value, values, [n])
    do i = 1, n
      if (is_nan(values(i))) then
        status = asperity_state_at_load(self%handle, loads(i), state)
        write (number, '(i0)') i
        call report_message(status, 'element ' // trim(number) // ': ' // asperity_error_message(), stat, errmsg)
        return
      end if
    end do
  end subroutine report_hidden

  pure function is_nan(x)
    real(c_double), intent(in) :: x
    logical :: is_nan
    is_nan = size_bits(x) > INFINITY_BITS
  end function is_nan

  ! The bits of abs(x), which order as the numbers do: a comparison of the numbers may trap.
  pure function size_bits(x)
    real(c_double), intent(in) :: x
    integer(c_int64_t) :: size_bits
    size_bits = iand(transfer(x, 0_c_int64_t), huge(0_c_int64_t))
  end function size_bits

  ! Whether the library takes x as an area or a transition rate.
  pure function is_allowed(x)
    real(c_double), intent(in) :: x
    logical :: is_allowed
    integer(c_int64_t) :: bits
    bits = transfer(x, bits)
    is_allowed = bits >= size_bits(1 / LARGEST) .and. bits <= size_bits(LARGEST)
  end function is_allowed

  subroutine require_same_shape(load, slope)
    integer, intent(in) :: load(:), slope(:)
    if (any(load /= slope)) call stop_with('friction_model: slope must have the shape of load')
  end subroutine require_same_shape

  subroutine require_shape(name, found, expected)
    character(*), intent(in) :: name
    integer, intent(in) :: found(:), expected(:)
    if (any(found /= expected)) call stop_with('friction_model: '//name//' must have a state, or two numbers, for each load')
  end subroutine require_shape

  ! The address of an array; c_null_ptr if it is absent.
  function address(array)
    real(c_double), intent(in), optional, target :: array(*)
    type(c_ptr) :: address
    address = c_null_ptr
    if (present(array)) address = c_loc(array)
  end function address

  function scalar_address(scalar)
    real(c_double), intent(in), optional, target :: scalar
    type(c_ptr) :: scalar_address
    scalar_address = c_null_ptr
    if (present(scalar)) scalar_address = c_loc(scalar)
  end function scalar_address

  ! ---- Errors ----

  function is_created(self, stat, errmsg)
    class(friction_model), intent(in), target :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    logical :: is_created
    is_created = owns(self)
    if (.not. is_created) call report_message(ASPERITY_NULL_POINTER, NOT_CREATED, stat, errmsg)
  end function is_created

  subroutine report(status, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (status == ASPERITY_OK) then
      if (present(stat)) stat = 0
    else
      call report_message(status, counted_from_one(asperity_error_message()), stat, errmsg)
    end if
  end subroutine report

  ! The C functions that return a number tell no reason. NaN has one, and 0 may be below pull-off.
  function needs_no_report(value, stat)
    real(c_double), intent(in) :: value
    integer, intent(out), optional :: stat
    logical :: needs_no_report
    needs_no_report = size_bits(value) > 0 .and. .not. is_nan(value)
    if (present(stat)) stat = 0
  end function needs_no_report

  subroutine report_at_pressure(self, value, pressure, nominal_area, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in) :: value, pressure, nominal_area
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (needs_no_report(value, stat)) return
    if (.not. is_created(self, stat, errmsg)) return
    if (.not. is_allowed(nominal_area)) then
      call report_refused('nominal_area', nominal_area, FROM_TO, ASPERITY_INVALID_PARAMETER, stat, errmsg)
    else if (size_bits(pressure) > size_bits(LARGEST * LARGEST)) then
      call report_refused('pressure', pressure, 'finite and not beyond 1e120', ASPERITY_INVALID_LOAD, stat, errmsg)
    else
      call report_at_load(self, pressure * nominal_area, stat, errmsg)
    end if
  end subroutine report_at_pressure

  subroutine report_at_load(self, load, stat, errmsg)
    class(friction_model), intent(in), target :: self
    real(c_double), intent(in), target :: load
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), target :: mu
    call evaluate(asperity_friction_at_loads, self, 1_c_size_t, c_loc(load), c_loc(mu), c_null_ptr, stat, errmsg, &
                  tells_open=.true.)
  end subroutine report_at_load

  subroutine report_refused(name, value, allowed, status, stat, errmsg)
    character(*), intent(in) :: name, allowed
    real(c_double), intent(in) :: value
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(16) :: number
    write (number, '(es16.6e3)') value
    call report_message(status, name // ' = ' // trim(adjustl(number)) // ': must be ' // allowed, stat, errmsg)
  end subroutine report_refused

  subroutine report_message(status, message, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    character(*), intent(in) :: message
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (present(errmsg)) errmsg = message
    if (.not. present(stat)) call stop_with(message)
    if (present(stat)) stat = int(status)
  end subroutine report_message

  ! The C library names the offending element of an array, 'element 0: ...', by the index that C gives it.
  function counted_from_one(message) result(counted)
    character(*), intent(in) :: message
    character(:), allocatable :: counted
    character(*), parameter :: PREFIX = 'element '
    character(20) :: number
    integer(c_int64_t) :: index_in_c
    integer :: colon, failed
    counted = message
    colon = index(message, ':')
    if (index(message, PREFIX) /= 1 .or. colon == 0) return
    read (message(len(PREFIX) + 1:colon - 1), *, iostat=failed) index_in_c
    if (failed /= 0) return
    write (number, '(i0)') index_in_c + 1
    counted = PREFIX // trim(number) // message(colon:)
  end function counted_from_one

  subroutine stop_with(message)
    character(*), intent(in) :: message
    write (error_unit, '(a)') 'asperity: ' // message
    error stop 1
  end subroutine stop_with

  ! A constant C string as a Fortran one.
  function fortran_text(text) result(converted)
    type(c_ptr), intent(in) :: text
    character(:), allocatable :: converted
    character(kind=c_char), pointer :: characters(:)
    integer :: length
    call c_f_pointer(text, characters, [huge(0)])
    length = 0
    do while (iachar(characters(length + 1)) /= 0)
      length = length + 1
    end do
    converted = joined(characters(:length))
  end function fortran_text

  pure function joined(characters) result(text)
    character(kind=c_char), intent(in) :: characters(:)
    character(size(characters)) :: text
    integer :: i
    do i = 1, size(characters)
      text(i:i) = characters(i)
    end do
  end function joined

end module asperity
