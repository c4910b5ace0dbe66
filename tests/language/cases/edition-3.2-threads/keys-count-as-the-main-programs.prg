3.2
An emergency key while a thread runs
START_THREAD ONE:
L1:
GOTO L1:
THREAD ONE:
L2:
GOTO L2:
THREADEND
END
