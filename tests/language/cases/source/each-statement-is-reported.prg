3.1
each statement is reported
FOO ; SLEEP 20 ; BAR ; BAZ
END
