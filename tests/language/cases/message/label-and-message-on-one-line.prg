3.1
Label and message on one line
L1: MESSAGE Label: kept
MESSAGE a ;MESSAGE b
END
