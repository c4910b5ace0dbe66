3.1
Statements of one line
DEF_VAR A
A = 1 ;; A = 2; A = 3 ;
; END
