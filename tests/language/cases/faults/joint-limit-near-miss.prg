3.1
Joint limit near miss
SLEEP 100
END
