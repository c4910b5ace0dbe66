3.1
lower case
def_var a
a = sqrt 400
l1: if a <> 20 goto L1:
sleep A
Message Mixed Case
rem Any Thing
end
