! Abaqus/Explicit, *FRICTION, USER=COEFFICIENT. The arrays have the precision that vaba_param.inc gives them, single
! unless the job runs with double=explicit; the law is evaluated in double precision either way.
! props(1)  number of the surface, in surfaces.f90
subroutine vfric_coef(fCoef, fCoefDeriv, nBlock, nProps, nTemp, nFields, jFlags, rData, surfInt, surfSlv, surfMst, &
                      props, slipRate, pressure, tempAvg, fieldAvg)
  use asperity_models, only: friction_coefficients
  include 'vaba_param.inc'
  dimension fCoef(nBlock), fCoefDeriv(nBlock, 3), props(nProps), slipRate(nBlock), pressure(nBlock), &
            tempAvg(nBlock), fieldAvg(nBlock, nFields), jFlags(2), rData(3)
  character(80) :: surfInt, surfSlv, surfMst
  integer, parameter :: PRESSURE_DERIVATIVE = 2
  double precision :: mu(nBlock), slope(nBlock), largest
  largest = dble(huge(fCoef))
  call friction_coefficients(dble(props(1)), dble(pressure), mu, slope)
  fCoefDeriv = 0  ! the law knows neither slip rate nor temperature
  fCoef = real(min(mu, largest), kind(fCoef))
  fCoefDeriv(:, PRESSURE_DERIVATIVE) = real(max(-largest, min(slope, largest)), kind(fCoef))
end subroutine vfric_coef
