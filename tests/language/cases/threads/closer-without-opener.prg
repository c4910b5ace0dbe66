3.2
Closer without opener
EXIT
THREADEND
END
