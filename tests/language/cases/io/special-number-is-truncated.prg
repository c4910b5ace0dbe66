3.1
Special number is truncated
REM one
SPECIAL 255.9 1 -2
END
