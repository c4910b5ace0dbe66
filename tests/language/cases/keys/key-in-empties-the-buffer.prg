3.1
Key in empties the buffer
DEF_VAR K
KEY_IN K
KEY_IN K
END
