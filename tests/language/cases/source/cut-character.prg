3.1
t
REM ‚ ‚