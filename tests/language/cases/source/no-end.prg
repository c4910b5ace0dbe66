3.1
no end
SLEEP 20
