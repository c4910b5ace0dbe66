1.0
A_MAX	ALL 400    // gently
V_MAX_SLOW ALL
REM lean towards the side that VR2 asks for
VAR1 = 30
LEAN :
    AD_IN VR2 VAR02
    IF VAR2 > 2.5 GOTO RIGHT:
    VAR01 = - VAR1    // the other side
RIGHT :
    REL_PTP F1 0 0 VAR1
    REL_PTP F3 0 0 VAR1
    WAIT_INPOS ALL
    GOTO LEAN:
END
