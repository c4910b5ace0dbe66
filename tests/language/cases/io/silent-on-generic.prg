3.1
Silent on generic
SILENT_ON
SILENT_OFF
END
