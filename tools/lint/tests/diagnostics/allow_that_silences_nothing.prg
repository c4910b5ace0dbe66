3.1
A title
SLEEP 1000 // tip: allow(W118)
END
