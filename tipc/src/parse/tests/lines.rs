//! Lines, labels, comments, lengths and texts.

use super::{check, check_whole};

/// A `Format error` at `column` of line 1, beside `statements`.
#[track_caller]
fn format_error(body: &str, statements: &[&str], column: u32) {
    let place = format!("1:{column}: Format error");
    let expected: Vec<&str> = statements.iter().copied().chain([place.as_str()]).collect();
    check(body, &expected);
}

// clauses: 1.5
#[test]
fn the_first_end_ends_the_program() {
    check_whole("A = 1; END ; PTP ＆\nelse garbage = = \n", &["set A = 1.0"]);
    check_whole("END 5 garbage 全角", &[]);
    check_whole("end // done", &[]);
    check_whole("ENDE", &["command ENDE", "1:1: Not exist END"]);
    check_whole(
        "A = 1\n\n  B = 2  \n",
        &["set A = 1.0", "set B = 2.0", "3:3: Not exist END"],
    );
    check_whole("A = 1 // END\n\n", &["set A = 1.0", "2:1: Not exist END"]);
    check_whole("REM END", &["rem", "1:1: Not exist END"]);
}

// clauses: 1.9 1.10
#[test]
fn comments_go_first_and_semicolons_separate() {
    check("A = 1 // B = 2 ; C = 3", &["set A = 1.0"]);
    check("A = 1 ;; B = 2 ;", &["set A = 1.0", "set B = 2.0"]);
    check("; ,; //", &[]);
    check("REM text; A = 1", &["rem", "set A = 1.0"]);
    check("MESSAGE a; A = 1", &["message [a]", "set A = 1.0"]);
    check("A = 4/ /2", &["broken Plain", "1:8: Wrong equation format"]);
}

// clauses: 1.9
#[test]
fn a_comment_in_a_message_is_warned_of() {
    let warning = "the comment cuts this MESSAGE text";
    check(
        "MESSAGE see http://x",
        &["message [see http:]", &format!("1:18: {warning}")],
    );
    check("MESSAGE // x", &["message []", &format!("1:9: {warning}")]);
    check("MESSAGE// x", &["message []"]);
    check("MESSAGE a; A = 1 // x", &["message [a]", "set A = 1.0"]);
    check("REM see http://x", &["rem"]);
}

// clauses: 2.1
#[test]
fn labels_may_share_the_line() {
    check("L1:", &["label L1"]);
    check("l1: A = 1", &["label L1", "set A = 1.0"]);
    check("L1: L2:A = 1", &["label L1", "label L2", "set A = 1.0"]);
    check("L1 : A = 1", &["label L1", "set A = 1.0"]);
    check("10:", &["label 10"]);
    check(
        ": A = 1",
        &["broken Plain", "set A = 1.0", "1:1: Wrong argument"],
    );
    check("MESSAGE : a", &["message [: a]"]);
    check("MESSAGE: a", &["broken Plain", "1:1: Wrong argument"]);
    check("REM : a", &["rem"]);
}

// clauses: 1.10
#[test]
fn lone_words_want_their_line() {
    check(
        "ELSE\nENDIF // x\nL1: WEND\n; REPEAT ;",
        &["else", "endif", "label L1", "wend", "repeat"],
    );
    format_error("ELSE X = 1", &["else"], 1);
    format_error("ELSE = 1", &["else"], 1);
    format_error("ELSE ; X = 1", &["else", "set X = 1.0"], 1);
    format_error("X = 1; ENDIF", &["set X = 1.0", "endif"], 8);
    format_error("WEND ; L1:", &["wend", "label L1"], 1);
    format_error("ELSE X = 1 ; Y = 1", &["else", "set Y = 1.0"], 1);
    check(
        "ENDIF ; ENDIF",
        &["endif", "endif", "1:1: Format error", "1:9: Format error"],
    );
    check_whole("ENDIF ; END", &["endif", "1:1: Format error"]);
    check("SUBEND ; RETURN", &["subend", "return"]);
}

