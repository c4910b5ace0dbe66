3.1
A title
REM: note
SLEEP 10
END
