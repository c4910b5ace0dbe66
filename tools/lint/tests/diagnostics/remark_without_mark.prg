3.1
A title
足を少しずつ上げる
PTP F1 R 0 R 0 R 20
END
