3.1
no end in texts
REM END
MESSAGE END
