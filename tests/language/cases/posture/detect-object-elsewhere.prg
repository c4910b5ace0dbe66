3.1
Detect object elsewhere
DETECT_OBJECT 1
END
