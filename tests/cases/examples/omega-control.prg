3.1
Turn a leg forward until somebody asks to halt
OMEGA_CONTROL J11 15
WHILE !HALT_REQUEST
WEND
OMEGA_CONTROL J11 0
END
