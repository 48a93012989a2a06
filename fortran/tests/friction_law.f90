! type(friction_model): shapes, slopes, errors, copies and the freeing of models; run under valgrind as well.
program friction_law
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan, ieee_quiet_nan, ieee_value
  use asperity
  use checking
  implicit none

  type :: slider
    type(friction_model) :: law
    real(c_double) :: mass = 1
  end type slider

  call shapes
  call slopes
  call the_ends_of_the_law
  call gap
  call sticking
  call remembering
  call tables
  call states
  call warnings_of_a_range
  call single_specimens
  call error_reports
  call many_contacts
  call parameters
  call copies
  call freeing
  call finish('friction_model')

contains

  subroutine shapes
    type(friction_model) :: law
    real(c_double) :: load(24), mu(24), force(24), slope(24)
    real(c_double) :: load_2(4, 6), mu_2(4, 6), slope_2(4, 6), mu_3(2, 3, 4), slope_3(2, 3, 4)
    real(c_double) :: of_one(1), none(0)
    integer :: i
    call law%create(paper_case())
    load = [(1.6_c_double**(i - 8), i=1, 24)]
    mu = law%friction_at_load(load, slope)
    force = law%friction_force_at_load(load)
    do i = 1, size(load)
      call check('rank 0 is as the C call', &
                 identical(law%friction_at_load(load(i)), asperity_friction_at_load(law%c_model(), load(i))))
      call check('rank 1 is as rank 0', identical(mu(i), law%friction_at_load(load(i))))
      call check('... and so is the force', identical(force(i), law%friction_force_at_load(load(i))))
    end do
    load_2 = reshape(load, shape(load_2))
    mu_2 = law%friction_at_load(load_2, slope_2)
    call check('rank 2', all(identical(reshape(mu_2, [24]), mu)))
    call check('slopes of rank 2', all(identical(reshape(slope_2, [24]), slope)))
    mu_2 = law%friction_at_load(load_2)
    call check('rank 2 without slopes', all(identical(reshape(mu_2, [24]), mu)))
    mu_3 = law%friction_at_load(reshape(load, shape(mu_3)), slope_3)
    call check('rank 3', all(identical(reshape(mu_3, [24]), mu)))
    call check('slopes of rank 3', all(identical(reshape(slope_3, [24]), slope)))
    mu_2 = law%friction_force_at_load(load_2, slope_2)
    call check('forces of rank 2', all(identical(reshape(mu_2, [24]), force)))
    mu_3 = law%friction_force_at_load(reshape(load, shape(mu_3)), slope_3)
    call check('forces of rank 3', all(identical(reshape(mu_3, [24]), force)))
    call check('slopes of the force have no holes', all(identical(reshape(slope_3, [24]), reshape(slope_2, [24]))))
    slope_2 = 0
    mu_2(1:4:2, :) = law%friction_at_load(load_2(1:4:2, :), slope_2(1:4:2, :))
    call check('slices with a stride', all(identical(mu_2(3, :), mu(3::4))))
    call check('... their slopes', all(identical(slope_2(3, :), slope(3::4))))
    call check('... and nothing between', all(identical(slope_2(2:4:2, :), 0.0_c_double)))
    of_one = law%friction_at_load(load(5:5))
    call check('an array of one', identical(of_one(1), mu(5)))
    none = law%friction_at_load(load(1:0))
    call check('an empty array', size(none) == 0)
  end subroutine shapes

  ! Slopes against differences of the values, of fourth order.
  subroutine slopes
    type(friction_model) :: law
    real(c_double) :: load, step, mu, force, dmu, dforce
    integer :: i
    call law%create(paper_case())
    do i = -1, 5
      load = 3 * 10.0_c_double**i
      step = load / 100
      mu = law%friction_at_load(load, dmu)
      force = law%friction_force_at_load(load, dforce)
      call check_close('d(mu)/dP is the secant', dmu, &
                       difference(law%friction_at_load(load + step * [-2, -1, 1, 2]), step), 1e-6_c_double)
      call check_close('dF/dP is the secant', dforce, &
                       difference(law%friction_force_at_load(load + step * [-2, -1, 1, 2]), step), 1e-6_c_double)
      call check_close('F = mu P', mu * load, force, 1e-15_c_double)
    end do
  end subroutine slopes

  pure function difference(value, step)
    real(c_double), intent(in) :: value(4), step  ! values at -2, -1, 1 and 2 steps
    real(c_double) :: difference
    difference = (8 * (value(3) - value(2)) - (value(4) - value(1))) / (12 * step)
  end function difference

  subroutine the_ends_of_the_law
    type(friction_model) :: law
    type(asperity_params) :: p
    type(asperity_summary) :: constants
    real(c_double) :: mu(3), force(3)
    integer :: stat
    character(40) :: errmsg
    p = paper_case()
    p%max_friction_coefficient = 5
    call law%create(p)
    call law%summary(constants)
    mu = law%friction_at_load([0.5_c_double, 0.0_c_double, 2.0_c_double] * constants%pull_off_load)
    force = law%friction_force_at_load([0.5_c_double, 0.0_c_double, 2.0_c_double] * constants%pull_off_load)
    call check('from pull-off to zero load the coefficient is its cap', all(identical(mu(1:2), 5.0_c_double)))
    call check('... where the force is finite and positive', all(force(1:2) > 0))
    call check('below pull-off there is no friction', all(identical([mu(3), force(3)], 0.0_c_double)))
    errmsg = 'as it was'
    mu(1) = law%friction_at_load(2 * constants%pull_off_load, stat=stat, errmsg=errmsg)
    call check('... which stat tells', stat == ASPERITY_SEPARATED)
    call check_text('... and errmsg', errmsg(1:12), 'element 1: l')
  end subroutine the_ends_of_the_law

  ! A contact that remembers, alone and with an open one.
  subroutine remembering
    real(c_double), parameter :: P(2) = [3.0_c_double, -1e9_c_double]
    type(friction_model) :: law, missing
    type(asperity_microslip) :: out
    real(c_double), allocatable :: state(:), after(:), states(:,:)
    real(c_double) :: increment(2, 2), force(2, 2), tangents(2, 2, 2), length
    integer :: stat
    character(80) :: errmsg
    call law%create(paper_case())
    length = law%friction_force_at_load(P(1)) / law%tangential_stiffness_at_load(P(1))
    allocate (state(law%microslip_length()), after(law%microslip_length()))
    state = 0
    call law%microslip_step(P(1), [1e-3_c_double * length, 0.0_c_double], state, after, out)
    call check_close('it begins with the stiffness', out%force(1), &
                     1e-3_c_double * length * law%tangential_stiffness_at_load(P(1)), 1e-12_c_double)
    state = after
    increment = reshape([0.0_c_double, 10 * length, 0.0_c_double, 0.0_c_double], [2, 2])
    call law%microslip_step(P(1), increment(:, 1), state, after, out, stat)
    call check('all of it slips', stat == 0 .and. abs(out%slipping - 1) < 1e-12_c_double .and. out%dissipated > 0)
    call check_close('with the friction force', norm2(out%force), law%friction_force_at_load(P(1)), 1e-12_c_double)
    after = state
    call law%microslip_turn(after, 0.0_c_double, 1.0_c_double)
    call law%microslip_turn(after, 0.0_c_double, -1.0_c_double)
    call check('a state turns there and back', all([(identical(after(stat), state(stat)), stat = 1, size(after))]))
    call law%microslip_turn(after, nan(), 1.0_c_double, stat, errmsg)
    call check_text('an angle that is NaN is refused', errmsg, 'cosine = NaN: must be finite')
    call law%microslip_step(P(1), increment(:, 1), state, after, out, stat)
    allocate (states(size(state), 2))
    states(:, 1) = state
    states(:, 2) = 1
    call law%microslip_steps(P, increment, states, states, force, tangents, stat, errmsg)
    call check('an open contact tells', stat == ASPERITY_SEPARATED)
    call check('a batch is as one step', all([(identical(states(stat, 1), after(stat)), stat = 1, size(after))]) &
               .and. identical(force(2, 1), out%force(2)) .and. identical(tangents(1, 2, 1), out%stiffness(2)))
    call check('and forgets', .not. any(abs(states(:, 2)) > 0) .and. .not. any(abs(force(:, 2)) > 0))
    call law%microslip_step(P(2), increment(:, 1), state, after, out)
    call check('alone it is no error', .not. any(abs(after) > 0))
    call law%microslip_step(nan(), increment(:, 1), state, after, out, stat, errmsg)
    call check_text('a load that is NaN is refused', errmsg, 'load = NaN: must be finite')
    call missing%microslip_step(P(1), increment(:, 1), state, after, out, stat)
    call check('a law that was never created has none', stat == ASPERITY_NULL_POINTER)
  end subroutine remembering

  subroutine gap
    type(friction_model) :: law
    type(asperity_state) :: state
    real(c_double) :: load, slope
    integer :: stat
    call law%create(paper_case())
    call law%state_at_load(3.0_c_double, state)
    load = law%load_at_gap(state%gap, slope, stat)
    call check_close('the load at a gap', load, 3.0_c_double, 1e-8_c_double)
    call check_close('minus the normal stiffness', slope, state%dload_dgap, 1e-6_c_double)
    call check('surfaces apart are no failure', stat == 0 .and. &
               identical(law%load_at_gap(1e6_c_double), 0.0_c_double))
    load = law%load_at_gap(nan(), slope, stat)
    call check('a gap that is NaN is', stat == ASPERITY_INVALID_PARAMETER .and. ieee_is_nan(load))
  end subroutine gap

  subroutine sticking
    real(c_double), parameter :: P(3) = [0.1_c_double, 3.0_c_double, 1e4_c_double]
    type(friction_model) :: law, missing
    type(asperity_state) :: state
    real(c_double) :: stiffness(3), force, back, slope, length
    integer :: i, stat
    character(80) :: errmsg
    call law%create(paper_case())
    stiffness = law%tangential_stiffness_at_load(P)
    do i = 1, 3
      call law%state_at_load(P(i), state)
      call check_close('the stiffness is that of the state', stiffness(i), state%tangential_stiffness, 1e-8_c_double)
      call check('rank 0 is as rank 1', identical(law%tangential_stiffness_at_load(P(i)), stiffness(i)))
      length = state%friction_force / stiffness(i)
      call law%tangential_at_load(P(i), 1e-8_c_double * length, force, slope)
      call check_close('at first all contacts stick', force, 1e-8_c_double * state%friction_force, 1e-6_c_double)
      call check_close('... with the stiffness', slope, stiffness(i), 1e-6_c_double)
      call law%tangential_at_load(P(i), length, force)
      call law%tangential_at_load(P(i), -length, back, stat=stat)
      call check('the force is odd', stat == 0 .and. identical(back, -force))
    end do
    force = 7
    call law%tangential_at_load(1.0_c_double, nan(), force, stat=stat, errmsg=errmsg)
    call check('a displacement that is NaN is refused', stat == ASPERITY_INVALID_PARAMETER .and. identical(force, 7.0_c_double))
    call check_text('... with a message', errmsg, 'displacement = NaN: must be finite')
    call check('an open contact has no stiffness', identical(law%tangential_stiffness_at_load(-1e9_c_double), 0.0_c_double))
    slope = law%tangential_stiffness_at_load(-1e9_c_double, stat)
    call check('... and tells', stat == ASPERITY_SEPARATED)
    slope = law%tangential_stiffness_at_load(nan(), stat)
    call check('a load that is NaN has none', stat == ASPERITY_INVALID_LOAD .and. ieee_is_nan(slope))
    slope = missing%tangential_stiffness_at_load(1.0_c_double, stat)
    call check('nor has a law that was never created', stat == ASPERITY_NULL_POINTER .and. ieee_is_nan(slope))
  end subroutine sticking

  subroutine tables
    type(friction_model) :: law
    type(asperity_table) :: view
    real(c_double), pointer :: rows(:,:)
    real(c_double) :: start
    integer(c_int64_t) :: row
    integer :: stat
    call law%table(view, rows, stat)
    call check('no table before create', stat == ASPERITY_NULL_POINTER .and. .not. associated(rows))
    call law%create(paper_case())
    call law%table(view, rows, stat)
    call check('the rows are those of the view', stat == 0 .and. size(rows, 1) == 8 .and. &
               size(rows, 2) == view%row_count .and. c_associated(view%rows, c_loc(rows(1, 1))))
    ! A row begins where its t is 0: there F is its first coefficient.
    row = shiftr(transfer(1 - view%pull_off_load, row), view%shift)
    start = transfer(shiftl(row, view%shift), start)
    call check_close('a row begins with the friction force there', rows(1, row - view%base + 1), &
                     law%friction_force_at_load(start + view%pull_off_load), 1e-12_c_double)
    call law%table(view, rows, kind=ASPERITY_TABLE_LOAD_AT_GAP)
    row = shiftr(transfer(1 - view%pull_off_load, row), view%shift)
    start = transfer(shiftl(row, view%shift), start)
    call check_close('... or with the load at minus the gap', rows(1, row - view%base + 1), &
                     law%load_at_gap(-(start + view%pull_off_load)), 1e-12_c_double)
  end subroutine tables

  subroutine states
    type(friction_model) :: law
    type(asperity_state) :: state, back
    integer :: stat
    call law%create(paper_case())
    call law%state_at_load(10.0_c_double, state)
    call check_close('the state has the load', state%load, 10.0_c_double, 1e-12_c_double)
    call law%state_at_gap(state%gap, back)
    call check_close('load of the gap of the load', back%load, 10.0_c_double, 1e-9_c_double)
    call check_close('area too', back%real_area, state%real_area, 1e-9_c_double)
    back%load = 1
    call law%state_at_gap(nan(), back, stat)
    call check('a gap that is NaN is refused', stat == ASPERITY_INVALID_PARAMETER)
    call check('... and the state is untouched', identical(back%load, 1.0_c_double))
  end subroutine states

  subroutine warnings_of_a_range
    integer(c_int64_t), parameter :: TWO = ior(ASPERITY_WARNING_CROWDED, ASPERITY_WARNING_FEW)
    type(friction_model) :: law
    integer(c_int64_t) :: warnings
    character(80) :: message
    integer :: stat
    call law%create(paper_case())
    call law%check_loads(1.0_c_double, 2.0_c_double, warnings)
    call check('the default strength is warned of', iand(warnings, ASPERITY_WARNING_UNCALIBRATED) /= 0)
    call check('a warning says what to do', index(asperity_warning_text(ASPERITY_WARNING_FEW), '; use heavier loads') > 0)
    call check('several at once have a line each', asperity_warning_text(TWO) == &
               asperity_warning_text(ASPERITY_WARNING_CROWDED) // new_line('a') // asperity_warning_text(ASPERITY_WARNING_FEW))
    warnings = 77
    message = ''
    call law%check_loads(2.0_c_double, 1.0_c_double, warnings, stat, message)
    call check('loads that fall are refused', stat == ASPERITY_INVALID_PARAMETER .and. warnings == 77 .and. &
               index(message, 'lightest = 2: must not be above heaviest') > 0)
    call law%free()
    call law%check_loads(1.0_c_double, 2.0_c_double, warnings, stat, message)
    call check('without a model nothing is checked', stat == ASPERITY_NULL_POINTER .and. warnings == 77)
  end subroutine warnings_of_a_range

  subroutine single_specimens
    type(friction_model) :: law
    type(asperity_specimens) :: found(2)
    real(c_double) :: load(2)
    integer :: stat
    call law%create(paper_case())
    load = [0.0_c_double, 2684.0_c_double]
    call law%specimens_at_loads(load, found, specimens=3)
    call check('a specimen of one summit has one contact', abs(found(2)%contacts(1 + ASPERITY_SPREAD_MEAN) - 1) <= 0)
    call check('pressed it has friction', found(2)%friction_force(1 + ASPERITY_SPREAD_LOW) > 0)
    load(2) = nan()
    call law%specimens_at_loads(load, found, seed=7_c_int64_t, stat=stat)
    call check('a load that is NaN is refused', stat == ASPERITY_INVALID_LOAD)
  end subroutine single_specimens

  subroutine error_reports
    type(friction_model) :: law, copied
    type(asperity_params) :: p
    type(asperity_state) :: state
    type(asperity_summary) :: constants
    real(c_double) :: mu(4), loaded
    character(80) :: errmsg
    character(10) :: short
    integer :: stat
    p = paper_case()
    p%weibull_shape = -2
    p%height_distribution = ASPERITY_HEIGHTS_WEIBULL
    stat = -1
    call law%create(p, stat, errmsg)
    call check('a parameter without meaning is refused', stat == ASPERITY_INVALID_PARAMETER)
    call check_text('the message names it, its value and what is allowed', errmsg, &
                    'weibull_shape = -2: must be finite and > 0')
    call law%create(p, stat, short)
    call check_text('a short errmsg is cut', short, 'weibull_sh')
    call law%get_params(p, stat, errmsg)
    call check('a law that was never created has no parameters', stat == ASPERITY_NULL_POINTER)
    call check_text('... and says what to do', errmsg(1:54), 'friction_model: no model here: call create on this var')
    mu(1:2) = law%friction_at_load([1.0_c_double, 2.0_c_double], stat=stat)
    call check('nor has it friction', stat == ASPERITY_NULL_POINTER .and. all(ieee_is_nan(mu(1:2))))
    call law%state_at_load(1.0_c_double, state, stat)
    call check('nor a state', stat == ASPERITY_NULL_POINTER)
    call law%summary(constants, stat)
    call check('nor constants', stat == ASPERITY_NULL_POINTER)
    call law%set_params(paper_case(), stat)
    call check('nor can they be set', stat == ASPERITY_NULL_POINTER)
    call check('it has no C model', .not. c_associated(law%c_model()))
    call law%create(paper_case(), stat, errmsg)
    call check('success is 0', stat == 0)
    call check('... and leaves errmsg', errmsg(1:14) == 'friction_model')
    mu = law%friction_at_load([1.0_c_double, 2.0_c_double, nan(), 4.0_c_double], stat=stat, errmsg=errmsg)
    call check('NaN is refused', stat == ASPERITY_INVALID_LOAD)
    call check_text('... and its element counted from one', errmsg, 'element 3: load = NaN: must be finite')
    call check('all elements are filled', ieee_is_nan(mu(3)) .and. mu(4) > 0)
    call law%unload(1.0_c_double, stat, errmsg)
    call check('unloading with adhesion is refused', stat == ASPERITY_OUT_OF_RANGE .and. law%friction_at_load(1.0_c_double) > 0)
    p = paper_case()
    p%work_of_adhesion = 0
    p%hardness = 0.02_c_double
    p%contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC
    call law%create(p)
    loaded = law%friction_at_load(3.0_c_double)
    call law%unload(10.0_c_double)
    call law%summary(constants)
    call check('a law knows its largest load', constants%largest_load > 9.99_c_double .and. constants%largest_load < 10.01_c_double)
    call check('... and springs back from it', law%friction_at_load(3.0_c_double) > loaded)
    copied = law
    call check('... as a copy does', identical(copied%friction_at_load(3.0_c_double), law%friction_at_load(3.0_c_double)))
  end subroutine error_reports

  ! Open contacts are ordinary; they hide no load that has no answer.
  subroutine many_contacts
    type(friction_model) :: law
    type(asperity_summary) :: constants
    real(c_double) :: open, mu(4), slope(4), plane(2, 2)
    integer :: stat
    character(40) :: errmsg
    call law%create(paper_case())
    call law%summary(constants)
    open = 2 * constants%pull_off_load
    errmsg = 'as it was'
    mu = law%friction_at_load([1.0_c_double, open, 2.0_c_double, open], slope, stat, errmsg)
    call check('open contacts among others are no error', stat == 0 .and. errmsg == 'as it was')
    call check('... and have no friction', identical(mu(2), 0.0_c_double) .and. identical(slope(4), 0.0_c_double))
    mu = law%friction_force_at_load([1.0_c_double, open, 2.0_c_double, open])
    call check('... the others have', mu(1) > 0 .and. mu(3) > mu(1))
    mu = law%friction_at_load([1.0_c_double, open, 1e300_c_double, 2.0_c_double], stat=stat, errmsg=errmsg)
    call check('too heavy a load is one', stat == ASPERITY_OUT_OF_RANGE .and. ieee_is_nan(mu(3)))
    call check_text('... with its index', errmsg(1:24), 'element 3: load = 1e300:')
    mu(1:2) = law%friction_at_load([1.0_c_double, 1e300_c_double], stat=stat, errmsg=errmsg)
    call check('... without an open contact too', &
               stat == ASPERITY_OUT_OF_RANGE .and. mu(1) > 0 .and. ieee_is_nan(mu(2)))
    call check_text('... with its index', errmsg(1:24), 'element 2: load = 1e300:')
    plane = reshape([open, 1.0_c_double, ieee_value(open, ieee_quiet_nan), 1e300_c_double], [2, 2])
    plane = law%friction_force_at_load(plane, stat=stat, errmsg=errmsg)
    call check('so is NaN', stat == ASPERITY_INVALID_LOAD)
    call check_text('... with its place in array element order', errmsg(1:22), 'element 3: load = NaN:')
  end subroutine many_contacts

  subroutine parameters
    type(friction_model) :: law
    type(asperity_params) :: p, back
    real(c_double) :: of_one, of_ten
    integer :: stat
    character(60) :: errmsg
    p = paper_case()
    call law%create(p)
    of_one = law%friction_force_at_load(3.0_c_double)
    p%asperity_count = 10
    call law%set_params(p)
    call law%get_params(back)
    call check('the parameters are those that were set', identical(back%asperity_count, 10.0_c_double))
    of_ten = law%friction_force_at_load(30.0_c_double)
    call check_close('ten summits carry ten times the load with ten times the friction', of_ten, 10 * of_one, &
                     1e-8_c_double)
    p%asperity_count = -1
    call law%set_params(p, stat)
    call check('a negative count is refused', stat == ASPERITY_INVALID_PARAMETER)
    call law%create(p, stat)
    call check('... by create too', stat == ASPERITY_INVALID_PARAMETER)
    call check('... and the law is as before', identical(law%friction_force_at_load(30.0_c_double), of_ten))
    p = asperity_params_of(E1=160e9_c_double, nu1=0.22_c_double, E2=160e9_c_double, nu2=0.22_c_double, &
                           work_of_adhesion=0.063_c_double, adhesion_range=0.384e-9_c_double, &
                           burgers_vector=0.384e-9_c_double, height_std=5e-9_c_double, summit_radius=1e-6_c_double, &
                           asperity_count=1e5_c_double)
    call law%create(p)
    call check_close('a surface of one''s own', law%friction_at_load(1e-3_c_double), 0.5424071_c_double, 1e-6_c_double)
    p = asperity_params_of(1.0_c_double, 0.3_c_double, 1.0_c_double, 0.6_c_double, 0.0_c_double, 1.0_c_double, &
                           1.0_c_double, 10.0_c_double, 1e5_c_double, 1.0_c_double, stat, errmsg)
    call check('... whose Poisson''s ratio is refused', stat == ASPERITY_INVALID_PARAMETER)
    call check_text('... by name', errmsg(1:9), 'nu2 = 0.6')
  end subroutine parameters

  subroutine copies
    type(friction_model) :: a, b
    type(friction_model), allocatable :: bitwise
    type(slider) :: s
    type(asperity_params) :: p
    real(c_double) :: before
    integer :: stat
    call a%create(paper_case())
    before = a%friction_at_load(1.0_c_double)
    b = a
    p = paper_case()
    p%height_std = 20
    call b%set_params(p)
    call check('a copy is a model of its own', identical(a%friction_at_load(1.0_c_double), before))
    call check('... that was changed alone', abs(b%friction_at_load(1.0_c_double) - before) > 0.01_c_double * before)
    call assign(a, a)
    call check('a = a changes nothing', identical(a%friction_at_load(1.0_c_double), before))
    allocate(bitwise, source=a)
    call bitwise%get_params(p, stat)
    call check('a bitwise copy is refused', stat == ASPERITY_NULL_POINTER)
    deallocate(bitwise)
    call check('... and frees nothing', identical(a%friction_at_load(1.0_c_double), before))
    call s%law%create(paper_case())
    call check('a law may be part of a type', identical(s%law%friction_at_load(1.0_c_double), before))
    call b%free()
    a = b
    call check('a copy of nothing is nothing', .not. c_associated(a%c_model()))
  end subroutine copies

  subroutine assign(a, b)
    type(friction_model), intent(inout) :: a
    type(friction_model), intent(in) :: b
    a = b
  end subroutine assign

  ! What these leave behind, valgrind tells.
  subroutine freeing
    type(friction_model) :: again
    type(friction_model), allocatable :: several(:)
    integer :: i
    do i = 1, 2
      call again%create(paper_case())
    end do
    call again%free()
    call again%free()
    call check('a freed law is gone', .not. c_associated(again%c_model()))
    call again%create(paper_case())
    allocate(several(2))
    call several(1)%create(paper_case())
    several(2) = several(1)
    call check('laws in an array', identical(several(1)%friction_at_load(1.0_c_double), &
                                             several(2)%friction_at_load(1.0_c_double)))
    deallocate(several)
    call local_law
  end subroutine freeing

  subroutine local_law
    type(friction_model) :: law
    call law%create(paper_case())
    call check('a local law works until it goes out of scope', law%friction_at_load(1.0_c_double) > 0)
  end subroutine local_law

  function nan()
    real(c_double) :: nan
    nan = ieee_value(1.0_c_double, ieee_quiet_nan)
  end function nan

end program friction_law
