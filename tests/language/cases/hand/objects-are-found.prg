3.1
Fingertips find a cylinder by force, then by springs; a fourth way there is not
DETECT_OBJECT 1
DETECT_OBJECT 3.9
MESSAGE found
DETECT_OBJECT 4
END
