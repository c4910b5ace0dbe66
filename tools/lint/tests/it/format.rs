//! The one style: what becomes of a program, to the byte.

use tip_lint::format::{Refusal, format};
use tip_lint::message::Formatting;
use tipc::source::Encoding;
use tipc::{Options, Robot};

/// Formats a program for the generic robot, which takes all of these; formatted again it stays as it is.
fn formatted(bytes: &[u8]) -> Result<Vec<u8>, Refusal> {
    let options = Options {
        robot: Robot::Generic,
        ..Options::default()
    };
    let once = format("p.prg", bytes, &options)?;
    let twice = format("p.prg", &once, &options).expect("a program in the style");
    assert_eq!(twice, once, "{}", String::from_utf8_lossy(&once));
    Ok(once)
}

/// Checks the statements of a program, formatted.
#[track_caller]
fn check(statements: &str, expected: &str) {
    let text = format!("3.1\ntitle\n{statements}");
    let formatted = match formatted(text.as_bytes()) {
        Ok(formatted) => String::from_utf8(formatted).expect("UTF-8"),
        Err(refusal) => panic!("{refusal:?}"),
    };
    assert_eq!(formatted, format!("3.1\ntitle\n{expected}"));
}

/// Checks the bytes of a whole file, formatted.
#[track_caller]
fn check_file(bytes: &[u8], expected: &[u8]) {
    let formatted = formatted(bytes).unwrap_or_else(|refusal| panic!("{refusal:?}"));
    let text = |bytes: &[u8]| format!("{:?}", String::from_utf8_lossy(bytes));
    assert_eq!(
        formatted,
        expected,
        "{} {}",
        text(&formatted),
        text(expected)
    );
}

// clauses: 1.7 1.10 1.11
#[test]
fn words_stand_apart_in_capital_letters() {
    check(
        "def_var a,b c\na=-1;b=a+-2 ;; c=5 -3;;c+=b\nptp f1 r -b,r b\u{3000}r c;;\nmessage_clear ,\nend",
        "DEF_VAR A, B, C\nA = -1 ; B = A + -2 ; C = 5 - 3 ; C += B\nPTP F1 R -B R B R C\nMESSAGE_CLEAR\nEND\n",
    );
}

#[test]
fn operators_stand_between_blanks_and_signs_do_not() {
    check(
        "DEF_VAR A,B\nDEF_POS P\nA=1.5e2\nB=A--2\nB-=-A\nA=ATAN2,B\t-A\nP.X=-.5;P.Y=+2;P.Z=3\nP*=P\n\
         A=NORM P\nL :IF A<-B GOTO L:\nIF !KB_HIT gosub L:\nIF A>=P.X GOTO l:\nEND",
        "DEF_VAR A, B\nDEF_POS P\nA = 1.5E2\nB = A - -2\nB -= -A\nA = ATAN2 B -A\nP.X = -.5 ; P.Y = +2 ; P.Z = 3\nP *= P\n\
         A = NORM P\nL: IF A < -B GOTO L:\nIF !KB_HIT GOSUB L:\nIF A >= P.X GOTO L:\nEND\n",
    );
}

#[test]
fn blocks_are_indented_and_labels_stand_at_the_margin() {
    check(
        "DEF_VAR N, K\nN = 1\nIF N == 1 THEN\nREM one\n// two\nELSEIF N == 2 THEN\nWHILE N < 3\nN += 1\nWEND\nELSE\n\
         AGAIN: REPEAT\nLOOP: N -= 1\nUNTIL N < 0\nENDIF\nFOR N = 1 TO 2 ; FOR K = 1 TO N STEP 1\nSLEEP K\n\
         NEXT K ; NEXT\nCALL S:\nEXIT\n      SUBROUTINE S:\nSLEEP 1\nSUBEND\nEND\n",
        "DEF_VAR N, K\nN = 1\nIF N == 1 THEN\n  REM one\n  // two\nELSEIF N == 2 THEN\n  WHILE N < 3\n    N += 1\n  WEND\nELSE\n\
         AGAIN: REPEAT\nLOOP: N -= 1\n  UNTIL N < 0\nENDIF\nFOR N = 1 TO 2 ; FOR K = 1 TO N STEP 1\n    SLEEP K\n\
         NEXT K ; NEXT\nCALL S:\nEXIT\nSUBROUTINE S:\n  SLEEP 1\nSUBEND\nEND\n",
    );
}

