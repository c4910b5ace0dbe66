3.1
no end in comment
SLEEP 20
// END
