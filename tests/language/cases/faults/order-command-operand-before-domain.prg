3.1
Order command operand before domain
DEF_VAR U
SPECIAL 99 U
U = 1
END
