3.1
Bell and tab
MESSAGE a\ab\tc
MESSAGE \A \x \\ back
MESSAGE ¥a¥tend
END
