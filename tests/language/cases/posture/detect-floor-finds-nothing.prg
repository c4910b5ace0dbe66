3.1
Detect floor finds nothing
DETECT_FLOOR ALL 2
END
