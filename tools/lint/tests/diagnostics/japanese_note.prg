3.1
A title
SLEEP 100 ※少し待つ
END
