! One model for each surface, made once at the start of the analysis and shared by all threads.
!
! make_models is called by UEXTERNALDB or VEXTERNALDB before there are contact points, so on one thread. From then on
! the models are only read, which needs no lock. Nothing is made on demand: a friction routine that finds no model
! stops the analysis and says why.
module asperity_models
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
  use asperity, only: asperity_check, asperity_microslip, asperity_params, asperity_params_init, asperity_params_read, &
    asperity_params_set_units, asperity_warning_text, ASPERITY_INVALID_PARAMETER, ASPERITY_SEPARATED, friction_model
  use asperity_surfaces, only: MOST_FRICTION, PRESSURES, SURFACES, UNIT_OF_FORCE, UNIT_OF_LENGTH
  implicit none
  private
  public :: make_models, free_models, read_surface, friction_coefficients, shear_strength, microslip_length, microslip_step

  ! A step of a point whose summits slip one after the other.
  type, public :: microslip
    real(c_double) :: stress(2)           ! that resists
    real(c_double) :: by_slip(2, 2)       ! d(stress)/d(slip increment) [stress/length]
    real(c_double) :: by_pressure(2)      ! d(stress)/d(pressure) [-]
    real(c_double) :: stick_stiffness     ! while all summits stick [stress/length]
    real(c_double) :: dissipated          ! in this step, for the area [force/length]
    logical :: apart = .false., invalid = .false.
  end type microslip

  integer, parameter :: NUMBER_OF_SURFACES = size(SURFACES)
  type(friction_model), save :: laws(NUMBER_OF_SURFACES)
  real(c_double), save :: nominal_areas(NUMBER_OF_SURFACES)
  logical, save :: made = .false.
  character(600), save :: refusal = 'no model was made: call make_models of module asperity_models at the start ' // &
                                    'of the analysis, from UEXTERNALDB (LOP = 0 and 4) or VEXTERNALDB (lOp = 0)'

  interface
    ! Prints the message and stops the analysis; of the host, in standard.f90 or explicit.f90.
    subroutine stop_analysis(message)
      character(*), intent(in) :: message
    end subroutine stop_analysis

    ! Prints the message; severity -1: a warning.
    subroutine tell_analysis(severity, message)
      integer, intent(in) :: severity
      character(*), intent(in) :: message
    end subroutine tell_analysis
  end interface

