3.1
Rel ptp of titan8: forms that run
DEF_POS D
D.X = 0; D.Y = 0; D.Z = 1
REL_PTP F1 0 0 1
REL_PTP HS F1 0 0 1
REL_PTP F1 D
REL_PTP HS F1 D
END
