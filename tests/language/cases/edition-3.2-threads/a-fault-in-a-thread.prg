3.2
The emergency names the thread
DEF_VAR A Z
Z = 0
START_THREAD ONE:
L1:
GOTO L1:
THREAD ONE:
A = 1 / Z
THREADEND
END
