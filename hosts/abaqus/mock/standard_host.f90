! Plays Abaqus/Standard: calls the user subroutines with the published argument lists, and measures what comes back
! against the law by another path, against differences, and inside Newton iterations.
!
! usage: standard_host [unmade | surface | stiffness | depvar]    the argument provokes an error that must stop the analysis
!        standard_host analyses FOLDER...    one analysis after another with the surface files of these folders; - for one that
!                                            does not end before the next begins, restart for one that goes on
program standard_host
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  use, intrinsic :: ieee_exceptions, only: ieee_get_halting_mode, ieee_usual
  use omp_lib, only: omp_get_num_threads
  use measures
  use asperity, only: asperity_free, asperity_friction_force_at_load, asperity_tangential_at_load, &
    asperity_tangential_stiffness_at_load
  implicit none

  integer, parameter :: STICKING_OR_SLIPPING = 0, OPEN = 2
  real(c_double), parameter :: STIFFNESS = 2e5_c_double   ! of sticking [MPa/mm]
  integer, parameter :: MOST_REMEMBERED = 200             ! numbers of a point, at most
  ! Between these pressures the law holds for the surfaces [MPa]: below, few summits of the first touch, and adhesion presses
  ! those of the second together.
  real(c_double), parameter :: LIGHTEST(2) = [0.01_c_double, 0.3_c_double], HEAVIEST(2) = [50.0_c_double, 0.8_c_double]
  real(c_double), parameter :: ANY_PRESSURE(1) = 1
  external :: uexternaldb, ask_fric_coef
  real(c_double) :: time(2), mu(1), slope(1)
  character(20) :: provoked
  logical :: untouched
  logical :: shorter = .false.  ! FRIC has asked for a shorter increment

  time = 0
  call get_command_argument(1, provoked)
  if (provoked == 'analyses') then
    call analyses
    stop
  end if
  if (provoked /= 'unmade') call uexternaldb(0, 0, time, 0d0, 1, 0)
  select case (provoked)
  case ('unmade')
    call ask_fric_coef(1d0, ANY_PRESSURE, 1, mu, slope, untouched)
  case ('surface')
    call ask_fric_coef(3d0, ANY_PRESSURE, 1, mu, slope, untouched)
  case ('stiffness')
    call slide_once(-1d0)
  case ('depvar')
    call slide_remembering(length=1)
  case default
    call check_pressures(1, LIGHTEST(1), HEAVIEST(1))
    call check_pressures(2, LIGHTEST(2), HEAVIEST(2))
    call coefficients
    call tractions
    call tangents
    call ends
    call newton
    call microslip_tractions
    call microslip_tangents
    call microslip_ends
    call block_under_load
    call threads
    call check('increments are computed as they are asked for', .not. shorter)
    call uexternaldb(3, 0, time, 0d0, 1, 9)
    call finish
  end select

