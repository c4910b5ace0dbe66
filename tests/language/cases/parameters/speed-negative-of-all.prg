3.1
Speed negative of all
REM one
SET_V_MAX ALL -0.001
END
