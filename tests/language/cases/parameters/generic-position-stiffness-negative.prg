3.1
Generic position stiffness negative
REM one
SET_POSITION_STIFFNESS F1 1 1 -1
END
