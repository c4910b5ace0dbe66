3.1
A title
/* The robot stands up,
   then it waits. */
SLEEP 100
END
