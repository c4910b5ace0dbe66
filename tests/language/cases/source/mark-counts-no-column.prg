3.2
mark
END
