3.1
TITAN VIII stands up, feels that all feet carry, and sways its body in circles

// SPECIAL 30 radius turns: sways the body along a circle (mm)
// SPECIAL 31 volts: SPECIAL_FLAG0 tells whether every sole reads more than that

// tip: allow(W123)

DEF_VAR RADIUS, TURNS, CLEAR, ENOUGH, SETTLE

RADIUS = 40  // mm
TURNS = 2
CLEAR = 50    // mm between belly and floor
ENOUGH = 0.6  // V on each sole: about half of what it reads when all stand alike
SETTLE = 200  // ms

MESSAGE standing up
STAND_UP CLEAR
SLEEP SETTLE

SPECIAL 31 ENOUGH
IF !SPECIAL_FLAG0 THEN
  MESSAGE a foot hangs in the air, so no dance
ELSE
  MESSAGE swaying %TURNS% times around, %RADIUS% mm wide
  SPECIAL 30 RADIUS TURNS
  SLEEP SETTLE
ENDIF

MESSAGE sitting down
SIT_DOWN CLEAR
END
