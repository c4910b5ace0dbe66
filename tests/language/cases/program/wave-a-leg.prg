3.1
Wave until somebody asks to stop
DEF_VAR N
DEF_JOINT OUT
OUT.J1 = 10; OUT.J2 = 0; OUT.J3 = 90
FOR N = 1 TO 100
  PTP_ANGLE F1 OUT
  SLEEP 100
  OUT.J1 = -OUT.J1
  IF HALT_REQUEST THEN
    MESSAGE stopped in round %N%
    EXIT
  ENDIF
NEXT
END
