! A steel hub shrunk on a ground steel shaft of 50 mm, over 40 mm: which pull and torque does the fit hold?
program minimal
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity
  implicit none
  real(c_double), parameter :: radius = 25e-3_c_double, length = 40e-3_c_double   ! m
  real(c_double), parameter :: area = 6.2831853_c_double*radius*length            ! m^2
  real(c_double), parameter :: pressure(3) = [20e6_c_double, 60e6_c_double, 120e6_c_double]   ! of the fit [Pa]: 20 MPa is 20e6
  real(c_double), parameter :: measured(2) = [10e6_c_double, 0.16_c_double]   ! put yours here: 0.16 at 10 MPa
  type(asperity_estimate) :: found(size(pressure))
  type(asperity_params) :: params
  type(friction_model) :: model
  character(300) :: surface
  integer :: i

  write (surface, '(a, es13.6, a, es13.6, a, f6.3, a)') 'pair = "steel/steel"'//new_line('a')//'nominal_area =', area, &
    new_line('a')//'measured = [', measured(1)*area, ',', measured(2), ']'//new_line('a')// &
    '[roughness]'//new_line('a')//'process = "ground"'//new_line('a')//'Ra = [0.8e-6, 0.8e-6]'   ! shaft and hub [m]
  call asperity_estimate_at_loads(surface, pressure*area, found)
  write (*, '(*(i4, a, f6.3, 3(a, f7.1), a, i8, a, :, /))') (nint(pressure(i)/1e6), ' MPa: mu', &
    found(i)%friction_coefficient, ', pull', found(i)%friction_force/1e3, ' kN (', found(i)%friction_force_low/1e3, ' to', &
    found(i)%friction_force_high/1e3, '), torque', nint(found(i)%friction_force*radius), ' N m', i=1, size(pressure))

  call asperity_check(asperity_params_init(params))            ! a solver makes a model of the same text, once
  call asperity_params_set_text(params, surface)
  call model%create(params)
  write (*, '(a, f8.2, a)') 'in a solver, at the second pressure:', model%friction_force_at_load(pressure(2)*area)/1e3, ' kN'
  call model%free()
end program minimal
