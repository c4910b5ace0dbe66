//! Fixes that every reader means.

use super::{Certain, check_certain, check_kept, repaired};

// clauses: 7.20
#[test]
fn words_that_close_blocks() {
    for word in ["ENDWHILE", "END_WHILE", "WHEND"] {
        check_certain(
            &format!("WHILE KB_HIT\nREM\n{word}"),
            "WHILE KB_HIT\nREM\nWEND",
        );
    }
    for word in ["END IF", "END_IF", "FI", "END  IF"] {
        check_certain(
            &format!("IF KB_HIT THEN\nREM\n{word}\nALL_STOP"),
            "IF KB_HIT THEN\nREM\nENDIF\nALL_STOP",
        );
    }
    check_certain(
        "WHILE KB_HIT\nREM\nEND WHILE\nALL_STOP",
        "WHILE KB_HIT\nREM\nWEND\nALL_STOP",
    );
    check_certain(
        "CALL S:\nEXIT\nSUBROUTINE S:\nEND SUB",
        "CALL S:\nEXIT\nSUBROUTINE S:\nSUBEND",
    );
    check_certain(
        "DEF_VAR I\nFOR I = 1 TO 3\nENDFOR",
        "DEF_VAR I\nFOR I = 1 TO 3\nNEXT",
    );
    check_certain(
        "CALL S:\nEXIT\nSUB S\nRET\nENDSUB",
        "CALL S:\nEXIT\nSUBROUTINE S:\nRETURN\nSUBEND",
    );
    check_certain(
        "IF KB_HIT THEN\nif halt_request then\nend if\nfi",
        "IF KB_HIT THEN\nif halt_request then\nendif\nendif",
    );
}

// clauses: 5.1 7.1
#[test]
fn relations_words_and_characters_of_other_languages() {
    let with =
        |relation: &str| format!("DEF_VAR N\nAD_IN VR1 N\nIF N {relation} 3 THEN\nREM\nENDIF");
    check_certain(&with("==="), &with("=="));
    // What a word means is for the author to say.
    check_kept(&with("EQ"));
    for (foreign, right) in [
        ("INITIAL POSTURE", "INITIAL_POSTURE"),
        ("SET V MAX F1 100", "SET_V_MAX F1 100"),
        ("PTP ANGLE J11 30", "PTP_ANGLE J11 30"),
        ("WAIT INPOS ALL", "WAIT_INPOS ALL"),
        ("SLEEP: 100", "SLEEP 100"),
        ("SLEEP100", "SLEEP 100"),
        ("SLEEP \u{200B}100", "SLEEP 100"),
        ("PTP F1 391 201 ー150", "PTP F1 391 201 -150"),
    ] {
        check_certain(foreign, right);
    }
}

// clauses: 5.1 7.20
#[test]
fn two_mistakes_of_one_line() {
    let declared = |block: &str| format!("DEF_VAR N\nAD_IN VR1 N\n{block}\nREM\nENDIF");
    let right = declared("IF N == 1 THEN");
    for wrong in ["IF N = 1", "IF (N = 1) THEN", "IF N === 1"] {
        check_certain(&declared(wrong), &right);
    }
    check_certain(
        "WHILE NOT KB_HIT DO\nSLEEP 10\nWEND",
        "WHILE !KB_HIT\nSLEEP 10\nWEND",
    );
}

// clauses: 7.20
#[test]
fn branches_of_other_languages() {
    let with = |branch: &str| format!("IF KB_HIT THEN\nREM\n{branch}\nREM\nENDIF");
    let right = with("ELSEIF HALT_REQUEST THEN");
    for branch in [
        "ELIF HALT_REQUEST THEN",
        "ELIF HALT_REQUEST",
        "ELIF HALT_REQUEST:",
        "ELSE IF HALT_REQUEST THEN",
        "ELSE IF HALT_REQUEST",
        "ELSEIF HALT_REQUEST",
    ] {
        check_certain(&with(branch), &right);
    }
}

// clauses: 6.6
#[test]
fn what_belongs_after_a_condition() {
    let right = "IF KB_HIT THEN\nREM\nENDIF";
    for opener in ["IF KB_HIT", "IF KB_HIT:", "IF (KB_HIT) THEN"] {
        check_certain(&format!("{opener}\nREM\nENDIF"), right);
    }
    let right = "WHILE KB_HIT\nREM\nWEND";
    for opener in ["WHILE KB_HIT DO", "WHILE KB_HIT:", "WHILE KB_HIT THEN"] {
        check_certain(&format!("{opener}\nREM\nWEND"), right);
    }
    check_certain("if kb_hit\nrem\nendif", "if kb_hit then\nrem\nendif");
    for jump in ["IF KB_HIT THEN GOTO L1:", "IF KB_HIT GOTO L1: THEN"] {
        check_certain(&format!("L1: {jump}"), "L1: IF KB_HIT GOTO L1:");
    }
    check_certain(
        "IF KB_HIT CALL S:\nEXIT\nSUBROUTINE S:\nSUBEND",
        "IF KB_HIT GOSUB S:\nEXIT\nSUBROUTINE S:\nSUBEND",
    );
}

