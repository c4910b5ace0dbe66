3.1

DEF_VAR VAR1, VAR02
SET_A_MAX	ALL 400    // gently
SET_V_MAX_SLOW ALL
// lean towards the side that VR2 asks for
VAR1 = 30
LEAN :
    AD_IN VR2 VAR02
    IF VAR02 > 2.5 GOTO RIGHT:
    VAR1 = -VAR1    // the other side
RIGHT :
    REL_PTP F1 0 0 VAR1
    REL_PTP F3 0 0 VAR1
    WAIT_INPOS ALL
    GOTO LEAN:
END
