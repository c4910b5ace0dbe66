3.1
Take hold of what stands between the fingers
DETECT_OBJECT 1
TORQUE J11 20                // and press from the left
MESSAGE held
END
