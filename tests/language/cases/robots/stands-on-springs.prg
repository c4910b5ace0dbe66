3.1
A robot stands on four springs
// 20.012 kg on four legs: 20.012 * 9.80665 / 4 = 49.0627 N each. A spring of 4 N/mm gives way by 12.266 mm, one of
// 2 N/mm by 24.531 mm.
DEF_VAR HEIGHT, GAP
DEF_POS P
SLEEP 500
TEACH_POSITION F1 P
HEIGHT = P.Z
SET_POSITION_STIFFNESS ALL 4 4 4
COMPLIANCE_POSITION ALL R 0 R 0 R 0
SLEEP 8000
TEACH_POSITION F1 P
GAP = P.Z - HEIGHT
GAP -= 12.266
GAP = ABS GAP
IF GAP < 0.1 THEN
  MESSAGE each gives way by its force over its stiffness
ENDIF
SET_POSITION_STIFFNESS ALL 2 2 2
SLEEP 8000
TEACH_POSITION F1 P
GAP = P.Z - HEIGHT
GAP -= 24.531
GAP = ABS GAP
IF GAP < 0.2 THEN
  MESSAGE twice as far on springs half as stiff
ENDIF
END
