3.1
My first program
MESSAGE hello
END
