3.1
Names
Def_Var _, x9, a, Hs, r
_ = 1
X9 = _
A = x9 + 1
HS = a
R = Hs
r += r
end
