3.1
The shortest program
END
