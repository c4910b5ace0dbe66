3.1
Key in to a variable
DEF_VAR K
KEY_IN K
KEY_IN
KEY_IN
END
