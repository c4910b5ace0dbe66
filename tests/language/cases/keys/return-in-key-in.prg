3.1
Return in key in
KEY_IN
END
