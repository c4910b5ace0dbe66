2.50
An older machine
END