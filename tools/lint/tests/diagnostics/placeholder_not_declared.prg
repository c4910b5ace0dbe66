3.1
A title
MESSAGE battery at %VOLTS% V
END
