3.1
Speed negative
REM one
SET_V_MAX F1 -1
END
