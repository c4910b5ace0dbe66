3.1
Detect floor type four
DETECT_FLOOR F1 4
END
