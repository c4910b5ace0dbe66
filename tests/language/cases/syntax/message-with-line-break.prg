3.1
message with line break
MESSAGE a\nb
MESSAGE a¥nb
END
