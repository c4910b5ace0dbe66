3.1
A title
SLEEP 10 ; 待つ
END
