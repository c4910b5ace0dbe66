3.1
full width spaces
　DEF_VAR　A,　B
A　=　20
　B　=　A　+　A　
SLEEP　B
L1　: SLEEP　A
　END
