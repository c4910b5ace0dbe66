4.0
Demanded other is read as the first
DEF_VAR LOCK
LOCK = 1
SLEEP LOCK
LOCK F1
END