// clauses: 6.6 1.10
#[test]
fn an_if_on_one_line() {
    check_certain(
        "  IF KB_HIT THEN ALL_STOP // stop",
        "  IF KB_HIT THEN\n    ALL_STOP\n  ENDIF // stop",
    );
    let right = "IF KB_HIT THEN\n  ALL_STOP\nELSE\n  REM x\nENDIF";
    let one_line = "IF KB_HIT THEN ALL_STOP ELSE REM x";
    check_certain(one_line, right);
    check_certain(
        "IF KB_HIT THEN ALL_STOP ENDIF",
        "IF KB_HIT THEN\n  ALL_STOP\nENDIF",
    );
    check_certain(
        "IF KB_HIT THEN ALL_STOP\nELSE\nREM\nENDIF",
        "IF KB_HIT THEN\n  ALL_STOP\nELSE\nREM\nENDIF",
    );
    // Does THEN hold both?
    check_kept("IF KB_HIT THEN ALL_STOP; REM");
    // Where its ENDIF stands, more belongs to it.
    check_kept("IF KB_HIT THEN ALL_STOP\nREM\nENDIF");
}

// clauses: 1.10
#[test]
fn words_that_stand_alone() {
    check_certain(
        "IF KB_HIT THEN\nELSE ALL_STOP\nENDIF",
        "IF KB_HIT THEN\nELSE\nALL_STOP\nENDIF",
    );
    check_certain("WHILE KB_HIT; REM; WEND", "WHILE KB_HIT; REM\nWEND");
    check_certain(
        "\tREPEAT; REM; UNTIL KB_HIT // x",
        "\tREPEAT\n\tREM; UNTIL KB_HIT // x",
    );
    check_certain(
        "IF KB_HIT THEN\nELSE:\nENDIF",
        "IF KB_HIT THEN\nELSE\nENDIF",
    );
    check_certain("MESSAGE: hello", "MESSAGE hello");
}

// clauses: 6.1 6.3
#[test]
fn labels_and_their_colons() {
    check_certain("L1: REM\nGOTO L1", "L1: REM\nGOTO L1:");
    check_certain("L1: REM\nGOTO L1 :", "L1: REM\nGOTO L1:");
    check_certain("L1.\nREM\nGOTO L1:", "L1:\nREM\nGOTO L1:");
    check_certain("START\nGOTO START:", "START:\nGOTO START:");
    check_certain("LOOP\nGOTO LOOP", "LOOP:\nGOTO LOOP:");
    check_certain(
        "CALL S\nEXIT\nSUBROUTINE S\nSUBEND",
        "CALL S:\nEXIT\nSUBROUTINE S:\nSUBEND",
    );
    check_certain("L1: REM\nJUMP L1", "L1: REM\nGOTO L1:");
    check_certain("L1: REM\nGO TO L1:", "L1: REM\nGOTO L1:");
    check_certain("CALL L1:\nEXIT\nL1: RETURN", "GOSUB L1:\nEXIT\nL1: RETURN");
    // A label that is nowhere stays the mistake that it is.
    check_kept("GOTO NOWHERE");
    // Nothing says that this is a label.
    check_kept("LOOP");
}

// clauses: 5.1
#[test]
fn relations_of_other_languages() {
    let with = |relation: &str| format!("DEF_VAR A\nA = 1\nIF A {relation} 1 THEN\nENDIF");
    for (foreign, right) in [
        ("!=", "<>"),
        ("!==", "<>"),
        ("><", "<>"),
        ("=", "=="),
        ("===", "=="),
        ("=>", ">="),
        ("=<", "<="),
    ] {
        check_certain(&with(foreign), &with(right));
    }
    check_certain("IF NOT KB_HIT THEN\nENDIF", "IF !KB_HIT THEN\nENDIF");
    check_kept("DEF_VAR A\nA = 1\nWHILE NOT A < 1\nWEND");
}

// clauses: 4.1 3.5
#[test]
fn equations_of_other_languages() {
    let with = |line: &str| format!("DEF_VAR A\nA = 1\n{line}\nSLEEP A");
    for (foreign, right) in [
        ("A++", "A += 1"),
        ("A--", "A -= 1"),
        ("A ++", "A += 1"),
        ("A == 2", "A = 2"),
        ("A := 2", "A = 2"),
        ("LET A = 2", "A = 2"),
        ("A = (A + 2)", "A = A + 2"),
        ("A = SIN(A)", "A = SIN A"),
        ("A = ATAN2(A, -1)", "A = ATAN2 A, -1"),
        ("SLEEP(A)", "SLEEP A"),
        ("PTP(F1, 1, 2, -3)", "PTP F1, 1, 2, -3"),
        ("PTP F1 (1 2 3)", "PTP F1 1 2 3"),
    ] {
        check_certain(&with(foreign), &with(right));
    }
    for calculation in [
        "A = (A + 2) * 3",
        "A = -(A + 2)",
        "A = SIN(A + 1)",
        "A = SIN(A) + 1",
        "A = ((A))",
        "PTP(F1, A - 1, 2)",
    ] {
        check_kept(&with(calculation));
    }
}

