3.1
operators need no blanks
DEF_VAR A,B
L1:A=1;B=A+-2
IF A<>B GOTO L1:
IF A>=-B GOTO L1:
A*=B;B-=-1
SLEEP A
END
