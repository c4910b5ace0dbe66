//! One mistake is one diagnostic: what follows from another diagnostic is none, and what does not is kept.

use tip_lint::{Options, load};

/// Checks the codes and lines of what is wrong with some statements; the first statement is on line 3.
#[track_caller]
fn check(statements: &str, expected: &[&str]) {
    let text = format!("3.1\nA title\n{statements}\nEND\n");
    let loaded = load("one.prg", text.as_bytes(), &Options::default());
    let found = loaded.diagnostics.iter().map(|one| {
        let line = loaded.source.line_column(one.span.start).0;
        format!("{} {line}", one.code.id())
    });
    assert_eq!(found.collect::<Vec<_>>(), expected, "{statements}");
}

// clauses: 6.5
#[test]
fn next_finds_its_for_past_what_is_not_closed() {
    let loops = "DEF_VAR I J\nFOR I = 1 TO 3\nFOR J = 1 TO 3\n";
    check(
        &format!("{loops}IF I == J THEN\nREM\nNEXT J\nNEXT I"),
        &["E207 6"],
    );
    check(
        &format!("{loops}IF I == J THEN\nREM\nNEXT\nNEXT"),
        &["E207 6"],
    );
    check(&format!("{loops}REM\nNEXT I"), &["E207 5"]);
    // Names exchanged, a NEXT for a WEND, and another mistake after it.
    check(&format!("{loops}REM\nNEXT I\nNEXT J"), &["E207 7"]);
    check(
        &format!("{loops}WHILE KB_HIT\nNEXT\nNEXT J\nNEXT I"),
        &["E207 7"],
    );
    check(&format!("{loops}REM\nNEXT I\nWEND"), &["E207 5", "E207 8"]);
    check(&format!("{loops}REM\nNEXT J\nNEXT I"), &[]);
}

// clauses: 6.5
#[test]
fn a_branch_without_its_if_takes_its_endif_along() {
    check("ELSEIF KB_HIT THEN\nREM\nELSE\nREM\nENDIF", &["E207 3"]);
    check("ELSE\nREM\nENDIF\nENDIF", &["E207 3", "E207 6"]);
    check("DO\nREM\nWHILE KB_HIT", &["E204 3"]);
    check("DO\nREM\nLOOP\nWHILE KB_HIT\nREM", &["E204 3", "E207 6"]);
    check("REPEAT\nREM\nWEND KB_HIT", &["E105 5"]);
}

// clauses: 3.1 6.1
#[test]
fn a_name_is_one_mistake() {
    check("GOTO UP:\nGOSUB UP:\nGOTO DOWN:", &["E202 3", "E202 5"]);
    check("CALL LOOP:\nEXIT\nSUBROUTINE LOOP:\nSUBEND", &["E205 5"]);
    check(
        "CALL A:\nEXIT\nSUBROUTINE B:\nSUBEND\nB:\nGOSUB LOOP:",
        &["E202 3", "E201 7", "E205 8"],
    );
    let twice = "DEF_VAR P\nDEF_POS P\nTEACH_POSITION F1 P\nPTP F1 P";
    check(twice, &["E205 4"]);
    check(&format!("{twice}\nPTP F9 0 0 0"), &["E205 4", "E205 7"]);
    check("DEF_VAR A$\nA$ = 1\nB$ = 1", &["E205 3", "E107 5"]);
    check(
        "DEF_VAR R\nR = 5\nSET_V_MAX ALL R\nPTP F1 R 0 0",
        &["E205 6"],
    );
}

// clauses: 5.1 6.1
#[test]
fn several_mistakes_of_a_statement_are_all_found() {
    let key = "DEF_VAR A\nKEY_IN A\n";
    check(
        &format!("{key}IF A = 1 GOTO L1\nL1:"),
        &["E205 5", "E205 5"],
    );
    check(
        &format!("{key}IF A != B THEN\nREM\nENDIF"),
        &["E205 5", "E206 5"],
    );
    check(&format!("{key}WHILE A => 1\nREM"), &["E207 5", "E205 5"]);
    check(&format!("{key}IF A = 1 THEN\nREM\nENDIF"), &["E205 5"]);
}

// clauses: 1.5
#[test]
fn a_misspelt_end_is_the_one_that_is_missing() {
    for word in ["EDN", "EN", "ENDE", "STOP"] {
        let text = format!("3.1\nA title\nREM\n{word}\n");
        let found = load("end.prg", text.as_bytes(), &Options::default()).diagnostics;
        assert_eq!(found.len(), 1, "{word}: {found:#?}");
    }
    let text = "3.1\nA title\nREM\nALL_STPO\n";
    let found = load("end.prg", text.as_bytes(), &Options::default()).diagnostics;
    assert_eq!(found.len(), 2, "{found:#?}");
}

