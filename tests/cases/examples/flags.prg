3.1
A motion with one coordinate as it is, one absolute and one relative
PTP HS F1 R 0 A 251 R 20     // HS: without limit of acceleration
WAIT_INPOS F1
END
