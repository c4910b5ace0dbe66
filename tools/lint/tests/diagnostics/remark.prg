3.1
A title
REMARK this is it
SLEEP 100
END
