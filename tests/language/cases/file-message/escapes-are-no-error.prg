3.2
Escapes are no error
F_MESSAGE a\nb\t\q\
F_MESSAGE
END
