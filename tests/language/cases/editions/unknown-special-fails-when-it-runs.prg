3.2
Unknown special fails when it runs
REM
SPECIAL 99
END
