! Friction coefficient of a polysilicon MEMS contact against normal load, with its band: the summary of
! c_examples/friction_curve.c, which says where the numbers come from, in Fortran.
program friction_curve
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity
  implicit none

  character(*), parameter :: LF = new_line('a')
  character(*), parameter :: surface = &
    'measured = [1e-2, 0.3, 0.05]    # load [N], friction coefficient, relative error: ASSUMED' // LF // &
    'work_of_adhesion = 0.063        # [J/m^2]' // LF // &
    'adhesion_range = 0.384e-9       # [m]' // LF // &
    'burgers_vector = 0.384e-9       # [m]' // LF // &
    'hardness = 12e9                 # [Pa], for warnings' // LF // &
    'nominal_area = 1e-8             # [m^2]' // LF // &
    '[materials]' // LF // &
    'E1 = 160e9                      # [Pa]' // LF // &
    'nu1 = 0.22' // LF // &
    'E2 = 160e9' // LF // &
    'nu2 = 0.22' // LF // &
    '[roughness]' // LF // &
    'Sq = 5e-9                       # [m]' // LF // &
    'Sdq = 0.08' // LF
  real(c_double), parameter :: loads(5) = [1e-4_c_double, 1e-3_c_double, 1e-2_c_double, 1e-1_c_double, 1.0_c_double]  ! [N]
  type(asperity_params) :: params
  type(asperity_estimate) :: found(5)
  type(asperity_state) :: state
  type(friction_model) :: model
  integer :: i

  call asperity_check(asperity_params_init(params))
  call asperity_params_set_text(params, surface)
  call model%create(params)
  call asperity_estimate_at_loads(surface, loads, found)
  write (*, '(a)') '  load [N]      mu     low    high   contacts'
  do i = 1, size(loads)
    call model%state_at_load(loads(i), state)
    write (*, '(f10.4, 3f8.3, i11)') loads(i), found(i)%friction_coefficient, found(i)%low, found(i)%high, nint(state%contacting)
  end do
  call model%free()
end program friction_curve
