MESSAGE <<leg>>
PTP_ANGLE <<leg>> <<bent>>
WAIT_INPOS <<leg>>
PTP_ANGLE <<leg>> <<initial>>
WAIT_INPOS <<leg>>

