3.1
Text as it stands
MESSAGE Hello, World
MESSAGE   two  words   
message if x = 1 then "quoted"
MESSAGE	tab behind the command
END
