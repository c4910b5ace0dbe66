3.2
The sum of a hundred numbers in a tenth of a second
DEF_VAR N, SUM
START_TIMER 0
TIP_SPEED_UP 50
SUM = 0
FOR N = 1 TO 100
  SUM += N
NEXT N
MESSAGE the sum is %SUM%, after %@TIMER0% ms
END
