3.1
Update of unassigned
DEF_VAR A
REM one
A += 1
END
