3.1
no break space
SLEEP 20
END