#[test]
fn comments_of_neighbouring_lines_stand_in_one_column() {
    check(
        "DEF_VAR N //  how often \nN = 1000 //go\nSLEEP N\nFOR N = 1 TO 3//a\n//b\nALL_STOP // c\n\n\n \t\nNEXT // \u{6b69}\u{304f}\u{3000}\n\
         MESSAGE \u{6b69}\u{304f} // 4\nSLEEP 1000 // 10\nEND",
        "DEF_VAR N  //  how often\nN = 1000   //go\nSLEEP N\nFOR N = 1 TO 3  //a\n  //b\n  ALL_STOP  // c\n\n\
         NEXT          // \u{6b69}\u{304f}\nMESSAGE \u{6b69}\u{304f}  // 4\nSLEEP 1000    // 10\nEND\n",
    );
}

// clauses: 1.7 1.9
#[test]
fn texts_keep_every_byte() {
    check(
        "  message   a,  b\u{3000} \\t %n% ;rem,  \u{ff21}  x,  ;sleep 1//z\nmessage ,a\nrem\nmessage//x\nMESSAGE  \nEND",
        "MESSAGE a,  b\u{3000} \\t %n% ; REM,  \u{ff21}  x, ; SLEEP 1  //z\nMESSAGE ,a\nREM\nMESSAGE  //x\nMESSAGE\nEND\n",
    );
}

// clauses: 1.3 1.4 1.5
#[test]
fn the_first_lines_and_what_follows_end_stay() {
    check_file(
        b" 3.1\t// v \n\t title;  a \n\n\n end ,; // x \n  not a Program\n\n\n// y  \n\n \n",
        b" 3.1\t// v \n\t title;  a \n\nEND  // x\n  not a Program\n\n\n// y  \n",
    );
    check_file(
        b"3.1\n\nend  foo ;bar // x \n",
        b"3.1\n\nEND  foo ;bar // x \n",
    );
}

// clauses: 1.1
#[test]
fn encoding_marks_and_line_ends_stay() {
    check_file(
        b"\xEF\xBB\xBF3.1\r\nt\rsleep 1\n\r\n\nsleep 2\r\nend\x1A",
        b"\xEF\xBB\xBF3.1\r\nt\rSLEEP 1\n\r\nSLEEP 2\r\nEND\r\n\x1A",
    );
    // Shift_JIS: 81 7C and EE F9 are bytes that encoding their characters again would change. 81 40 is the full-width space.
    check_file(
        b"3.1\n\x95\xE0\nsleep\x81\x401\x81\x40//\x81\x7C\xEE\xF9\x81\x40\nmessage \xED\x40\x81\x40a\nend",
        b"3.1\n\x95\xE0\nSLEEP 1  //\x81\x7C\xEE\xF9\nMESSAGE \xED\x40\x81\x40a\nEND\n",
    );
    // The line after a CR stays a line of its own.
    check_file(b"3.1\nt\nREM\r \nEND\n", b"3.1\nt\nREM\r\rEND\n");
}

#[test]
fn what_is_not_safe_is_left() {
    let refused = |bytes: &[u8]| formatted(bytes).expect_err("a reason");
    let Refusal::Diagnostics(loaded) = refused(b"3.1\nt\nFOO\nEND\n") else {
        panic!("findings");
    };
    assert_eq!(loaded.diagnostics.len(), 1);
    assert!(matches!(
        refused(b"3.1\nt\n// \xFF\nEND\n"),
        Refusal::Diagnostics(_)
    ));
    let line = format!("{}A=1", "A=1;".repeat(255));
    assert_eq!(line.len(), 1023);
    let Refusal::Because(reason) = refused(format!("3.1\nt\nDEF_VAR A\n{line}\nEND\n").as_bytes())
    else {
        panic!("a reason");
    };
    assert_eq!(
        reason,
        Formatting::LineTooLong {
            line: 4,
            limit: 1023
        }
    );
    // C2 B1 is two characters of Shift_JIS; without the full-width space before it, it would be one of UTF-8.
    let two = b"3.1\nt\n\x81\x40SLEEP 1 // \xC2\xB1\nEND\n";
    let Refusal::Because(reason) = refused(two) else {
        panic!("a reason");
    };
    assert_eq!(reason, Formatting::OtherEncoding { encoding: "UTF-8" });
    let named = Options {
        encoding: Encoding::ShiftJis,
        ..Options::default()
    };
    let formatted = format("p.prg", two, &named).expect("a program");
    assert_eq!(formatted, b"3.1\nt\nSLEEP 1  // \xC2\xB1\nEND\n");
}
