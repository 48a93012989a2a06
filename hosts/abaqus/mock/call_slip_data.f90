! Calls FRIC_COEF as releases with slipData do.
subroutine ask_fric_coef(surface, pressure, n, mu, slope, untouched)
  implicit none
  integer, intent(in) :: n
  double precision, intent(in) :: surface, pressure(n)
  double precision, intent(out) :: mu(n), slope(n)
  logical, intent(out) :: untouched  ! what does not belong to the law is as the host left it, or zero
  double precision, parameter :: MARK = -7
  double precision :: fCoef(n, 2), fCoefDeriv(n, 20, 2), props(1), slipData(n, 6), tempAvg(n), fieldAvg(n, 1), rData(8)
  integer :: iData(6)
  character(80) :: surfInt, surfSec, surfMain
  external :: fric_coef
  fCoef = MARK
  fCoefDeriv = MARK
  props = surface
  slipData = 1
  tempAvg = 293
  fieldAvg = 0
  iData = [1, 1, 1, 1, 0, 2]
  rData = 0
  surfInt = 'RUBBING'
  surfSec = 'PAD'
  surfMain = 'DISC'
  call fric_coef(fCoef, fCoefDeriv, n, 1, 1, 1, iData, rData, surfInt, surfSec, surfMain, props, slipData, pressure, &
                 tempAvg, fieldAvg)
  mu = fCoef(:, 1)
  slope = fCoefDeriv(:, 2, 1)
  untouched = all(abs(fCoef(:, 2) - MARK) <= 0) .and. all(abs(fCoefDeriv(:, :, 2) - MARK) <= 0) .and. &
              all(abs(fCoefDeriv(:, 1, 1)) <= 0) .and. all(abs(fCoefDeriv(:, 3:, 1)) <= 0)
end subroutine ask_fric_coef
