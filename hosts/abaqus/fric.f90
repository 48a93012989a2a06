! Abaqus/Standard, *FRICTION, USER: the whole shear behaviour, with its consistent tangent.
!
! PROPERTIES=1: microslip. The summits slip one after the other, and STATEV holds how far each part of them is sheared; the
! library makes the step. PROPERTIES=2: elastic stick and slip by return mapping. The stress grows with the stiffness k
! until it reaches the shear strength F(p) of the law, and then follows it:
!   trial = tau + k dgam    stick: tau = trial                 slip: tau = F n,  n = trial/|trial|
!                           dtau/ddgam = k I                   dtau/ddgam = k F/|trial| (I - n n')
!                           dtau/dp = 0                        dtau/dp = F'(p) n,  F' = mu + p dmu/dp
! props(1)  number of the surface, in surfaces.f90
! props(2)  k [stress/length], > 0: how stiffly contact points stick; absent for microslip
subroutine fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, dgam, taulm, press, dpress, ddpddh, &
                slip, kstep, kinc, time, dtime, noel, ciname, slname, msname, npt, node, npatch, coords, rcoord, drot, &
                temp, predef, nfdir, mcrd, npred, nstatv, chrlngth, props, nprops)
  use asperity_models, only: microslip, microslip_step, microslip_length, shear_strength
  include 'aba_param.inc'
  character(80) :: ciname, slname, msname
  dimension tau(nfdir), ddtddg(nfdir, nfdir), ddtddp(nfdir), dslip(nfdir), ddtddt(nfdir, 2), statev(*), dgam(nfdir), &
            taulm(nfdir), slip(nfdir), time(2), coords(mcrd), rcoord(mcrd), drot(2, 2), temp(2), predef(2, *), &
            props(nprops)
  integer, parameter :: RELATIVE_MOTION = 0, FRICTIONLESS = 2
  double precision :: trial(nfdir), direction(nfdir), stiffness, trial_size, strength, slope
  integer :: i
  interface
    subroutine stop_analysis(message)
      character(*), intent(in) :: message
    end subroutine stop_analysis
  end interface

  if (nprops < 1) call stop_analysis('*FRICTION, USER needs PROPERTIES=1, the number of the surface')
  if (nprops == 1) then
    call remembered_step
    return
  end if
  stiffness = props(2)
  if (.not. stiffness > 0) call stop_analysis('the second property of *FRICTION, the stick stiffness, must be > 0')
  if (lm == FRICTIONLESS) return  ! open when the increment began: the manual advises to leave it so, to converge
  call shear_strength(props(1), press, strength, slope)
  if (strength <= 0) then         ! apart
    lm = FRICTIONLESS
    return
  end if

  lm = RELATIVE_MOTION
  trial = tau + stiffness * dgam
  trial_size = norm2(trial)
  ddtddg = 0
  if (trial_size <= strength) then
    tau = trial
    do i = 1, nfdir
      ddtddg(i, i) = stiffness
    end do
    ddtddp = 0
    dslip = 0
    sed = trial_size**2 / (2 * stiffness)
    sfd = 0
  else
    direction = trial / trial_size
    tau = strength * direction
    do i = 1, nfdir
      ddtddg(i, :) = -direction(i) * direction
      ddtddg(i, i) = ddtddg(i, i) + 1
    end do
    ddtddg = ddtddg * (stiffness * strength / trial_size)
    ddtddp = slope * direction
    dslip = (trial_size - strength) / stiffness * direction
    sed = strength**2 / (2 * stiffness)
    sfd = strength * (trial_size - strength) / stiffness
  end if

contains

  ! Microslip: from the state when the increment began.
  subroutine remembered_step
    type(microslip) :: step
    character(120) :: wanted
    integer :: length
    length = microslip_length(props(1))
    if (nstatv < length) then
      write (wanted, '(a, i0, a, i0)') '*FRICTION, USER, PROPERTIES=1 computes microslip and needs DEPVAR=', length, &
        '; it has ', nstatv
      call stop_analysis(wanted)
    end if
    if (lm == FRICTIONLESS) then  ! open when the increment began: it has forgotten what it carried
      statev(:length) = 0
      return
    end if
    step = microslip_step(props(1), press, dgam, drot, statev(:length))
    if (step%invalid) then        ! a pressure that Newton's method will not keep: try a shorter increment
      pnewdt = 0.25d0
      return
    end if
    lm = merge(FRICTIONLESS, RELATIVE_MOTION, step%apart)
    if (step%apart) return
    dslip = dgam - (step%stress(:nfdir) - tau) / step%stick_stiffness
    tau = step%stress(:nfdir)
    ddtddg = step%by_slip(:nfdir, :nfdir)
    ddtddp = step%by_pressure(:nfdir)
    sed = dot_product(tau, tau) / (2 * step%stick_stiffness)
    sfd = step%dissipated
  end subroutine remembered_step

end subroutine fric
