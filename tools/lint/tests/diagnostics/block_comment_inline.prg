3.1
A title
SLEEP 10 /* wait */
END