contains

  ! refused  .true. if a surface was; the first call of a friction routine then stops the analysis with the message
  subroutine make_models(refused)
    logical, intent(out) :: refused
    type(asperity_params) :: params
    character(500) :: message
    integer :: number, stat
    refused = .false.
    call free_models    ! of an analysis before this one in the process, whose files may have been others
    do number = 1, NUMBER_OF_SURFACES
      call read_surface(number, params, stat, message)
      if (stat == 0) call laws(number)%create(params, stat, message)
      nominal_areas(number) = params%nominal_area
      if (stat == 0) call warn(number, stat, message)
      if (stat == 0) cycle
      write (refusal, '(a, i0, 2a)') 'surface ', number, ': ', trim(message)
      refused = .true.
      return
    end do
    made = .true.
  end subroutine make_models

  ! Warns where the law does not hold for a surface at the pressures that it is to meet.
  subroutine warn(number, stat, message)
    integer, intent(in) :: number
    integer, intent(out) :: stat
    character(*), intent(inout) :: message
    integer(c_int64_t) :: warnings
    integer :: bit
    character(20) :: named
    call laws(number)%check_loads(PRESSURES(1, number) * nominal_areas(number), PRESSURES(2, number) * nominal_areas(number), &
                                  warnings, stat, message)
    if (stat /= 0) return
    write (named, '(a, i0, a)') 'surface ', number, ': '
    do bit = 0, 62
      if (btest(warnings, bit)) call tell_analysis(-1, trim(named) // ' ' // asperity_warning_text(shiftl(1_c_int64_t, bit)))
    end do
  end subroutine warn

  ! The parameters of a surface file, in the units of the model. A pressure is the load on nominal_area.
  subroutine read_surface(number, params, stat, message)
    integer, intent(in) :: number
    type(asperity_params), intent(out) :: params
    integer, intent(out) :: stat
    character(*), intent(inout) :: message
    call asperity_check(asperity_params_init(params))
    call asperity_params_read(params, trim(SURFACES(number)), stat, message)
    if (stat == 0 .and. .not. params%nominal_area > 0) then
      stat = ASPERITY_INVALID_PARAMETER
      message = trim(SURFACES(number)) // ': nominal_area must be given, on which the summits lie'
    end if
    if (stat /= 0) return
    call asperity_check(asperity_params_set_units(params, UNIT_OF_LENGTH, UNIT_OF_FORCE))
    params%max_friction_coefficient = min(params%max_friction_coefficient, MOST_FRICTION)
  end subroutine read_surface

  subroutine free_models
    integer :: number
    made = .false.
    do number = 1, NUMBER_OF_SURFACES
      call laws(number)%free()
    end do
  end subroutine free_models

  ! Friction coefficients [-] and their slopes d(mu)/dp [1/stress] at pressures [stress].
  subroutine friction_coefficients(surface, pressure, mu, slope)
    real(c_double), intent(in) :: surface  ! its number, as a property of the input file
    real(c_double), intent(in), contiguous :: pressure(:)
    real(c_double), intent(out), contiguous :: mu(:), slope(:)
    integer :: number, stat
    mu = 0
    slope = 0
    if (.not. is_ready(surface)) return
    number = nint(surface)
    ! With stat a pressure that is NaN gives NaN, and does not stop the program.
    mu = laws(number)%friction_at_load(pressure * nominal_areas(number), slope, stat)
    slope = slope * nominal_areas(number)
  end subroutine friction_coefficients

  ! Shear stress that slips [stress] at a pressure [stress], and its slope [-]. Adhesion makes it positive also at zero
  ! pressure.
  subroutine shear_strength(surface, pressure, strength, slope)
    real(c_double), intent(in) :: surface, pressure
    real(c_double), intent(out) :: strength, slope
    integer :: number, stat
    strength = 0
    slope = 0
    if (.not. is_ready(surface)) return
    number = nint(surface)
    strength = laws(number)%friction_force_at_load(pressure * nominal_areas(number), slope, stat) / nominal_areas(number)
    slope = min(slope, huge(slope))  ! infinite at the pull-off pressure itself
  end subroutine shear_strength

  ! How many numbers a point remembers: DEPVAR.
  integer function microslip_length(surface)
    real(c_double), intent(in) :: surface
    microslip_length = 0
    if (is_ready(surface)) microslip_length = laws(nint(surface))%microslip_length()
  end function microslip_length

  ! Moves a point on by a slip increment [length], one number or two, at a pressure [stress].
  ! rotation  of the directions of friction in this increment
  ! state     what the point remembers; as it was if the step is invalid
  function microslip_step(surface, pressure, slip, rotation, state) result(step)
    real(c_double), intent(in) :: surface, pressure, slip(:), rotation(2, 2)
    real(c_double), intent(inout) :: state(:)
    type(microslip) :: step
    type(asperity_microslip) :: out
    real(c_double) :: increment(2), before(size(state)), after(size(state)), area
    integer :: number, status
    step%invalid = .true.
    if (.not. is_ready(surface)) return
    number = nint(surface)
    area = nominal_areas(number)
    increment = 0
    increment(:size(slip)) = slip
    before = state
    call laws(number)%microslip_turn(before, rotation(1, 1), rotation(2, 1), status)
    step%invalid = status /= 0
    if (step%invalid) return
    call laws(number)%microslip_step(pressure * area, increment, before, after, out, status)
    step%apart = status == ASPERITY_SEPARATED
    step%invalid = status /= 0 .and. .not. step%apart
    if (step%invalid) return
    state = after
    step%stress = out%force / area
    step%by_slip = reshape(out%stiffness, [2, 2]) / area
    step%by_pressure = out%dforce_dload
    step%stick_stiffness = laws(number)%tangential_stiffness_at_load(pressure * area, status) / area
    step%dissipated = out%dissipated / area
    step%apart = step%apart .or. step%stick_stiffness <= 0    ! also at no pressure, where nothing adheres
  end function microslip_step

  function is_ready(surface)
    real(c_double), intent(in) :: surface
    logical :: is_ready
    character(160) :: message
    is_ready = made .and. abs(surface - anint(surface)) <= 0 .and. &
               surface >= 1 .and. surface <= NUMBER_OF_SURFACES
    if (is_ready) return
    if (.not. made) call stop_analysis(refusal)
    write (message, '(a, g0.6, a, i0, a)') 'the first property of *FRICTION is ', surface, &
      ': it must be the number of a surface of surfaces.f90, 1 to ', NUMBER_OF_SURFACES, ', and PROPERTIES= its count'
    if (made) call stop_analysis(message)
  end function is_ready

end module asperity_models