/// Checks that programs with one mistake each have one diagnostic, of this code and on this line.
#[track_caller]
fn check_each(table: &[(&str, &str)]) {
    for (statements, expected) in table {
        check(statements, &[expected]);
    }
}

// clauses: 6.5 7.20
#[test]
fn an_unknown_word_may_be_the_end_or_the_start_of_a_block() {
    check_each(&[
        ("WHILE KB_HIT\nREM\nENDOFLOOP", "E204 5"),
        ("WHILE KB_HIT\nIF KB_HIT THEN\nREM\nENDIFF\nWEND", "E204 6"),
        ("WHILE(KB_HIT)\nREM\nWEND", "E204 3"),
        ("FOREACH N IN P\nSLEEP N\nNEXT", "E204 3"),
        ("UNLESS KB_HIT THEN\nREM\nELSE\nREM\nENDIF", "E204 3"),
        ("CALL S:\nEXIT\nSUB S:\nREM\nSUBEND", "E204 5"),
        ("DO\nREM\nWHILE KB_HIT", "E204 3"),
    ]);
    // A misspelt command is neither, and a word stands for one end only.
    check("WHILE KB_HIT\nSLEP 100", &["E207 3", "E204 4"]);
    check("WHILE KB_HIT\nREPEAT\nENDOFLOOP", &["E207 3", "E204 5"]);
    check("DO\nREM\nLOOP\nWHILE KB_HIT\nREM", &["E204 3", "E207 6"]);
}

// clauses: 3.1 4.1
#[test]
fn what_could_not_be_read_may_declare_its_names() {
    check_each(&[
        ("INT N\nN = 1\nSLEEP N", "E204 3"),
        ("DEFVAR N, M\nN = 1\nM = N\nSLEEP M", "E204 3"),
        ("DIM N(3)\nN(1) = 1", "E204 3"),
        ("LABEL L1\nREM\nGOTO L1:", "E204 3"),
        ("START\nREM\nGOTO START:", "E204 3"),
        ("DEF_VAR A N\nREAD A\nN = A\nSLEEP N", "E204 4"),
        ("DEF_POS Q\nTEACH_POSITION F1 P\nPTP F1 Q", "E206 4"),
    ]);
    // A misspelt command declares nothing.
    check("SLEP N\nSLEEP N", &["E204 3", "E206 4"]);
}

// clauses: 6.1 7.20
#[test]
fn beginners_read_of_each_mistake_once() {
    let numbers = "DEF_VAR N M\nKEY_IN N\nM = N\n";
    let table = [
        ("FOR N = 1TO 3\nSLEEP M\nNEXT", "E205 6"),
        ("FOR N = 1 TO3\nSLEEP M\nNEXT N", "E205 6"),
        ("FOR N = 1 TO 3\nSLEEP M\nNEXT M", "E207 8"),
        ("FOR N = 1 TO 3\nSLEEP M\nNEXT K", "E206 8"),
        ("N = 4,5\nSLEEP M", "E107 6"),
        ("PTP F1 100,5 200 300\nSLEEP M", "E205 6"),
        ("N = = 1\nSLEEP M", "E107 6"),
        ("IF M = 1 THEN\nREM\nENDIF", "E205 6"),
        ("IF M == 1 THEN SLEEP 10\nENDIF", "E205 6"),
        (
            "IF M == 1 THEN\nREM\nELSE IF M == 2 THEN\nREM\nENDIF",
            "E105 8",
        ),
        (
            "IF M == 1 THEN\nREM\nELIF M == 2 THEN\nREM\nENDIF",
            "E204 8",
        ),
        ("IF M == 1 THEN\nREM\nEND IF", "E207 8"),
        ("IF M == 1\nREM\nENDIF", "E205 6"),
        ("IF M EQ 1 THEN\nREM\nENDIF", "E205 6"),
        ("IF M == 1 THEN\nREM\nENDIF\nENDIF", "E207 9"),
        ("IF M == 1 {\nREM\n}", "E205 6"),
        ("WHILE TRUE:\nSLEEP M\nWEND", "E205 6"),
        ("SLEEP M; SLEPP 1; SLEEP M", "E204 6"),
        ("PRINT \"M=\"; M", "E204 6"),
        ("LOOP:\nSLEEP M\nGOTO LOPE:", "E202 8"),
        ("START:\nSLEEP M\nGOTO START", "E205 8"),
        ("10 SLEEP M\n20 SLEEP M", "E204 6"),
        ("PTP F1\n391 201 -150\nSLEEP M", "E205 6"),
    ];
    for (statements, expected) in table {
        check(&format!("{numbers}{statements}"), &[expected]);
    }
}
