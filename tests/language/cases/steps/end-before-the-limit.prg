3.1
End before the limit
REM one
END
