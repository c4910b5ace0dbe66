3.1
Lift the front feet in turn until somebody presses Q
DEF_VAR VAR01, VAR10
DEF_POS POS01

VAR01 = 40.0     // height
POS01.X = -391 ; // is text here
POS01.Y = 201
POS01.Z = -200
SET_JUST_POSITION ALL 1.5
SET_V_MAX ALL 250.0

AGAIN :
    ptp F1 R 0 R 0 R VAR01
    set_near_position F1 8.0 ; wait_near F1
    ptp F1 POS01
    wait_inpos F1
    MESSAGE foot %VAR01%, height %VAR01.6%
    IF !KB_HIT GOTO AGAIN:
    KEY_IN VAR10
    IF VAR10 == CHAR_Q GOTO STEP_1:
    GOTO AGAIN:

STEP_1 :
initial_posture
wait_inpos all
END
