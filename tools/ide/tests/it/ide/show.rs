//! Hints, folding, classes of words.

use super::cursor;
use tip_ide::{Document, FoldKind, TokenClass};
use tipc::Options;
use tipc::source::Span;

fn hints(statements: &str) -> Vec<(u32, String)> {
    let (document, _) = cursor(statements);
    let all = Span::new(0, document.source().text().len());
    let hints = document.inlay_hints(all).into_iter();
    let line = |at| document.source().line_column(at).0;
    hints
        .map(|hint| (line(hint.at), hint.text.to_string()))
        .collect()
}

#[test]
fn loops_show_their_turns() {
    let found = hints("DEF_VAR N\nFOR N = 1 TO 3\nREM\nNEXT\nWHILE KB_HIT\nWEND\nEND\n$0");
    let expected = [
        (4, "3 turns, each turn: 2 cycles, 40 ms".to_owned()),
        (7, "each turn: 2 cycles, 40 ms".to_owned()),
    ];
    assert_eq!(found, expected);
}

#[test]
fn a_loop_that_waits_says_so() {
    let found = hints("WHILE !KB_HIT\nWAIT_INPOS ALL\nWEND\nEND\n$0");
    assert_eq!(
        found,
        [(3, "each turn: 3 cycles, 60 ms, plus waits".to_owned())]
    );
}

#[test]
fn steps_that_never_run_are_marked() {
    let found = hints("EXIT\nSLEEP 40\nEND\n$0");
    assert_eq!(found, [(4, "never runs".to_owned())]);
}

#[test]
fn a_stretch_has_its_own_hints() {
    let (document, at) = cursor("WHILE KB_HIT\nWEND\n$0WHILE KB_HIT\nWEND\nEND\n");
    let end = document.source().text().len();
    assert_eq!(document.inlay_hints(Span::new(at, end)).len(), 1);
    assert_eq!(document.inlay_hints(Span::new(0, end)).len(), 2);
}

#[test]
fn blocks_and_comments_fold() {
    let (document, _) = cursor(
        "// one\n// two\nIF KB_HIT THEN\nREM\nELSEIF HALT_REQUEST THEN\nREM\nELSE\nREM\nENDIF\n\
         SUBROUTINE S:\nREPEAT\nREM\nUNTIL KB_HIT\nSUBEND\nREM // alone\nEND\n$0",
    );
    let folds = document.folds().into_iter();
    let folds: Vec<(u32, u32, bool)> = folds
        .map(|fold| (fold.first, fold.last, fold.kind == FoldKind::Comment))
        .collect();
    let expected = [
        (3, 4, true),
        (5, 6, false),
        (7, 8, false),
        (9, 11, false),
        (12, 16, false),
        (13, 15, false),
    ];
    assert_eq!(folds, expected);
}

#[test]
fn a_block_that_is_open_folds_nothing() {
    let (document, _) = cursor("IF KB_HIT THEN\nWHILE KB_HIT\nREM\nENDIF\nUNTIL KB_HIT\nEND\n$0");
    let folds: Vec<(u32, u32)> = document
        .folds()
        .iter()
        .map(|it| (it.first, it.last))
        .collect();
    assert_eq!(folds, [(3, 6)]);
}

/// The words of a line with their classes; `+` declares, `=` assigns.
#[track_caller]
fn check(statements: &str, expected: &[(&str, TokenClass, &str)]) {
    check_at(cursor(statements), expected);
}

#[track_caller]
fn check_at((document, at): (Document, usize), expected: &[(&str, TokenClass, &str)]) {
    let line = document.source().line_column(at).0;
    let span = document.source().line(line).span;
    let tokens = document.semantic_tokens(span).into_iter();
    let found: Vec<(&str, TokenClass, &str)> = tokens
        .map(|it| {
            let marks = match (it.declares, it.assigns) {
                (true, _) => "+",
                (_, true) => "=",
                _ => "",
            };
            (document.source().slice(it.span), it.class, marks)
        })
        .collect();
    assert_eq!(found, expected, "{}", document.source().text());
}

#[test]
fn words_have_their_classes() {
    check(
        "DEF_VAR S\n$0PTP HS F1 R S -S 20 // up\nEND\n",
        &[
            ("PTP", TokenClass::Command, ""),
            ("HS", TokenClass::Modifier, ""),
            ("F1", TokenClass::Constant, ""),
            ("R", TokenClass::Modifier, ""),
            ("S", TokenClass::Variable, ""),
            ("-", TokenClass::Operator, ""),
            ("S", TokenClass::Variable, ""),
            ("20", TokenClass::Number, ""),
            ("// up", TokenClass::Comment, ""),
        ],
    );
    check(
        "$0DEF_POS P\nP.X = 1\nEND\n",
        &[
            ("DEF_POS", TokenClass::Keyword, ""),
            ("P", TokenClass::Variable, "+"),
        ],
    );
    check(
        "DEF_POS P\n$0P.X = SQRT CHAR_A\nEND\n",
        &[
            ("P", TokenClass::Variable, "="),
            ("X", TokenClass::Member, ""),
            ("=", TokenClass::Operator, ""),
            ("SQRT", TokenClass::Function, ""),
            ("CHAR_A", TokenClass::Constant, ""),
        ],
    );
    check(
        "L1:\n$0IF !KB_HIT GOTO L1:; MESSAGE 歩 %A% 数\nDEF_VAR A\nEND\n",
        &[
            ("IF", TokenClass::Keyword, ""),
            ("!", TokenClass::Operator, ""),
            ("KB_HIT", TokenClass::Flag, ""),
            ("GOTO", TokenClass::Keyword, ""),
            ("L1", TokenClass::Label, ""),
            ("MESSAGE", TokenClass::Keyword, ""),
            ("歩 %", TokenClass::Text, ""),
            ("A", TokenClass::Variable, ""),
            ("% 数", TokenClass::Text, ""),
        ],
    );
    // A special variable of edition 3.2.
    let text = "3.2\nTitle\nMESSAGE at %@POS_F1.0% mm\nEND\n";
    let document = Document::new("test.prg", text, &Options::default());
    check_at(
        (document, text.find("MESSAGE").expect("it is there")),
        &[
            ("MESSAGE", TokenClass::Keyword, ""),
            ("at %", TokenClass::Text, ""),
            ("@POS_F1", TokenClass::Variable, ""),
            (".0% mm", TokenClass::Text, ""),
        ],
    );
    check("$0END REM\nREM\n", &[("END", TokenClass::Keyword, "")]);
    check("END\n$0REM\n", &[]);
}
