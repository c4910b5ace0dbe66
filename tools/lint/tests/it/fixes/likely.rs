//! What most readers mean.

use super::{check_kept, check_likely};

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
            "DEF_VAR N\nN = 40\nN =+ 5\nSLEEP N",
            "DEF_VAR N\nN = 40\nN += 5\nSLEEP N",
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
fn other_habits() {
    check_likely(
        "DEF_VAR N\nN = TRUE\nIF N THEN\nENDIF",
        "DEF_VAR N\nN = 1\nIF N <> 0 THEN\nENDIF",
    );
    check_likely("PTP J11 30", "PTP_ANGLE J11 30");
    check_likely("WAIT 200", "SLEEP 200");
    check_likely("QUIT", "EXIT");
    check_likely("ALL_STOP SLEEP 100", "ALL_STOP\nSLEEP 100");
}

// clauses: 5.1 7.20
#[test]
fn conditions_of_two() {
    let declared = |block: &str| format!("DEF_VAR N\nAD_IN VR1 N\n{block}");
    check_likely(
        &declared("IF N == 1 AND KB_HIT THEN\n  ALL_STOP\nENDIF"),
        &declared("IF N == 1 THEN\nIF KB_HIT THEN\n  ALL_STOP\nENDIF\nENDIF"),
    );
    check_likely(
        &declared("IF N == 1 || KB_HIT GOTO L1:\nALL_STOP\nL1: REM"),
        &declared("IF N == 1 GOTO L1:\nIF KB_HIT GOTO L1:\nALL_STOP\nL1: REM"),
    );
    check_likely(
        &declared("IF N == 1 AND KB_HIT GOTO L1:\nALL_STOP\nL1: REM"),
        &declared("IF N == 1 THEN\nIF KB_HIT GOTO L1:\nENDIF\nALL_STOP\nL1: REM"),
    );
    // What else is to be done would be done in one of two cases only.
    check_kept(&declared(
        "IF N == 1 AND KB_HIT THEN\nREM\nELSE\nALL_STOP\nENDIF",
    ));
    check_kept(&declared("IF N == 1 OR KB_HIT THEN\nALL_STOP\nENDIF"));
}

// clauses: 3.2
#[test]
fn names_in_one_piece() {
    check_likely(
        "DEF_VAR STEP-LENGTH\nstep-length = 3\nSLEEP STEP-LENGTH",
        "DEF_VAR STEP_LENGTH\nstep_length = 3\nSLEEP STEP_LENGTH",
    );
}

/// What the first mistake hides has the words of the second, which is put right: it is new all the same.
// clauses: 3.1
#[test]
fn a_mistake_like_another_that_is_put_right() {
    let used = "P = 1\nSLEEP P\nTEACH_POSITION F1 Q1\nPTP F1 Q1";
    check_likely(
        &format!("DEF_VAA- P, DEF_POS Q1\n{used}"),
        &format!("DEF_VAA- P\nDEF_POS Q1\n{used}"),
    );
}
