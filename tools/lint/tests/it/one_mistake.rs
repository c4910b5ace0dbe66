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
    check("REPEAT\nREM\nWEND KB_HIT", &["E207 5"]);
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
