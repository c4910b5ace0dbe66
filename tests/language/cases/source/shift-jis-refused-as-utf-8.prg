3.1
t
REM •à
END
