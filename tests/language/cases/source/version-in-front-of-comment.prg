3.1// now
t
END
