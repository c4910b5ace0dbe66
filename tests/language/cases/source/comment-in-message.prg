3.1
comment in message
MESSAGE see http://example
MESSAGE a / b
MESSAGE a; SLEEP 20 // fine
REM see http://example
END
