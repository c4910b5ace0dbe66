3.1
Write down what the knob said
DEF_VAR V
AD_IN VR1 V
OUTPUT_VARIABLES
END
