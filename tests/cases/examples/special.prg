3.1
The fingertip of F1 rolls what it holds, for 0.3 s
SPECIAL 14 40                // 40 Hz
SPECIAL 11 4 2               // clockwise, 2 V
SLEEP 300
SPECIAL 10                   // off
END
