3.1
message without blank
MESSAGE-5
MESSAGE: SLEEP 20
END
