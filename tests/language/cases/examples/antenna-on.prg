3.1
Wait until the palm touches something
WHILE !ANTENNA_ON
WEND
MESSAGE touched
END
