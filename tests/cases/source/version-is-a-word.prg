version
t
END
