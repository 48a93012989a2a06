! As estimate.c.
program estimate
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity
  implicit none
  real(c_double), parameter :: loads(3) = [0.0_c_double, 1.0_c_double, 100.0_c_double]
  type(asperity_estimate) :: found(3)
  character(:), allocatable :: surface
  character(200) :: line
  integer :: i, stat
  surface = ''
  do
    read (*, '(a)', iostat=stat) line
    if (stat /= 0) exit
    surface = surface // trim(line) // new_line('a')
  end do
  call asperity_estimate_at_loads(surface, loads, found)
  do i = 2, 3
    write (*, '(es18.12, 1x, es18.12, 1x, es18.12)') found(i)%friction_coefficient, found(i)%low, found(i)%high
  end do
  write (*, '(a)', advance='no') asperity_estimate_text(surface, loads)
end program estimate
