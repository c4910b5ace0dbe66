3.1
Domain errors of the first stay warnings
SLEEP -1
END
