! Calls FRIC_COEF as releases with slipRate do.
subroutine ask_fric_coef(surface, pressure, n, mu, slope, untouched)
  implicit none
  integer, intent(in) :: n
  double precision, intent(in) :: surface, pressure(n)
  double precision, intent(out) :: mu(n), slope(n)
  logical, intent(out) :: untouched  ! the derivatives by slip rate and temperature are zero
  double precision :: fCoef(n), fCoefDeriv(n, 3), props(1), slipRate(n), tempAvg(n), fieldAvg(n, 1), rData(3)
  integer :: jFlags(2)
  character(80) :: surfInt, surfSlv, surfMst
  external :: fric_coef
  fCoef = -7
  fCoefDeriv = -7
  props = surface
  slipRate = 1
  tempAvg = 293
  fieldAvg = 0
  jFlags = [1, 1]
  rData = [0d0, 0d0, 1d-3]
  surfInt = 'RUBBING'
  surfSlv = 'PAD'
  surfMst = 'DISC'
  call fric_coef(fCoef, fCoefDeriv, n, 1, 1, 1, jFlags, rData, surfInt, surfSlv, surfMst, props, slipRate, pressure, &
                 tempAvg, fieldAvg)
  mu = fCoef
  slope = fCoefDeriv(:, 2)
  untouched = all(abs(fCoefDeriv(:, 1)) <= 0) .and. all(abs(fCoefDeriv(:, 3)) <= 0)
end subroutine ask_fric_coef
