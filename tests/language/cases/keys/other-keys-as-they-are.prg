3.1
Other keys as they are
DEF_VAR K
KEY_IN K
KEY_IN K
KEY_IN K
KEY_IN K
KEY_IN K
END
