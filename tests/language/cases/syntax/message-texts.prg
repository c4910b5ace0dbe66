3.1
message texts
MESSAGE
MESSAGE  
MESSAGE \a bell\t tab \\n \N
MESSAGE : text
MESSAGE = 5
MESSAGE,text
END
