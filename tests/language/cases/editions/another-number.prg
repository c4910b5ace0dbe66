3.3
Another number
END
