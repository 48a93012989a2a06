! An error without stat= stops the program. The argument says which: test.sh compares message and exit status.
program stops
  use, intrinsic :: iso_c_binding
  use asperity
  use checking
  implicit none
  type(friction_model) :: law
  type(asperity_params) :: params
  real(c_double) :: mu(3), slope(2)
  character(20) :: which

  call get_command_argument(1, which)
  params = paper_case()
  select case (which)
  case ('parameter')
    params%summit_radius = 0
    call law%create(params)
  case ('forgotten')
    call asperity_check(asperity_params_init(params))
    call asperity_params_set_pair(params, 'Si/Si')
    params%height_std = 5e-9_c_double
    params%summit_radius = 1e-6_c_double
    call law%create(params)
  case ('never_created')
    mu = law%friction_at_load([1.0_c_double, 2.0_c_double, 3.0_c_double])
  case ('load')
    call law%create(params)
    mu = law%friction_at_load([1.0_c_double, infinity(), 3.0_c_double])
  case ('heavy')
    call law%create(params)
    mu = law%friction_at_load([1.0_c_double, 2.0_c_double, 1e300_c_double])
  case ('scalar')
    call law%create(params)
    mu(1) = law%friction_force_at_load(-infinity())
  case ('shape')
    call law%create(params)
    mu = law%friction_at_load([1.0_c_double, 2.0_c_double, 3.0_c_double], slope)
  case ('status')
    call asperity_check(asperity_params_set_units(params, -5.0_c_double, 1.0_c_double))
  end select
  write (*, '(a, 3es12.4)') 'not stopped', mu

contains

  function infinity()
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    real(c_double) :: infinity
    infinity = ieee_value(1.0_c_double, ieee_positive_inf)
  end function infinity

end program stops
