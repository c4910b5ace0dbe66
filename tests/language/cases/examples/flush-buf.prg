3.1
What was typed before the question does not count
SLEEP 100
FLUSH_BUF
MESSAGE go on?
KEY_IN
MESSAGE the answer is key %VAR_KEY%
END
