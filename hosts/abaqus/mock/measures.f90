! What the mock hosts measure, and the law by another path: the C functions, for one patch of surface of given area.
module measures
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit
  use asperity
  use asperity_models, only: read_surface
  implicit none
  private
  public :: check, check_pressures, difference, finish, largest, patch_friction, patch_law, worse

  ! The patch is this many of the nominal areas of the surface: what a pressure does must not depend on how many. A
  ! power of two, so that the tables of both models are the same but for their exponents.
  real(c_double), parameter :: AREAS_IN_PATCH = 4
  real(c_double), protected, public :: patch_area = 0  ! [mm^2], of the last patch_law

  integer :: failures = 0

contains

  subroutine check(claim, holds)
    character(*), intent(in) :: claim
    logical, intent(in) :: holds
    if (holds) return
    failures = failures + 1
    write (error_unit, '(a)') 'FAIL: ' // claim
  end subroutine check

  ! Keeps the largest error met, or the first that is not a number, which no limit allows.
  subroutine worse(largest_so_far, error)
    real(c_double), intent(inout) :: largest_so_far
    real(c_double), intent(in) :: error
    if (ieee_is_nan(largest_so_far)) return
    if (.not. (error <= largest_so_far)) largest_so_far = error
  end subroutine worse

  ! Prints a measure for run.sh, and fails above its limit.
  subroutine largest(name, error, limit)
    character(*), intent(in) :: name
    real(c_double), intent(in) :: error, limit
    write (*, '(a, 2es10.1)') name, error, limit
    call check(name // ' is above its limit', error <= limit)
  end subroutine largest

  subroutine finish
    if (failures > 0) error stop 1
  end subroutine finish

  ! The summits of a patch, as a user without Abaqus would count them.
  function patch_law(surface) result(model)
    integer, intent(in) :: surface
    type(c_ptr) :: model
    type(asperity_params) :: params
    character(500) :: message
    integer :: stat
    message = ''
    call read_surface(surface, params, stat, message)
    call check(message, stat == 0)
    params%asperity_count = params%asperity_count * AREAS_IN_PATCH
    params%nominal_area = params%nominal_area * AREAS_IN_PATCH
    patch_area = params%nominal_area
    model = c_null_ptr
    call asperity_check(asperity_create(params, model))
  end function patch_law

  ! Whether the law holds for a surface at all pressures between two [MPa].
  subroutine check_pressures(surface, lightest, heaviest)
    integer, intent(in) :: surface
    real(c_double), intent(in) :: lightest, heaviest
    type(c_ptr) :: patch
    integer(c_int64_t) :: warnings, told
    integer :: bit
    warnings = 0
    patch = patch_law(surface)
    call asperity_check(asperity_check_loads(patch, lightest * patch_area, heaviest * patch_area, warnings))
    call asperity_free(patch)
    ! The strength of this interface was not measured: said, and no reason to stop.
    told = iand(warnings, ASPERITY_WARNING_UNCALIBRATED)
    if (told /= 0) print '(a)', asperity_warning_text(told)
    warnings = iand(warnings, not(told))
    do bit = 0, 62
      if (btest(warnings, bit)) call check(asperity_warning_text(shiftl(1_c_int64_t, bit)), .false.)
    end do
  end subroutine check_pressures

  function patch_friction(model, pressure) result(mu)
    type(c_ptr), intent(in) :: model
    real(c_double), intent(in) :: pressure
    real(c_double) :: mu
    mu = asperity_friction_at_load(model, pressure * patch_area)
  end function patch_friction

  ! A derivative from values at -2, -1, 1 and 2 steps.
  pure function difference(value, step)
    real(c_double), intent(in) :: value(4), step
    real(c_double) :: difference
    difference = (8 * (value(3) - value(2)) - (value(4) - value(1))) / (12 * step)
  end function difference

end module measures
