3.1
Demanded second edition
END
