3.1
delimiters
PTP,F1,,R	10 , 0	,0
PTP F1 R 10 0 0
,SLEEP,20,
END
