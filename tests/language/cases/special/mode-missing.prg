3.1
Mode missing
SPECIAL 12
END
