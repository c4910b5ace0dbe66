3.1
A title
ALL_STOP // tip: allow(W999)
END
