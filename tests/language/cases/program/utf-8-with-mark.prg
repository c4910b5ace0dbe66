3.1
印付き
MESSAGE　印
END
