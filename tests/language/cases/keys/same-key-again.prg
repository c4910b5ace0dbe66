3.1
Same key again
KEY_IN
KEY_IN
END
