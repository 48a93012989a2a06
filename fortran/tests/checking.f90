! Checks that print what failed and go on; a test program ends with call finish('what it is about').
module checking
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use asperity
  implicit none
  private
  public :: check, check_close, check_text, finish, identical, paper_case

  integer :: checks = 0, failures = 0

contains

  subroutine check(claim, holds)
    character(*), intent(in) :: claim
    logical, intent(in) :: holds
    checks = checks + 1
    if (holds) return
    failures = failures + 1
    write (error_unit, '(a)') 'FAIL: ' // claim
  end subroutine check

  subroutine check_close(claim, value, expected, tolerance)
    character(*), intent(in) :: claim
    real(c_double), intent(in) :: value, expected, tolerance  ! the tolerance is relative
    logical :: close
    close = .false.
    if (is_finite(value)) close = abs(value - expected) <= tolerance * abs(expected)
    call check(claim, close)
    if (.not. close) write (error_unit, '(4x, 3(a, es24.16e3))') 'value', value, '  expected', expected, &
                                                               '  relative tolerance', tolerance
  end subroutine check_close

  subroutine check_text(claim, text, expected)
    character(*), intent(in) :: claim, text, expected
    call check(claim, text == expected)
    if (text /= expected) write (error_unit, '(4x, a)') 'text     ' // trim(text), 'expected ' // expected
  end subroutine check_text

  function paper_case() result(params)
    type(asperity_params) :: params
    call asperity_check(asperity_params_init(params))
    call asperity_check(asperity_params_set_dimensionless(params, alpha=0.01_c_double, beta=1000.0_c_double, &
                                                          gamma=0.001_c_double, b_over_h=1.0_c_double, &
                                                          poisson=0.3_c_double))
  end function paper_case

  ! Equal to the last bit; NaN is identical to itself, and comparing one traps nothing.
  elemental function identical(a, b)
    real(c_double), intent(in) :: a, b
    logical :: identical
    identical = transfer(a, 0_c_int64_t) == transfer(b, 0_c_int64_t)
  end function identical

  pure function is_finite(x)
    real(c_double), intent(in) :: x
    logical :: is_finite
    integer(c_int64_t), parameter :: INFINITY_BITS = int(z'7FF0000000000000', c_int64_t)
    is_finite = iand(transfer(x, 0_c_int64_t), INFINITY_BITS) /= INFINITY_BITS
  end function is_finite

  subroutine finish(subject)
    character(*), intent(in) :: subject
    if (failures > 0) then
      write (error_unit, '(a, i0, a, i0, a)') subject // ': ', failures, ' of ', checks, ' checks failed'
      error stop 1
    end if
    write (*, '(a, i0, a)') subject // ': ', checks, ' checks passed'
  end subroutine finish

end module checking
