3.1
A title
time.sleep(1)
END
