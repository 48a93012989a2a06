! Abaqus/Standard, *FRICTION, USER=COEFFICIENT, in releases whose manual has slipRate(nBlock), fCoef(nBlock) and
! fCoefDeriv(nBlock,3).
! props(1)  number of the surface, in surfaces.f90
subroutine fric_coef(fCoef, fCoefDeriv, nBlock, nProps, nTemp, nFields, jFlags, rData, surfInt, surfSlv, surfMst, &
                     props, slipRate, pressure, tempAvg, fieldAvg)
  use asperity_models, only: friction_coefficients
  include 'aba_param.inc'
  dimension fCoef(nBlock), fCoefDeriv(nBlock, 3), props(nProps), slipRate(nBlock), pressure(nBlock), &
            tempAvg(nBlock), fieldAvg(nBlock, nFields), jFlags(2), rData(3)
  character(80) :: surfInt, surfSlv, surfMst
  integer, parameter :: PRESSURE_DERIVATIVE = 2
  fCoefDeriv = 0  ! the law knows neither slip rate nor temperature
  call friction_coefficients(props(1), pressure, fCoef, fCoefDeriv(:, PRESSURE_DERIVATIVE))
end subroutine fric_coef
