3.0
Another number below
END
