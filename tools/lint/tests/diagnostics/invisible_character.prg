3.1
A title
​ALL_STOP
END
