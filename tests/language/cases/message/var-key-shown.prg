3.1
Var key shown
KEY_IN
MESSAGE key %VAR_KEY%
END
