3.1
broken loops keep their blocks
WHILE 左
WEND
REPEAT
UNTIL 左
FOR 左 = 1 TO 2
NEXT
END
