! Friction of two polysilicon surfaces on 100 um x 100 um, in SI units: N, m, Pa.
program minimal
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use asperity
  implicit none
  type(asperity_params) :: params
  type(friction_model) :: model
  real(c_double) :: load(3), mu(3), slope(3)
  integer(c_int64_t) :: warnings
  integer :: i

  params = asperity_params_of(E1=160e9_c_double, nu1=0.22_c_double, E2=160e9_c_double, nu2=0.22_c_double, &
                              work_of_adhesion=0.063_c_double, adhesion_range=0.384e-9_c_double, &
                              burgers_vector=0.384e-9_c_double, height_std=5e-9_c_double, &
                              summit_radius=1e-6_c_double, asperity_count=1e5_c_double)
  params%nominal_area = 1e-8_c_double
  params%hardness = 12e9_c_double
  ! Put your measurement here: load [N] and friction coefficient. Without one leave this line out.
  call asperity_check(asperity_params_calibrate(params, 1e-2_c_double, 0.25_c_double))

  call model%create(params)
  call model%check_loads(1e-3_c_double, 1e-1_c_double, warnings)
  if (warnings /= 0) write (error_unit, '(a)') asperity_warning_text(warnings)   ! which assumptions fail, and the remedy
  load = [1e-3_c_double, 1e-2_c_double, 1e-1_c_double]
  mu = model%friction_at_load(load, slope)
  write (*, '(a, es10.3, a, f7.4, a, es11.3)') ('load', load(i), ' N: mu =', mu(i), ', dmu/dload [1/N] =', slope(i), i=1, 3)
  call model%free()
end program minimal
