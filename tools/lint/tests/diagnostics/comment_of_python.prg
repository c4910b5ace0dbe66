3.1
A title
# comment
REM
END