contains

  ! Prints what both surfaces have at a pressure, in MPa, with microslip to and fro too, in each analysis of this process.
  subroutine analyses
    use asperity_surfaces, only: UNIT_OF_FORCE, UNIT_OF_LENGTH
    real(c_double), parameter :: MEGAPASCAL = 1e6_c_double * UNIT_OF_LENGTH**2 / UNIT_OF_FORCE
    real(c_double), parameter :: NANOMETRE = 1e-9_c_double / UNIT_OF_LENGTH
    character(400) :: folder, next
    real(c_double) :: tau(1), slid(1), ddtddg(1, 1), ddtddp(1), state(MOST_REMEMBERED)
    integer :: k, surface, lm, lop
    interface
      integer(c_int) function chdir(path) bind(c)
        import :: c_char, c_int
        character(kind=c_char), intent(in) :: path(*)
      end function chdir
    end interface
    lop = 0
    do k = 2, command_argument_count()
      call get_command_argument(k, folder)
      if (folder == 'restart') lop = 4
      if (folder == '-' .or. folder == 'restart') cycle
      if (chdir(trim(folder) // c_null_char) /= 0) error stop 1
      call uexternaldb(lop, 0, time, 0d0, 1, 0)
      lop = 0
      do surface = 1, 2
        call ask_fric_coef(dble(surface), [0.5_c_double * MEGAPASCAL], 1, mu, slope, untouched)
        lm = 0
        slid = 0
        call point(1, surface, STIFFNESS, 0.5_c_double * MEGAPASCAL, [1d12], lm, slid, ddtddg, ddtddp)
        tau = 0
        state = 0
        call remembering(1, surface, 0.5_c_double * MEGAPASCAL, [20 * NANOMETRE], lm, tau, ddtddg, ddtddp, state)
        call remembering(1, surface, 0.4_c_double * MEGAPASCAL, [-5 * NANOMETRE], lm, tau, ddtddg, ddtddp, state)
        write (*, '(i2, 4es24.15)') surface, mu, slope * MEGAPASCAL, slid / MEGAPASCAL, tau / MEGAPASCAL
      end do
      call get_command_argument(k + 1, next)
      if (next /= '-') call uexternaldb(3, 0, time, 0d0, 1, 9)
    end do
  end subroutine analyses

  ! mu(p) and its slope, in blocks, against the patch.
  subroutine coefficients
    integer, parameter :: N = 45
    real(c_double) :: pressure(N), mu(N), slope(N), mu_error, slope_error, step
    type(c_ptr) :: patch
    integer :: surface, i, k
    logical :: untouched
    mu_error = 0
    slope_error = 0
    do surface = 1, 2
      patch = patch_law(surface)
      pressure = [(HEAVIEST(surface) * 1.2_c_double**(-i), i=1, N)]
      call ask_fric_coef(dble(surface), pressure, N, mu, slope, untouched)
      call check('FRIC_COEF leaves alone what is not its own', untouched)
      do i = 1, N
        call worse(mu_error, abs(mu(i) / patch_friction(patch, pressure(i)) - 1))
        step = pressure(i) / 100
        if (mu(i) >= 100) cycle
        call worse(slope_error, abs(slope(i) / difference([(patch_friction(patch, pressure(i) + k * step), k=-2, -1), &
                                (patch_friction(patch, pressure(i) + k * step), k=1, 2)], step) - 1))
      end do
      call asperity_free(patch)
    end do
    call largest('mu', mu_error, 1e-12_c_double)
    call largest('tangent', slope_error, 1e-6_c_double)
  end subroutine coefficients

  ! Slid far, a point carries t = mu(p) p against the slip.
  subroutine tractions
    real(c_double) :: tau(2), ddtddg(2, 2), ddtddp(2), pressure, error, along
    real(c_double), parameter :: SLIP(2) = [3e-3_c_double, -4e-3_c_double]
    type(c_ptr) :: patch
    integer :: surface, i, lm
    error = 0
    do surface = 1, 2
      patch = patch_law(surface)
      do i = 1, 30
        pressure = HEAVIEST(surface) * 1.25_c_double**(-i)
        tau = 0
        lm = 1
        call point(2, surface, STIFFNESS * pressure, pressure, SLIP, lm, tau, ddtddg, ddtddp)
        along = dot_product(tau, SLIP) / 5e-3_c_double
        call worse(error, abs(along / pressure / patch_friction(patch, pressure) - 1))
        call worse(error, abs(norm2(tau) / along - 1))
        call check('a slipping point is reported as moving', lm == STICKING_OR_SLIPPING)
      end do
      call asperity_free(patch)
    end do
    call largest('mu', error, 1e-12_c_double)
  end subroutine tractions

  ! DDTDDG and DDTDDP against differences of TAU, in stick and in slip, in two and in three dimensions.
  subroutine tangents
    real(c_double) :: before(2), slip(2), error, pressure, reach
    integer :: i, nfdir, sticking, slipping
    error = 0
    sticking = 0
    slipping = 0
    do i = 1, 24
      pressure = 0.1_c_double * 1.25_c_double**i
      before = 0.1_c_double * pressure * [cos(0.9_c_double * i), sin(0.9_c_double * i)]
      reach = pressure / STIFFNESS * merge(0.05_c_double, 4.0_c_double, mod(i, 2) == 0)
      slip = reach * [cos(2.3_c_double * i), sin(2.3_c_double * i)]
      do nfdir = 1, 2
        call worse(error, tangent_error(nfdir, pressure, before(:nfdir), slip(:nfdir), sticking, slipping))
      end do
    end do
    call check('both stick and slip are met', sticking > 10 .and. slipping > 10)
    call largest('tangent', error, 1e-6_c_double)
  end subroutine tangents

  function tangent_error(nfdir, pressure, before, slip, sticking, slipping) result(error)
    integer, intent(in) :: nfdir
    real(c_double), intent(in) :: pressure, before(nfdir), slip(nfdir)
    integer, intent(inout) :: sticking, slipping
    real(c_double) :: error, step, scale
    real(c_double) :: tau(nfdir), ddtddg(nfdir, nfdir), ddtddp(nfdir), values(nfdir, 4), unused(nfdir, nfdir)
    real(c_double) :: moved(nfdir), not_needed(nfdir)
    integer, parameter :: AT(4) = [-2, -1, 1, 2]
    integer :: i, j, k, lm
    lm = 0
    tau = before
    call point(nfdir, 1, STIFFNESS, pressure, slip, lm, tau, ddtddg, ddtddp)
    if (all(abs(ddtddp) <= 0)) then
      sticking = sticking + 1
    else
      slipping = slipping + 1
    end if
    error = 0
    scale = maxval(abs(ddtddg)) + STIFFNESS * 1e-9_c_double
    do j = 1, nfdir
      step = 2e-3_c_double * norm2(slip)
      do k = 1, 4
        moved = slip
        moved(j) = moved(j) + AT(k) * step
        values(:, k) = before
        call point(nfdir, 1, STIFFNESS, pressure, moved, lm, values(:, k), unused, not_needed)
      end do
      do i = 1, nfdir
        call worse(error, abs(ddtddg(i, j) - difference(values(i, :), step)) / scale)
      end do
    end do
    step = 1e-2_c_double * pressure
    do k = 1, 4
      values(:, k) = before
      call point(nfdir, 1, STIFFNESS, pressure + AT(k) * step, slip, lm, values(:, k), unused, not_needed)
    end do
    scale = maxval(abs(ddtddp)) + 1e-9_c_double
    do i = 1, nfdir
      call worse(error, abs(ddtddp(i) - difference(values(i, :), step)) / scale)
    end do
  end function tangent_error

  ! Open points, adhesion at no pressure, and pressure below pull-off.
  subroutine ends
    real(c_double) :: tau(1), ddtddg(1, 1), ddtddp(1)
    type(c_ptr) :: patch
    integer :: lm
    real(c_double), parameter :: SLIP(1) = 1
    lm = OPEN
    tau = 0
    call point(1, 1, STIFFNESS, 1d0, SLIP, lm, tau, ddtddg, ddtddp)
    call check('a point that was open stays without friction for the increment', lm == OPEN .and. abs(tau(1)) <= 0)
    patch = patch_law(2)
    lm = 0
    call point(1, 2, STIFFNESS, 0d0, SLIP, lm, tau, ddtddg, ddtddp)
    call check('adhesion gives friction at no pressure', &
               abs(tau(1) * patch_area / asperity_friction_force_at_load(patch, 0d0) - 1) < 1e-12_c_double)
    call asperity_free(patch)
    lm = 0
    call point(1, 2, STIFFNESS, -1d6, SLIP, lm, tau, ddtddg, ddtddp)
    call check('below pull-off there is none', lm == OPEN)
    lm = 0
    call point(1, 1, STIFFNESS, 0d0, SLIP, lm, tau, ddtddg, ddtddp)
    call check('rough surfaces have none at no pressure', lm == OPEN)
  end subroutine ends

  ! A node that is pressed and dragged through springs, one of them inclined, so that its pressure depends on where it
  ! is. Each increment must converge as Newton's method does, which only a consistent tangent gives.
  subroutine newton
    integer, parameter :: INCREMENTS = 40, ENOUGH = 8
    real(c_double), parameter :: SPRING = 2e4_c_double, NORMAL = 5e4_c_double, INCLINED = 1.5e3_c_double
    real(c_double) :: u(3), previous(3), tau(2), held(2), residual(3), tangent(3, 3), ddtddg(2, 2), ddtddp(2)
    real(c_double) :: drag(2), pressure, error
    integer :: increment, iteration, most, lm
    u = [0d0, 0d0, 1e-4_c_double]
    held = 0
    most = 0
    error = 0
    do increment = 1, INCREMENTS
      drag = 1e-2_c_double * [sin(0.3_c_double * increment), 1 - cos(0.2_c_double * increment)]
      previous = u
      do iteration = 1, ENOUGH
        pressure = NORMAL * u(3)
        tau = held
        lm = 0
        call point(2, 1, STIFFNESS, pressure, u(1:2) - previous(1:2), lm, tau, ddtddg, ddtddp)
        residual(1:2) = tau + SPRING * (u(1:2) - drag)
        residual(3) = pressure - 20 - INCLINED * u(1)
        if (norm2(residual) <= 1e-11_c_double * pressure) exit
        tangent = 0
        tangent(1:2, 1:2) = ddtddg
        tangent(1, 1) = tangent(1, 1) + SPRING
        tangent(2, 2) = tangent(2, 2) + SPRING
        tangent(1:2, 3) = NORMAL * ddtddp
        tangent(3, 3) = NORMAL
        tangent(3, 1) = -INCLINED
        u = u - solution(tangent, residual)
      end do
      most = max(most, iteration)
      call check('Newton converges', iteration <= ENOUGH)
      call worse(error, norm2(residual) / pressure)
      held = tau
    end do
    write (*, '(a, i0)') 'iterations ', most - 1
    call check('the node slid', norm2(u(1:2)) > 1e-3_c_double)
    call largest('residual', error, 1e-11_c_double)
  end subroutine newton

  ! Cramer's rule.
  pure function solution(a, b) result(x)
    real(c_double), intent(in) :: a(3, 3), b(3)
    real(c_double) :: x(3), replaced(3, 3)
    integer :: i
    do i = 1, 3
      replaced = a
      replaced(:, i) = b
      x(i) = determinant(replaced) / determinant(a)
    end do
  end function solution

  pure function determinant(a) result(d)
    real(c_double), intent(in) :: a(3, 3)
    real(c_double) :: d
    d = a(1, 1) * (a(2, 2) * a(3, 3) - a(2, 3) * a(3, 2)) - a(1, 2) * (a(2, 1) * a(3, 3) - a(2, 3) * a(3, 1)) + &
        a(1, 3) * (a(2, 1) * a(3, 2) - a(2, 2) * a(3, 1))
  end function determinant

  ! With microslip: at first as stiff as all summits, the law's curve on the way, its friction in the end.
  subroutine microslip_tractions
    real(c_double), parameter :: DIRECTION(2) = [0.6_c_double, -0.8_c_double]
    integer, parameter :: SURFACE = 1
    real(c_double), target :: exact
    real(c_double) :: tau(2), ddtddg(2, 2), ddtddp(2), state(MOST_REMEMBERED), pressure, error, off, along, friction, stiffness
    type(c_ptr) :: patch
    integer :: i, k, lm, status
    error = 0
    off = 0
    patch = patch_law(SURFACE)
    do i = 1, 12
      pressure = HEAVIEST(SURFACE) * 2d0**(-i)
      friction = asperity_friction_force_at_load(patch, pressure * patch_area) / patch_area
      stiffness = stick_stiffness(patch, pressure)
      tau = 0
      state = 0
      lm = 0
      call remembering(2, SURFACE, pressure, 1e-6_c_double * friction / stiffness * DIRECTION, lm, tau, ddtddg, ddtddp, state)
      call worse(error, abs(norm2(tau) / (1e-6_c_double * friction) - 1))
      call worse(error, abs(ddtddg(1, 1) / stiffness - 1))
      tau = 0
      state = 0
      do k = 1, 40
        call remembering(2, SURFACE, pressure, 0.05_c_double * friction / stiffness * DIRECTION, lm, tau, ddtddg, ddtddp, state)
        status = asperity_tangential_at_load(patch, pressure * patch_area, 0.05_c_double * k * friction / stiffness, &
                                             c_loc(exact), c_null_ptr)
        call worse(off, abs(norm2(tau) - exact / patch_area) / friction)
      end do
      call remembering(2, SURFACE, pressure, 100 * friction / stiffness * DIRECTION, lm, tau, ddtddg, ddtddp, state)
      along = dot_product(tau, DIRECTION)
      call worse(error, abs(along / friction - 1))
      call worse(error, abs(norm2(tau) / along - 1))
      call check('a point of microslip is reported as moving', lm == STICKING_OR_SLIPPING)
    end do
    call asperity_free(patch)
    call largest('mu', error, 1e-12_c_double)
    call largest('curve', off, 2e-2_c_double)
  end subroutine microslip_tractions

  ! DDTDDG and DDTDDP of microslip against differences of TAU: points that moved to and fro under changing pressure, some of
  ! whose summits slip.
  subroutine microslip_tangents
    real(c_double) :: tau(2), ddtddg(2, 2), ddtddp(2), state(MOST_REMEMBERED), error, pressure, reach, slip(2)
    type(c_ptr) :: patch
    integer :: i, nfdir, lm
    error = 0
    patch = patch_law(1)
    do i = 1, 24
      pressure = 0.1_c_double * 1.25_c_double**i
      reach = friction_length(patch, pressure)
      do nfdir = 1, 2
        state = 0
        tau = 0
        lm = 0
        slip = 0.7_c_double * reach * [cos(0.9_c_double * i), sin(0.9_c_double * i)]
        call remembering(nfdir, 1, pressure, slip(:nfdir), lm, tau(:nfdir), ddtddg(:nfdir, :nfdir), ddtddp(:nfdir), state)
        slip = 0.4_c_double * mod(i, 5) * reach * [cos(2.3_c_double * i + 0.1_c_double), sin(2.3_c_double * i + 0.1_c_double)]
        call worse(error, microslip_tangent_error(patch, nfdir, pressure * (1 + 0.2_c_double * sin(1.7_c_double * i)), &
                                                  slip(:nfdir), tau(:nfdir), state))
      end do
    end do
    call asperity_free(patch)
    call largest('tangent', error, 1e-6_c_double)
  end subroutine microslip_tangents

  ! While all summits stick [MPa/mm].
  function stick_stiffness(patch, pressure) result(stiffness)
    type(c_ptr), intent(in) :: patch
    real(c_double), intent(in) :: pressure
    real(c_double) :: stiffness
    stiffness = asperity_tangential_stiffness_at_load(patch, pressure * patch_area) / patch_area
  end function stick_stiffness

  ! Friction over stiffness: how far a point moves before it slips, about.
  function friction_length(patch, pressure) result(reach)
    type(c_ptr), intent(in) :: patch
    real(c_double), intent(in) :: pressure
    real(c_double) :: reach
    reach = asperity_friction_force_at_load(patch, pressure * patch_area) / patch_area / stick_stiffness(patch, pressure)
  end function friction_length

  function microslip_tangent_error(patch, nfdir, pressure, slip, tau, state) result(error)
    type(c_ptr), intent(in) :: patch
    integer, intent(in) :: nfdir
    real(c_double), intent(in) :: pressure, slip(nfdir), tau(nfdir), state(MOST_REMEMBERED)
    integer, parameter :: AT(4) = [-2, -1, 1, 2]
    real(c_double) :: error, step, by_slip(nfdir, nfdir), by_pressure(nfdir), values(nfdir, 4), moved(nfdir), now(nfdir)
    real(c_double) :: unused(nfdir, nfdir), not_needed(nfdir), after(MOST_REMEMBERED)
    integer :: i, j, k, lm
    lm = 0
    now = tau
    after = state
    call remembering(nfdir, 1, pressure, slip, lm, now, by_slip, by_pressure, after)
    error = 0
    do j = 1, nfdir
      step = 1e-6_c_double * friction_length(patch, pressure)
      do k = 1, 4
        moved = slip
        moved(j) = moved(j) + AT(k) * step
        values(:, k) = tau
        after = state
        call remembering(nfdir, 1, pressure, moved, lm, values(:, k), unused, not_needed, after)
      end do
      do i = 1, nfdir
        call worse(error, abs(by_slip(i, j) - difference(values(i, :), step)) / stick_stiffness(patch, pressure))
      end do
    end do
    step = 1e-6_c_double * pressure
    do k = 1, 4
      values(:, k) = tau
      after = state
      call remembering(nfdir, 1, pressure + AT(k) * step, slip, lm, values(:, k), unused, not_needed, after)
    end do
    do i = 1, nfdir
      call worse(error, abs(by_pressure(i) - difference(values(i, :), step)) / (norm2(now) / pressure))
    end do
  end function microslip_tangent_error

  ! With microslip: open points forget, directions that turn take along what points carry, and adhesion holds at no pressure.
  subroutine microslip_ends
    real(c_double) :: tau(2), ddtddg(2, 2), ddtddp(2), state(MOST_REMEMBERED), turned(2), turn(2, 2)
    real(c_double), parameter :: NOWHERE(2) = 0
    type(c_ptr) :: patch
    integer :: lm
    state = 1
    tau = 0
    lm = OPEN
    call remembering(2, 1, 1d0, NOWHERE, lm, tau, ddtddg, ddtddp, state)
    call check('a point that was open has forgotten what it carried', lm == OPEN .and. all(abs(state(:10)) <= 0))
    tau = 0
    state = 0
    lm = 0
    patch = patch_law(1)
    call remembering(2, 1, 1d0, 0.8_c_double * friction_length(patch, 1d0) * [1d0, 0d0], lm, tau, ddtddg, ddtddp, state)
    call asperity_free(patch)
    turn = reshape([0.6d0, 0.8d0, -0.8d0, 0.6d0], [2, 2])
    turned = matmul(turn, tau)
    tau = turned
    call remembering(2, 1, 1d0, NOWHERE, lm, tau, ddtddg, ddtddp, state, turn)
    call check('what is carried turns with the directions of friction', &
               norm2(tau - turned) <= 1e-12_c_double * norm2(turned) .and. tau(2) > 0)
    state = 0
    tau = 0
    lm = 0
    call remembering(2, 2, 0d0, [1d-3, 0d0], lm, tau, ddtddg, ddtddp, state)
    call check('adhesion gives microslip at no pressure', lm == STICKING_OR_SLIPPING .and. tau(1) > 0)
    call remembering(2, 2, -1d6, [1d-3, 0d0], lm, tau, ddtddg, ddtddp, state)
    call check('below pull-off there is no microslip, and no memory', lm == OPEN .and. all(abs(state(:10)) <= 0))
    call check('no increment was too long', .not. shorter)
    lm = 0
    tau = 1
    state = 2
    call remembering(2, 1, ieee_value(1d0, ieee_quiet_nan), [1d-6, 0d0], lm, tau, ddtddg, ddtddp, state)
    call check('where there is no pressure to compute with, FRIC asks for a shorter increment and leaves the rest', &
               shorter .and. all(abs(tau - 1) <= 0) .and. all(abs(state - 2) <= 0))
    shorter = .false.
  end subroutine microslip_ends

  ! A rigid block on four points, pulled high above them by a force that grows, turns and falls back, under a normal force
  ! that changes and that a wedge makes follow the slip: it tilts, yaws, sticks and slips. Displacements follow from forces alone,
  ! up to 80 % of gross slip and more, so that a tangent that is not consistent shows in every iteration. Points are of 1 mm^2.
  subroutine block_under_load
    integer, parameter :: POINTS = 4, INCREMENTS = 60, ENOUGH = 12
    real(c_double), parameter :: HEIGHT = 4, NORMAL = 5e4_c_double, WEDGE = 1e4_c_double    ! [mm], [MPa/mm], [N/mm]
    real(c_double), parameter :: AT(2, POINTS) = reshape([2, 1, -1, 1, -1, -1, 0, -1], [2, POINTS])    ! [mm]
    real(c_double) :: q(6), previous(6), state(MOST_REMEMBERED, POINTS), trial(MOST_REMEMBERED, POINTS), tau(2, POINTS)
    real(c_double) :: held(2, POINTS), b(3, 6), d(3, 3), f(3), load(6), residual(6), tangent(6, 6), pressure, size_now, size_before
    real(c_double) :: ratio, error, pull, weight, strength
    type(c_ptr) :: patch
    integer :: increment, iteration, most, i, lm
    q = 0
    q(3) = 5 / NORMAL
    state = 0
    held = 0
    most = 0
    ratio = 0
    error = 0
    patch = patch_law(1)
    do increment = 1, INCREMENTS
      weight = POINTS * (5 + 2 * sin(0.23_c_double * increment))
      strength = asperity_friction_force_at_load(patch, weight / POINTS * patch_area) / patch_area * POINTS
      pull = 0.8_c_double * strength * sin(0.31_c_double * increment)
      load = [pull * cos(0.05_c_double * increment), pull * sin(0.05_c_double * increment), weight, 0d0, 0d0, 0.05d0 * pull]
      previous = q
      size_before = 0
      do iteration = 1, ENOUGH
        residual = -load
        residual(3) = residual(3) - WEDGE * q(1)
        tangent = 0
        tangent(3, 1) = -WEDGE
        trial = state
        tau = held
        do i = 1, POINTS
          b = transpose(reshape([1d0, 0d0, 0d0, 0d0, -HEIGHT, -AT(2, i), 0d0, 1d0, 0d0, HEIGHT, 0d0, AT(1, i), &
                                 0d0, 0d0, 1d0, -AT(2, i), AT(1, i), 0d0], [6, 3]))
          pressure = NORMAL * dot_product(b(3, :), q)
          lm = 0
          d = 0
          call remembering(2, 1, pressure, matmul(b(1:2, :), q - previous), lm, tau(:, i), d(1:2, 1:2), d(1:2, 3), trial(:, i))
          d(1:2, 3) = NORMAL * d(1:2, 3)
          d(3, 3) = NORMAL
          f = [tau(:, i), pressure]
          residual = residual + matmul(transpose(b), f)
          tangent = tangent + matmul(transpose(b), matmul(d, b))
        end do
        size_now = norm2(residual) / weight
        write (*, '(a, i0, a, i0, es10.2)') 'residual ', increment, ' ', iteration, size_now
        if (size_before > 0 .and. size_now > 1e-12_c_double) call worse(ratio, size_now / size_before**2)
        if (size_now <= 1e-12_c_double) exit
        size_before = merge(size_now, 0d0, size_now < 1e-2_c_double)
        q = q - solved(tangent, residual)
      end do
      most = max(most, iteration)
      call check('Newton converges on the block', iteration <= ENOUGH)
      call worse(error, size_now)
      held = tau
      state = trial
    end do
    call asperity_free(patch)
    write (*, '(a, i0)') 'block_iterations ', most - 1
    call largest('quadratic', ratio, 500d0)
    call largest('residual', error, 1e-12_c_double)
  end subroutine block_under_load

  ! Gauss' elimination with pivots.
  pure function solved(matrix, right) result(x)
    real(c_double), intent(in) :: matrix(:, :), right(:)
    real(c_double) :: x(size(right)), a(size(right), size(right) + 1), row(size(right) + 1)
    integer :: i, k, n
    n = size(right)
    a(:, :n) = matrix
    a(:, n + 1) = right
    do k = 1, n
      i = k - 1 + maxloc(abs(a(k:, k)), 1)
      row = a(i, :)
      a(i, :) = a(k, :)
      a(k, :) = row / row(k)
      do i = 1, n
        if (i /= k) a(i, :) = a(i, :) - a(i, k) * a(k, :)
      end do
    end do
    x = a(:, n + 1)
  end function solved

  ! Threads share the models: every point comes out as it does alone, with traps on in every thread.
  subroutine threads
    integer, parameter :: N = 2000
    real(c_double) :: alone(2, N), together(2, N)
    integer :: i, used
    logical :: trapping, trapping_here(3)
    do i = 1, N
      alone(:, i) = shared_point(i)
    end do
    used = 1
    trapping = .true.
    !$omp parallel private(trapping_here) reduction(.and.: trapping)
    !$omp single
    used = omp_get_num_threads()
    !$omp end single
    call ieee_get_halting_mode(ieee_usual, trapping_here)
    trapping = trapping .and. all(trapping_here)
    !$omp do schedule(dynamic, 10)
    do i = 1, N
      together(:, i) = shared_point(i)
    end do
    !$omp end do
    !$omp end parallel
    call check('there are several threads', used > 1)
    call check('floating-point traps are on in every thread', trapping)
    call check('threads that share a model get what one thread gets', all(abs(together - alone) <= 0))
    write (*, '(a, i0)') 'threads ', used
  end subroutine threads

  function shared_point(i) result(answer)
    integer, intent(in) :: i
    real(c_double) :: answer(2), tau(1), ddtddg(1, 1), ddtddp(1), pressure(1), mu(1), slope(1)
    integer :: lm
    logical :: untouched
    pressure = HEAVIEST(1 + mod(i, 2)) * 1.004_c_double**(-i)
    tau = 0
    lm = 0
    call point(1, 1 + mod(i, 2), STIFFNESS, pressure(1), [1d-1], lm, tau, ddtddg, ddtddp)
    call ask_fric_coef(dble(1 + mod(i, 2)), pressure, 1, mu, slope, untouched)
    answer = [tau(1), mu(1)]
  end function shared_point

  subroutine slide_once(stiffness)
    real(c_double), intent(in) :: stiffness
    real(c_double) :: tau(1), ddtddg(1, 1), ddtddp(1)
    integer :: lm
    lm = 0
    tau = 0
    call point(1, 1, stiffness, 1d0, [1d0], lm, tau, ddtddg, ddtddp)
  end subroutine slide_once

  subroutine slide_remembering(length)
    integer, intent(in) :: length
    real(c_double) :: tau(1), ddtddg(1, 1), ddtddp(1), state(length)
    integer :: lm
    lm = 0
    tau = 0
    state = 0
    call remembering(1, 1, 1d0, [1d0], lm, tau, ddtddg, ddtddp, state)
  end subroutine slide_remembering

  ! A point with a stick stiffness: two properties, no state.
  subroutine point(nfdir, surface, stiffness, pressure, slip_increment, lm, tau, ddtddg, ddtddp)
    integer, intent(in) :: nfdir, surface
    real(c_double), intent(in) :: stiffness, pressure, slip_increment(nfdir)
    integer, intent(inout) :: lm
    real(c_double), intent(inout) :: tau(nfdir)
    real(c_double), intent(out) :: ddtddg(nfdir, nfdir), ddtddp(nfdir)
    real(c_double), parameter :: UNIT(2, 2) = reshape([1, 0, 0, 1], [2, 2])
    real(c_double) :: no_state(1)
    no_state = 0
    call call_fric(nfdir, [dble(surface), stiffness], 2, pressure, slip_increment, lm, tau, ddtddg, ddtddp, no_state, 0, UNIT)
  end subroutine point

  ! A point with microslip: one property, and the state that FRIC moves on.
  subroutine remembering(nfdir, surface, pressure, slip_increment, lm, tau, ddtddg, ddtddp, state, turn)
    integer, intent(in) :: nfdir, surface
    real(c_double), intent(in) :: pressure, slip_increment(nfdir)
    integer, intent(inout) :: lm
    real(c_double), intent(inout) :: tau(nfdir), state(:)
    real(c_double), intent(out) :: ddtddg(nfdir, nfdir), ddtddp(nfdir)
    real(c_double), intent(in), optional :: turn(2, 2)
    real(c_double) :: drot(2, 2)
    drot = reshape([1d0, 0d0, 0d0, 1d0], [2, 2])
    if (present(turn)) drot = turn
    call call_fric(nfdir, [dble(surface)], 1, pressure, slip_increment, lm, tau, ddtddg, ddtddp, state, size(state), drot)
  end subroutine remembering

  ! Calls FRIC with its whole argument list.
  subroutine call_fric(nfdir, props, nprops, pressure, slip_increment, lm, tau, ddtddg, ddtddp, statev, nstatv, drot)
    integer, intent(in) :: nfdir, nprops, nstatv
    real(c_double), intent(in) :: props(nprops), pressure, slip_increment(nfdir), drot(2, 2)
    integer, intent(inout) :: lm
    real(c_double), intent(inout) :: tau(nfdir), statev(*)
    real(c_double), intent(out) :: ddtddg(nfdir, nfdir), ddtddp(nfdir)
    real(c_double) :: dslip(nfdir), sed, sfd, ddtddt(nfdir, 2), pnewdt, taulm(nfdir), slip(nfdir)
    real(c_double) :: time(2), coords(3), rcoord(3), temp(2), predef(2, 1)
    character(80) :: names(3)
    external :: fric
    ddtddg = 0
    ddtddp = 0
    dslip = 0
    sed = 0
    sfd = 0
    ddtddt = 0
    pnewdt = 1
    taulm = 0
    slip = 0
    time = 0
    coords = 0
    rcoord = 0
    temp = 293
    predef = 0
    names = ['RUBBING', 'PAD    ', 'DISC   ']
    call fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, slip_increment, taulm, pressure, 0d0, &
              0d0, slip, 1, 1, time, 1d-3, 1, names(1), names(2), names(3), 1, 1, 1, coords, rcoord, drot, temp, &
              predef, nfdir, 3, 1, nstatv, 1d0, props, nprops)
    if (pnewdt < 1) shorter = .true.
  end subroutine call_fric

end program standard_host

! The utility routines of Abaqus/Standard that the user subroutines call.
subroutine stdb_abqerr(lop, message, integers, reals, texts)
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  integer, intent(in) :: lop, integers(*)
  character(*), intent(in) :: message
  double precision, intent(in) :: reals(*)
  character(8), intent(in) :: texts(*)
  if (lop /= -2 .and. lop /= -1) error stop 1
  write (error_unit, '(a)') trim(merge('***ERROR:  ', '***WARNING:', lop == -2)) // ' ' // trim(message)
end subroutine stdb_abqerr

subroutine xit
  stop 7
end subroutine xit
