! What Abaqus/Explicit needs beside the friction routine: the models made at the start, and a way to stop.

subroutine vexternaldb(lop, i_array, niarray, r_array, nrarray)
  use asperity_models, only: free_models, make_models
  include 'vaba_param.inc'
  dimension i_array(niarray), r_array(nrarray)
  integer, parameter :: START_ANALYSIS = 0, END_ANALYSIS = 6    ! lop
  integer, parameter :: STATUS = 5, TERMINATE_ANALYSIS = 2      ! i_array(STATUS)
  logical :: refused
  select case (lop)
  case (START_ANALYSIS)
    call make_models(refused)
    if (refused) i_array(STATUS) = TERMINATE_ANALYSIS
  case (END_ANALYSIS)
    call free_models
  end select
end subroutine vexternaldb

subroutine stop_analysis(message)
  character(*), intent(in) :: message
  call tell_analysis(-2, message)
  call xplb_exit
end subroutine stop_analysis

! Writes to the message file. severity  -1 a warning, -2 an error
subroutine tell_analysis(severity, message)
  include 'vaba_param.inc'
  integer, intent(in) :: severity
  character(*), intent(in) :: message
  dimension no_integers(1), zero_reals(1)
  character(8) :: no_texts(1)
  no_integers = 0
  zero_reals = 0
  no_texts = ' '
  call xplb_abqerr(severity, 'asperity: ' // trim(message), no_integers, zero_reals, no_texts)
end subroutine tell_analysis
