//! Fixes that most readers mean.

use super::check_likely;

// clauses: 3.1 8.1
#[test]
fn misspelled_words() {
    for (wrong, right) in [
        ("PTP_ANGEL J11 30", "PTP_ANGLE J11 30"),
        ("slep 100", "sleep 100"),
        ("IF KB_HTI THEN\nENDIF", "IF KB_HIT THEN\nENDIF"),
        ("START: REM\nGOTO STRAT:", "START: REM\nGOTO START:"),
        (
            "START: REM\nIF KB_HIT GOTO STRAT:\nGOTO STRAT:",
            "START: REM\nIF KB_HIT GOTO START:\nGOTO START:",
        ),
        (
            "DEF_POS P\nTEACH_POSITION F1 P\nP_X = 1\nPTP F1 P",
            "DEF_POS P\nTEACH_POSITION F1 P\nP.X = 1\nPTP F1 P",
        ),
        (
            "DEF_VAR STRIDE\nSTRIDE = 1\nSLEEP STRID\nSTRIDE = STRIDE + -STRID",
            "DEF_VAR STRIDE\nSTRIDE = 1\nSLEEP STRIDE\nSTRIDE = STRIDE + -STRIDE",
        ),
        (
            "DEF_POS PLACE\nPLACE.X = 1\nPTP F1 PLCE.X 2 3",
            "DEF_POS PLACE\nPLACE.X = 1\nPTP F1 PLACE.X 2 3",
        ),
    ] {
        check_likely(wrong, right);
    }
}

// clauses: 3.6
#[test]
fn numbers_of_other_countries() {
    check_likely("SLEEP 4,5", "SLEEP 4.5");
    check_likely("SLEEP 1,000", "SLEEP 1000");
}

// clauses: 3.1
#[test]
fn names_without_a_declaration() {
    check_likely(
        "DEF_VAR A\n// count\nFOR I = 1 TO 3\nA = I\nNEXT I\nSLEEP A",
        "DEF_VAR A\n// count\nDEF_VAR I\nFOR I = 1 TO 3\nA = I\nNEXT I\nSLEEP A",
    );
    check_likely("SLEEP I; SLEEP J", "SLEEP I; SLEEP J");
}

// clauses: 3.1
#[test]
fn declarations_that_nothing_uses() {
    check_likely("DEF_VAR UNUSED // x\nREM", " // x\nREM");
    check_likely("  DEF_VAR UNUSED\nREM", "REM");
    for names in ["A B USED", "A USED B", "USED, A, B"] {
        check_likely(
            &format!("DEF_VAR {names}\nUSED = 1\nSLEEP USED"),
            "DEF_VAR USED\nUSED = 1\nSLEEP USED",
        );
    }
}

// clauses: 5.1 7.4
#[test]
fn other_foreign_words() {
    check_likely("DEF_VAR N\nN = TRUE\nSLEEP N", "DEF_VAR N\nN = 1\nSLEEP N");
    check_likely("PTP J11 30", "PTP_ANGLE J11 30");
    check_likely("WAIT 200", "SLEEP 200");
    check_likely("QUIT", "EXIT");
}
