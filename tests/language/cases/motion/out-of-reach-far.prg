3.1
Out of reach far
REM one
PTP F2 391 201 -500
END
