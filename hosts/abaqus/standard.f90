! What Abaqus/Standard needs beside the friction routines: the models made at the start, and a way to stop.

subroutine uexternaldb(lop, lrestart, time, dtime, kstep, kinc)
  use asperity_models, only: free_models, make_models
  include 'aba_param.inc'
  dimension time(2)
  logical :: refused
  select case (lop)
  case (0, 4)                     ! start of the analysis, or of a restart
    call make_models(refused)     ! a refusal stops the first friction routine: XIT must not be called here
  case (3)                        ! end of the analysis
    call free_models
  end select
end subroutine uexternaldb

subroutine stop_analysis(message)
  character(*), intent(in) :: message
  call tell_analysis(-2, message)
  call xit
end subroutine stop_analysis

! Writes to the .msg file. severity  -1 a warning, -2 an error
subroutine tell_analysis(severity, message)
  integer, intent(in) :: severity
  character(*), intent(in) :: message
  integer :: no_integers(1)
  double precision :: no_reals(1)
  character(8) :: no_texts(1)
  no_integers = 0
  no_reals = 0
  no_texts = ' '
  call stdb_abqerr(severity, 'asperity: ' // trim(message), no_integers, no_reals, no_texts)
end subroutine tell_analysis
