! Abaqus/Standard, *FRICTION, USER: the whole shear behaviour, with its consistent tangent.
!
! Elastic stick and slip by return mapping: the stress grows with the stiffness k until it reaches the shear strength
! F(p) of the law, and then follows it:
!   trial = tau + k dgam    stick: tau = trial                 slip: tau = F n,  n = trial/|trial|
!                           dtau/ddgam = k I                   dtau/ddgam = k F/|trial| (I - n n')
!                           dtau/dp = 0                        dtau/dp = F'(p) n,  F' = mu + p dmu/dp
! props(1)  number of the surface, in surfaces.f90
! props(2)  k [stress/length], > 0: how stiffly contact points stick
subroutine fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, dgam, taulm, press, dpress, ddpddh, &
                slip, kstep, kinc, time, dtime, noel, ciname, slname, msname, npt, node, npatch, coords, rcoord, drot, &
                temp, predef, nfdir, mcrd, npred, nstatv, chrlngth, props, nprops)
  use asperity_models, only: shear_strength
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

  if (nprops < 2) call stop_analysis('*FRICTION, USER needs PROPERTIES=2: surface number, stick stiffness')
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
end subroutine fric
