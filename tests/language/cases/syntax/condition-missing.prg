3.1
condition missing
WHILE
WEND
REPEAT
UNTIL
END