// clauses: 1.6 1.11
#[test]
fn full_width_spaces_are_blanks() {
    check("　PTP　F1　1,2,3　", &["command PTP F1 1.0 2.0 3.0"]);
    check("MESSAGE　a　b　", &["message [a  b]"]);
    check(
        "L1　: A = -　B",
        &["label L1", "broken Plain", "1:10: Wrong equation format"],
    );
}

// clauses: 1.8
#[test]
fn other_wide_characters_are_refused_in_words() {
    format_error("PTP Ｆ1", &["broken Plain"], 5);
    format_error("A = ｱ", &["broken Plain"], 5);
    format_error("あ: A = 1", &["broken Plain", "set A = 1.0"], 1);
    format_error("IF あ THEN", &["broken If"], 4);
    format_error("DEF_VAR A あ B", &["define Var A B"], 11);
    format_error("ELSE あ", &["else"], 6);
    format_error("A = 1\u{C}", &["broken Plain"], 6);
    check("A = 1 // ｱあ", &["set A = 1.0"]);
    check("REM ｱあ\nMESSAGE ｱあ", &["rem", "message [ｱあ]"]);
}

// clauses: 1.7
#[test]
fn case_is_folded_but_in_texts() {
    check(
        "message Ab\nptp f1 p.x",
        &["message [Ab]", "command PTP F1 P.X"],
    );
}

// clauses: 1.12
#[test]
fn blank_lines_are_nothing() {
    check("\n  \t\n　\nA = 1\n\n", &["set A = 1.0"]);
}

// clauses: 1.2
#[test]
fn names_have_at_most_32_bytes() {
    let (fits, long) = ("A".repeat(32), "A".repeat(33));
    check(&format!("{fits}:"), &[&format!("label {fits}")]);
    format_error(&format!("{long}:"), &[&format!("label {long}")], 1);
    check(&format!("DEF_VAR {fits}"), &[&format!("define Var {fits}")]);
    format_error(
        &format!("DEF_VAR {long}"),
        &[&format!("define Var {long}")],
        9,
    );
    format_error(
        &format!("SUBROUTINE {long}:"),
        &[&format!("subroutine {long}")],
        12,
    );
}

// clauses: 1.2
#[test]
fn lines_have_at_most_1023_bytes() {
    check(&format!("REM {}", "a".repeat(1019)), &["rem"]);
    check("REM 1", &["rem"]);
    format_error_first(&format!("REM {}", "a".repeat(1020)), 1024);
    check(&format!("// {}", "あ".repeat(510)), &[]);
    format_error_first(&format!("//  {}", "あ".repeat(510)), 514);
    check_whole(&format!("END\n{}", "a".repeat(2000)), &[]);
}

/// A line whose length is wrong from `column` on; its statements are not looked at.
#[track_caller]
fn format_error_first(body: &str, column: u32) {
    let statements: &[&str] = if body.starts_with("REM") {
        &["rem"]
    } else {
        &[]
    };
    format_error(body, statements, column);
}

// clauses: 7.47 1.2
#[test]
fn message_texts_are_checked() {
    let fits = "あ".repeat(35);
    check(&format!("MESSAGE {fits}"), &[&format!("message [{fits}]")]);
    check(
        &format!("MESSAGE {fits}a"),
        &[&format!("message [{fits}a]"), "1:44: too much long string"],
    );
    check(
        &format!("MESSAGE {}", "¥t".repeat(35)),
        &[&format!("message [{}]", "¥t".repeat(35))],
    );
    check("MESSAGE a\\nb", &["message [a\\nb]", "1:10: Format error"]);
    check("MESSAGE a¥nb", &["message [a¥nb]", "1:10: Format error"]);
    check("MESSAGE a\\\\nb \\N", &["message [a\\\\nb \\N]"]);
    check("MESSAGE", &["message []"]);
    check("MESSAGE, a, ", &["message [a,]"]);
    check("MESSAGE=5", &["broken Plain", "1:8: Wrong argument"]);
}
