3.1
no end but blank lines
SLEEP 20


