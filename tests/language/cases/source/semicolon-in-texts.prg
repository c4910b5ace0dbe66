3.1
semicolon in texts
MESSAGE a;FOO
REM b;BAR
END
