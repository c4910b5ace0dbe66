3.1
Percent that is text
DEF_VAR A
DEF_POS P
A = 1
P.X = 2
MESSAGE 100% sure
MESSAGE %B% %P.X% %P% %CHAR_A%
MESSAGE %A.8% %A.% %A.12% %A.x%
MESSAGE % A% %A % %%
P = P
END
