3.1 beta
t
END
