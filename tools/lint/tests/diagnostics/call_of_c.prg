3.1
A title
lift(1);
ALL_STOP
END
