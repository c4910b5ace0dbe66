3.1
Key in takes the oldest
DEF_VAR K
REM one
REM two
REM three
KEY_IN K
IF KB_HIT GOTO BAD:
EXIT
BAD: END
