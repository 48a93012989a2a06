! A steel hub shrunk on a ground steel shaft of 50 mm, over 40 mm: which pull and torque does the fit hold?
program minimal
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity
  implicit none
  character, parameter :: nl = new_line('a')
  real(c_double), parameter :: area = 6.283e-3_c_double, radius = 25e-3_c_double   ! m^2, m
  real(c_double), parameter :: pressure(3) = [20e6_c_double, 60e6_c_double, 120e6_c_double]   ! of the fit [Pa]
  type(asperity_estimate) :: found(3)
  type(asperity_params) :: params
  type(friction_model) :: model
  character(:), allocatable :: surface
  integer :: i

  surface = 'pair = "steel/steel"'//nl//'nominal_area = 6.283e-3'//nl// &
            'measured = [62830, 0.16]'//nl// &       ! put your measurement here: 0.16 at 10 MPa, as a load on this area [N]
            '[roughness]'//nl//'process = "ground"'//nl//'Ra = [0.8e-6, 0.8e-6]'//nl   ! shaft and hub [m]
  call asperity_estimate_at_loads(surface, pressure*area, found)
  write (*, '(3(i3, a, f5.3, 3(a, f5.1), a, i0, a, :, /))') (nint(pressure(i)/1e6), ' MPa: mu ', &
    found(i)%friction_coefficient, ', pull ', found(i)%friction_force/1e3, ' kN (', found(i)%friction_force_low/1e3, ' to ', &
    found(i)%friction_force_high/1e3, '), torque ', nint(found(i)%friction_force*radius), ' N m', i=1, 3)

  call asperity_check(asperity_params_init(params))            ! a solver makes a model of the same text, once
  call asperity_params_set_text(params, surface)
  call model%create(params)
  write (*, '(a, f5.2, a)') 'at 60 MPa, in a solver: ', model%friction_force_at_load(pressure(2)*area)/1e3, ' kN'
  call model%free()
end program minimal
