3.1
undeclared left side
FOO = 5
BAR += 1
END
