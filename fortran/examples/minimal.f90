! The friction of one surface pair at three loads.
program minimal
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity
  implicit none
  type(asperity_params) :: params
  type(friction_model) :: law
  real(c_double) :: load(3), mu(3), slope(3)

  call asperity_check(asperity_params_init(params))
  call law%create(params)
  load = [1.0_c_double, 10.0_c_double, 100.0_c_double]
  mu = law%friction_at_load(load, slope)
  write (*, '(3f12.4)') load, mu
  write (*, '(3es12.3)') slope
end program minimal
