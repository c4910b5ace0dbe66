3.1
Close the fingers until they touch
DETECT_OBJECT 3
MESSAGE it is there
END
