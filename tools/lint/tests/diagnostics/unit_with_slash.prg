3.1
A title
SET_V_MAX ALL 50 mm/s
END
