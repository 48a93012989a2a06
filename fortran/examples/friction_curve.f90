! Friction coefficient of a polysilicon MEMS contact against normal load, in SI units: the twin of
! c_examples/friction_curve.c, where the sources of the numbers are named. Both print the same table, to the digit, and
! the same warnings if the model does not hold somewhere between the two loads.
!
! usage: friction_curve [LOADS [LOWEST [HIGHEST]]]
!   LOADS    number of loads, 2 to 100000 (33)
!   LOWEST   lowest load [N], > 0 (2e-4)
!   HIGHEST  highest load [N], > LOWEST (0.1)
program friction_curve
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use asperity
  implicit none

  integer, parameter :: MAX_LOADS = 100000
  real(c_double), parameter :: E = 160e9_c_double             ! [Pa]
  real(c_double), parameter :: NU = 0.22_c_double
  real(c_double), parameter :: HARDNESS = 12e9_c_double       ! H [Pa]
  real(c_double), parameter :: BURGERS = 0.384e-9_c_double    ! [m]
  real(c_double), parameter :: ADHESION = 0.063_c_double      ! w [J/m^2]
  real(c_double), parameter :: SIGMA = 5e-9_c_double          ! [m]
  real(c_double), parameter :: RADIUS = 1e-6_c_double         ! R [m]
  real(c_double), parameter :: DENSITY = 1e13_c_double        ! summits [1/m^2]
  real(c_double), parameter :: NOMINAL_AREA = 1e-8_c_double   ! [m^2]

  integer :: loads
  real(c_double) :: lowest, highest
  type(friction_model) :: law

  call read_options(loads, lowest, highest)
  call law%create(polysilicon())
  call print_table
  call print_warnings
  call law%free()

contains

  function polysilicon() result(params)
    type(asperity_params) :: params
    params = asperity_params_of(E1=E, nu1=NU, E2=E, nu2=NU, work_of_adhesion=ADHESION, adhesion_range=BURGERS, &
                                burgers_vector=BURGERS, height_std=SIGMA, summit_radius=RADIUS, &
                                asperity_count=DENSITY * NOMINAL_AREA)
    params%nominal_area = NOMINAL_AREA  ! this and the hardness are for warnings alone
    params%hardness = HARDNESS
  end function polysilicon

  ! Loads are evenly spaced in the logarithm.
  subroutine print_table
    type(asperity_state) :: state
    real(c_double) :: load
    integer :: i
    write (*, '(a)') '# load [N], mu, friction force [N], real area [m^2], contacts'
    do i = 0, loads - 1
      load = lowest * (highest / lowest)**(real(i, c_double) / (loads - 1))
      call law%state_at_load(load, state)
      write (*, '(a)') as_c_prints(load) // ' ' // as_c_prints(law%friction_at_load(load)) // ' ' // &
                       as_c_prints(law%friction_force_at_load(load)) // ' ' // as_c_prints(state%real_area) // ' ' // &
                       as_c_prints(state%contacting)
    end do
  end subroutine print_table

  ! Says what of the model does not hold at the loads of the table, and what to do about it.
  subroutine print_warnings
    integer(c_int64_t) :: warnings
    integer :: bit
    warnings = 0
    call law%check_loads(lowest, highest, warnings)
    do bit = 0, 62
      if (btest(warnings, bit)) &
        write (error_unit, '(a)') 'friction_curve: warning: ' // asperity_warning_text(shiftl(1_c_int64_t, bit))
    end do
  end subroutine print_warnings

  ! C's %.9e: an exponent of two digits, or of three where it needs them.
  function as_c_prints(x) result(text)
    real(c_double), intent(in) :: x
    character(:), allocatable :: text
    character(20) :: field
    integer :: mark
    write (field, '(es20.9e3)') x
    field = adjustl(field)
    mark = index(field, 'E')
    text = field(:mark - 1) // 'e' // field(mark + 1:mark + 1)
    if (field(mark + 2:mark + 2) /= '0') text = text // field(mark + 2:mark + 2)
    text = text // field(mark + 3:mark + 4)
  end function as_c_prints

  subroutine read_options(loads, lowest, highest)
    integer, intent(out) :: loads
    real(c_double), intent(out) :: lowest, highest
    real(c_double) :: number
    number = 33
    lowest = 2e-4_c_double
    highest = 0.1_c_double
    if (command_argument_count() > 3) call refuse('more than three arguments')
    call read_number(1, 'LOADS', number)
    call read_number(2, 'LOWEST', lowest)
    call read_number(3, 'HIGHEST', highest)
    if (number < 2 .or. number > MAX_LOADS .or. abs(number - anint(number)) > 0) &
      call refuse('LOADS must be a whole number, 2 to 100000')
    if (lowest <= 0) call refuse('LOWEST must be > 0, the loads are evenly spaced in the logarithm')
    if (highest <= lowest) call refuse('HIGHEST must be above LOWEST')
    loads = nint(number)
  end subroutine read_options

  subroutine read_number(position, name, number)
    integer, intent(in) :: position
    character(*), intent(in) :: name
    real(c_double), intent(inout) :: number
    character(64) :: text
    integer :: failed
    if (position > command_argument_count()) return
    call get_command_argument(position, text)
    read (text, *, iostat=failed) number
    if (failed /= 0) call refuse(name // " = '" // trim(text) // "': must be a number")
    if (.not. abs(number) <= huge(number)) call refuse(name // ' must be finite')
  end subroutine read_number

  subroutine refuse(why)
    character(*), intent(in) :: why
    write (error_unit, '(a)') 'friction_curve: ' // why, 'usage: friction_curve [LOADS [LOWEST [HIGHEST]]]'
    stop 2
  end subroutine refuse

end program friction_curve
