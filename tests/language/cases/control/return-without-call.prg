3.1
Return without call
REM one
RETURN
END
