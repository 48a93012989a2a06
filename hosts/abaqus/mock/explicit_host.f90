! Plays Abaqus/Explicit, in the precision of vaba_param.inc: blocks of contact points, on threads that share a model.
program explicit_host
  use, intrinsic :: iso_c_binding
  use omp_lib, only: omp_get_num_threads
  use measures
  use asperity, only: asperity_free
  implicit none

  include 'kind.inc'
  integer, parameter :: BLOCK = 128, BLOCKS = 12
  real(HOST) :: alone(BLOCK, 2, BLOCKS), together(BLOCK, 2, BLOCKS), r_array(3)
  integer :: i_array(6), i, used
  external :: vexternaldb

  i_array = [100, 100, 1, 1, 0, 0]
  r_array = 0
  call vexternaldb(0, i_array, 6, r_array, 3)
  call check('the analysis goes on', i_array(5) == 0)
  do i = 1, BLOCKS
    alone(:, :, i) = of_block(i)
  end do
  used = 1
  !$omp parallel
  !$omp single
  used = omp_get_num_threads()
  !$omp end single
  !$omp do schedule(dynamic, 1)
  do i = 1, BLOCKS
    together(:, :, i) = of_block(i)
  end do
  !$omp end do
  !$omp end parallel
  call check('there are several threads', used > 1)
  call check('threads that share a model get what one thread gets', all(abs(together - alone) <= 0))
  call check_pressures(1, 0.01_c_double, 50.0_c_double)
  call against_the_law
  call vexternaldb(6, i_array, 6, r_array, 3)
  call finish

contains

  function pressures(i) result(pressure)
    integer, intent(in) :: i
    real(HOST) :: pressure(BLOCK)
    integer :: k
    pressure = [(real(1e-2_c_double * 1.005_c_double**(k + BLOCK * (i - 1)), HOST), k=1, BLOCK)]
  end function pressures

  ! In single precision the answer is the law's, rounded once.
  subroutine against_the_law
    real(HOST) :: pressure(BLOCK)
    real(c_double) :: error, slope_error, p, step
    type(c_ptr) :: patch
    integer :: i, k, j
    error = 0
    slope_error = 0
    patch = patch_law(1)
    do i = 1, BLOCKS
      pressure = pressures(i)
      do k = 1, BLOCK
        p = dble(pressure(k))
        call worse(error, abs(dble(alone(k, 1, i)) / patch_friction(patch, p) - 1))
        if (alone(k, 1, i) >= 100 .or. mod(k, 8) /= 0) cycle
        step = p / 100
        call worse(slope_error, abs(dble(alone(k, 2, i)) / difference([(patch_friction(patch, p + j * step), &
                   j=-2, -1), (patch_friction(patch, p + j * step), j=1, 2)], step) - 1))
      end do
    end do
    call asperity_free(patch)
    call largest(NAME_OF_MU, error, max(1e-12_c_double, dble(epsilon(1.0_HOST))))
    call largest('tangent', slope_error, 1e-6_c_double)
  end subroutine against_the_law

  ! Calls VFRIC_COEF with its whole argument list.
  function of_block(i) result(answer)
    integer, intent(in) :: i
    real(HOST) :: answer(BLOCK, 2), fCoef(BLOCK), fCoefDeriv(BLOCK, 3), props(1), slipRate(BLOCK), tempAvg(BLOCK)
    real(HOST) :: fieldAvg(BLOCK, 1), rData(3), pressure(BLOCK)
    integer :: jFlags(2)
    character(80) :: names(3)
    external :: vfric_coef
    fCoef = -7
    fCoefDeriv = -7
    props = 1
    slipRate = 1
    tempAvg = 293
    fieldAvg = 0
    rData = 0
    jFlags = 1
    names = ['RUBBING', 'PAD    ', 'DISC   ']
    pressure = pressures(i)
    call vfric_coef(fCoef, fCoefDeriv, BLOCK, 1, 1, 1, jFlags, rData, names(1), names(2), names(3), props, slipRate, &
                    pressure, tempAvg, fieldAvg)
    call check('no slope by slip rate or temperature', all(abs(fCoefDeriv(:, 1)) + abs(fCoefDeriv(:, 3)) <= 0))
    answer(:, 1) = fCoef
    answer(:, 2) = fCoefDeriv(:, 2)
  end function of_block

end program explicit_host

! The utility routines of Abaqus/Explicit that the user subroutines call.
subroutine xplb_abqerr(lop, message, integers, reals, texts)
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  include 'kind.inc'
  integer, intent(in) :: lop, integers(*)
  real(HOST), intent(in) :: reals(*)
  character(8), intent(in) :: texts(*)
  character(*), intent(in) :: message
  if (lop /= -2 .and. lop /= -1) error stop 1
  write (error_unit, '(a)') trim(merge('***ERROR:  ', '***WARNING:', lop == -2)) // ' ' // trim(message)
end subroutine xplb_abqerr

subroutine xplb_exit
  stop 7
end subroutine xplb_exit
