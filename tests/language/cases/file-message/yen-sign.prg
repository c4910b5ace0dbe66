3.2
Yen sign
F_MESSAGE a¥tb¥n
END
