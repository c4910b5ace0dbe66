3.2
A joint that is locked
LOCK J12
PTP F1 -391 201 -190
END
