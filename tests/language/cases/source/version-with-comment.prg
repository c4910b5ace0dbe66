　3.1	　// of the language
t
END
