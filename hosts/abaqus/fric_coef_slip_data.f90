! Abaqus/Standard, *FRICTION, USER=COEFFICIENT, in releases whose manual has slipData(nBlock,6), fCoef(nBlock,2) and
! fCoefDeriv(nBlock,20,2). Isotropic: the second direction is not touched.
! props(1)  number of the surface, in surfaces.f90
subroutine fric_coef(fCoef, fCoefDeriv, nBlock, nProps, nTemp, nFields, iData, rData, surfInt, surfSec, surfMain, &
                     props, slipData, pressure, tempAvg, fieldAvg)
  use asperity_models, only: friction_coefficients
  include 'aba_param.inc'
  dimension fCoef(nBlock, 2), fCoefDeriv(nBlock, 20, 2), props(nProps), slipData(nBlock, 6), pressure(nBlock), &
            tempAvg(nBlock), fieldAvg(nBlock, nFields), iData(*), rData(*)
  character(80) :: surfInt, surfSec, surfMain
  integer, parameter :: ISOTROPIC = 1, PRESSURE_DERIVATIVE = 2
  fCoefDeriv(:, :, ISOTROPIC) = 0  ! the law knows neither slip rate nor temperature nor fields
  call friction_coefficients(props(1), pressure, fCoef(:, ISOTROPIC), fCoefDeriv(:, PRESSURE_DERIVATIVE, ISOTROPIC))
end subroutine fric_coef
