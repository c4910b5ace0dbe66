3.1
wide label
左足: SLEEP 20
GOTO 左足:
END
