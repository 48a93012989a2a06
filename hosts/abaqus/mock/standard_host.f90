! Plays Abaqus/Standard: calls the user subroutines with the published argument lists, and measures what comes back
! against the law by another path, against differences, and inside Newton iterations.
!
! usage: standard_host [unmade | surface | stiffness]    the argument provokes an error that must stop the analysis
program standard_host
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_exceptions, only: ieee_get_halting_mode, ieee_usual
  use omp_lib, only: omp_get_num_threads
  use measures
  use asperity, only: asperity_free, asperity_friction_force_at_load
  implicit none

  integer, parameter :: STICKING_OR_SLIPPING = 0, OPEN = 2
  real(c_double), parameter :: STIFFNESS = 2e5_c_double   ! of sticking [MPa/mm]
  ! Between these pressures the law holds for the surfaces [MPa]: below, few summits of the first touch, and adhesion presses
  ! those of the second together.
  real(c_double), parameter :: LIGHTEST(2) = [0.01_c_double, 0.3_c_double], HEAVIEST(2) = [50.0_c_double, 0.8_c_double]
  real(c_double), parameter :: ANY_PRESSURE(1) = 1
  external :: uexternaldb, ask_fric_coef
  real(c_double) :: time(2), mu(1), slope(1)
  character(20) :: provoked
  logical :: untouched

  time = 0
  call get_command_argument(1, provoked)
  if (provoked /= 'unmade') call uexternaldb(0, 0, time, 0d0, 1, 0)
  select case (provoked)
  case ('unmade')
    call ask_fric_coef(1d0, ANY_PRESSURE, 1, mu, slope, untouched)
  case ('surface')
    call ask_fric_coef(3d0, ANY_PRESSURE, 1, mu, slope, untouched)
  case ('stiffness')
    call slide_once(-1d0)
  case default
    call check_pressures(1, LIGHTEST(1), HEAVIEST(1))
    call check_pressures(2, LIGHTEST(2), HEAVIEST(2))
    call coefficients
    call tractions
    call tangents
    call ends
    call newton
    call threads
    call uexternaldb(3, 0, time, 0d0, 1, 9)
    call finish
  end select

contains

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

  ! Calls FRIC with its whole argument list.
  subroutine point(nfdir, surface, stiffness, pressure, slip_increment, lm, tau, ddtddg, ddtddp)
    integer, intent(in) :: nfdir, surface
    real(c_double), intent(in) :: stiffness, pressure, slip_increment(nfdir)
    integer, intent(inout) :: lm
    real(c_double), intent(inout) :: tau(nfdir)
    real(c_double), intent(out) :: ddtddg(nfdir, nfdir), ddtddp(nfdir)
    real(c_double) :: dslip(nfdir), sed, sfd, ddtddt(nfdir, 2), pnewdt, statev(1), taulm(nfdir), slip(nfdir)
    real(c_double) :: time(2), coords(3), rcoord(3), drot(2, 2), temp(2), predef(2, 1), props(2)
    character(80) :: names(3)
    external :: fric
    props = [dble(surface), stiffness]
    ddtddg = 0
    ddtddp = 0
    dslip = 0
    sed = 0
    sfd = 0
    ddtddt = 0
    pnewdt = 1
    statev = 0
    taulm = 0
    slip = 0
    time = 0
    coords = 0
    rcoord = 0
    drot = reshape([1d0, 0d0, 0d0, 1d0], [2, 2])
    temp = 293
    predef = 0
    names = ['RUBBING', 'PAD    ', 'DISC   ']
    call fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, slip_increment, taulm, pressure, 0d0, &
              0d0, slip, 1, 1, time, 1d-3, 1, names(1), names(2), names(3), 1, 1, 1, coords, rcoord, drot, temp, &
              predef, nfdir, 3, 1, 1, 1d0, props, 2)
  end subroutine point

end program standard_host

! The utility routines of Abaqus/Standard that the user subroutines call.
subroutine stdb_abqerr(lop, message, integers, reals, texts)
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  integer, intent(in) :: lop, integers(*)
  character(*), intent(in) :: message
  double precision, intent(in) :: reals(*)
  character(8), intent(in) :: texts(*)
  if (lop /= -2) error stop 1
  write (error_unit, '(a)') '***ERROR: ' // trim(message)
end subroutine stdb_abqerr

subroutine xit
  stop 7
end subroutine xit
