3.1
t
END
