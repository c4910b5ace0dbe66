2.0
t
END
