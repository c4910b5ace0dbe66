3.1
Nothing on the screen while the camera runs
SILENT_ON
MESSAGE action
SLEEP 100
SILENT_OFF
MESSAGE cut
END
