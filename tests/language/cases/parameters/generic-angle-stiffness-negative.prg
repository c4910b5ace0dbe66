3.1
Generic angle stiffness negative
REM one
SET_ANGLE_STIFFNESS ALL -1
END
