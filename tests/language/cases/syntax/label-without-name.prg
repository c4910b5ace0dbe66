3.1
label without name
: SLEEP 20
END
