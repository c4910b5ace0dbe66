3.3
mark
END
