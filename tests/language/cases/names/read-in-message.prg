3.1
read in message
DEF_VAR A B
MESSAGE one %A% and %B
SLEEP 20
END
