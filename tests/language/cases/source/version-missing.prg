
t
END
