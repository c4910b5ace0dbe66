3.2
Use what native code can share with a program
VAR_SPECIAL_0 += 1           // it is 0 at the start
POS_SPECIAL_0.Z = 40
JNT_SPECIAL_0.J1 = 10
REL_PTP F1 POS_SPECIAL_0
REL_PTP_ANGLE F2 JNT_SPECIAL_0
MESSAGE motion %VAR_SPECIAL_0% by %POS_SPECIAL_0%
END
