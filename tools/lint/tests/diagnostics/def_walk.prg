3.1
A title
CALL WALK:
EXIT
def walk(n):
  SLEEP 100
  RETURN
END
