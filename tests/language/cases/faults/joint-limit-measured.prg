3.1
Joint limit measured
SLEEP 1000
END
