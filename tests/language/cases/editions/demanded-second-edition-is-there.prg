3.2
Demanded second edition is there
LOCK F1
END
