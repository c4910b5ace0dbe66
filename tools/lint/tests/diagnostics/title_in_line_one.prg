3.1 my walk
SLEEP 100
END
