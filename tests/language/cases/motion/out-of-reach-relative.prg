3.1
Out of reach relative
REL_PTP F3 0 0 -250
END
