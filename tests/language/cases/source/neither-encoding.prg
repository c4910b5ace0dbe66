3.1
t
REM ‚ ÿ
END