// clauses: 3.1
#[test]
fn declarations_of_other_languages() {
    let right = "DEF_VAR N\nN = 100\nSLEEP N";
    for foreign in [
        "DEF N\nN = 100",
        "DEF VAR N\nN = 100",
        "VAR N\nN = 100",
        "DEF_VAR N = 100",
        "INT N = 100",
    ] {
        check_certain(&format!("{foreign}\nSLEEP N"), right);
    }
    check_certain(
        "  DEF_VAR N=-1 // less\n  N = N",
        "  DEF_VAR N\n  N = -1 // less\n  N = N",
    );
}

// clauses: 1.9
#[test]
fn comments_of_other_languages() {
    for (foreign, right) in [
        ("# walk", "// walk"),
        ("#walk", "//walk"),
        ("' walk", "// walk"),
        ("/* walk */", "// walk"),
        ("/* walk", "/* walk"),
        ("# 歩く", "// 歩く"),
        ("-- walk", "// walk"),
        ("SLEEP 100 # wait", "SLEEP 100 // wait"),
        ("SLEEP 100 ' wait", "SLEEP 100 // wait"),
        ("SLEEP 100 # 待つ", "SLEEP 100 // 待つ"),
    ] {
        check_certain(foreign, right);
    }
    // These do something.
    check_kept("/* walk */ SLEEP 100");
}

// clauses: 7.35
#[test]
fn texts_for_people() {
    for (foreign, right) in [
        ("PRINT \"Hello\"", "MESSAGE Hello"),
        ("print 'hello'", "message hello"),
        ("PRINT(\"Hello\")", "MESSAGE Hello"),
        ("printf(\"hello\\n\")", "message hello"),
        ("PRINT \"歩く\"", "MESSAGE 歩く"),
        ("MESSAGE\"hi\"", "MESSAGE hi"),
        ("MESSAGE(\"歩く\")", "MESSAGE 歩く"),
        ("MESSAGE hello\\n", "MESSAGE hello"),
    ] {
        check_certain(foreign, right);
    }
    for text in ["PRINT \"%d\"", "PRINT A, \"x\"", "PRINT", "MESSAGE a\\nb"] {
        check_kept(text);
    }
}

// clauses: 1.8
#[test]
fn full_width_characters() {
    for (wide, narrow) in [
        ("ＳＬＥＥＰ　１００", "SLEEP　100"),
        ("SLEEP １０．５", "SLEEP 10.5"),
        ("ＬＯＯＰ：\nＧＯＴＯ　ＬＯＯＰ：", "LOOP:\nGOTO　LOOP:"),
        ("ＭＥＳＳＡＧＥ　ＡＢＣ歩", "MESSAGE　ＡＢＣ歩"),
        ("ALL_STOP；REM", "ALL_STOP;REM"),
        ("SLEEP\u{a0}100", "SLEEP 100"),
        ("PTP F1 1、2、−3", "PTP F1 1,2,-3"),
        ("ALL_STOP ／／ 止まる", "ALL_STOP // 止まる"),
    ] {
        check_certain(wide, narrow);
    }
    check_kept("SLEEP 歩く");
}

// clauses: 10.1
#[test]
fn names_of_older_editions() {
    check_certain("SET_NEAR F1 5", "SET_NEAR_POSITION F1 5");
    check_certain("wait inpos all", "wait_inpos all");
}

// clauses: 1.4 1.5
#[test]
fn the_title_and_the_end() {
    let fixed = |text: &str| repaired(text.as_bytes(), Certain).loaded.source.bytes();
    assert_eq!(
        fixed("3.1\nDEF_VAR N\nN = 1\nSLEEP N\nEND\n"),
        b"3.1\n\nDEF_VAR N\nN = 1\nSLEEP N\nEND\n"
    );
    assert_eq!(fixed("3.1\nt\nREM\n"), b"3.1\nt\nREM\nEND\n");
    assert_eq!(fixed("3.1\r\nt\r\nREM"), b"3.1\r\nt\r\nREM\r\nEND\r\n");
    assert_eq!(fixed("3.1\nt\n"), b"3.1\nt\nEND\n");
    assert_eq!(fixed("3.1"), b"3.1");
}

#[test]
fn several_mistakes_in_one_file() {
    let wrong = "DEF_VAR N = 0\nWHILE N != 3\nN++\nPRINT \"歩く\"\nENDWHILE\n# done\nGOTO L1\nL1";
    let right =
        "DEF_VAR N\nN = 0\nWHILE N <> 3\nN += 1\nMESSAGE 歩く\nWEND\n// done\nGOTO L1:\nL1:";
    check_certain(wrong, right);
}

/// A fix that would only show another mistake is not applied.
#[test]
fn a_fix_that_leads_to_another_diagnostic_is_none() {
    check_kept("IF KB_HIT THEN\nELIF KB_HIT = THEN\nENDIF");
}
