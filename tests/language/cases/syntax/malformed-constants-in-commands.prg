3.1
malformed constants in commands
SLEEP 1.2.3
SLEEP 1E309
PTP F1 R 10 0 0-5
PTP F1 R 10 0 - 5
PTP F1 R 10 0 -5
END
