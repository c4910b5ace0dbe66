3.1
Emergency key at once
END
