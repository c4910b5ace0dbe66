3.1
The third statement stops it, before its cycle takes time
REM
REM
PTP F1 0 0 0 // inside the body
END
