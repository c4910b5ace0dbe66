3.1
Detect floor type zero
DETECT_FLOOR ALL 0.9
END
