3.1
A title
pinMode(13, OUTPUT);
SLEEP 100
END
