3.2
Struct placeholders
DEF_VAR A
DEF_POS P
DEF_JOINT Q
A = 1.25; P.X = 1.5; P.Y = -2.5; P.Z = 3
Q.J1 = 0.125; Q.J2 = -0.5; Q.J3 = 100
MESSAGE %P%|%Q%|%A%
MESSAGE %P.1% %Q.2% %p.0%
MESSAGE %P.X% %P.Y.1% %Q.J1.3% %q.j3% %P.Z.0%
MESSAGE %P.J1% %Q.X% %A.X% %P.X.8% %P.8% %Q.J4.1% %NONE% %P.X.Y%
MESSAGE %P%%Q.J2.1%% %-P% %P.-1%
END
