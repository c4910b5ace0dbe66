3.1
The flag of a palm on robots that have none
IF ANTENNA_ON GOTO L1:
IF !ANTENNA_ON GOTO L1:
L1:
END
