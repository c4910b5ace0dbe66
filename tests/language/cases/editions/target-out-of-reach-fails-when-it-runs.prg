3.2
Target out of reach fails when it runs
REM
PTP F1 100 -100 0
END
