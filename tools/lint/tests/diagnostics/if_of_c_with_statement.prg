3.1
A title
DEF_VAR N
KEY_IN N
if (N == 1) MESSAGE one
END
