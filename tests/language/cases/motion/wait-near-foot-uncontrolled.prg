3.1
Wait near foot uncontrolled
REM one
WAIT_NEAR F1
END
