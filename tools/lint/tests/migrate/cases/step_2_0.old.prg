2.0
Lift the front feet in turn until somebody presses Q

VAR01 = 40.0     // height
POS01.X = -391 ; REM is text here
POS01.Y = 201
POS01.Z = -200
SET_INPOS ALL 1.5
SET_V_MAX ALL 250.0

AGAIN :
    ptp F1 R 0 R 0 R VAR01
    wait_near F1 8.0
    ptp F1 POS01
    wait_inpos F1
    MESSAGE foot %d01%, height %f01%
    IF !KB_HIT GOTO AGAIN:
    KEY_IN VAR10
    IF VAR10 == CHAR_Q GOTO STEP:
    GOTO AGAIN:

STEP :
initial_posture
wait_inpos all
END
