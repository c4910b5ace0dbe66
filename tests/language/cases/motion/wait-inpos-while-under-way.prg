3.1
Wait inpos while under way
PTP F1 -391 251 -200
WAIT_INPOS F1
END
