3.1
A title
(move to start)
SLEEP 100
END
