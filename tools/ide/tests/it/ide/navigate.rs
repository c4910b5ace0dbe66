//! Declarations, references, outline.

use super::cursor;
use tip_ide::{Outline, OutlineKind, ReferenceKind};
use tipc::syntax::VariableKind;

/// Returns the declaration: line and text.
#[track_caller]
fn check(statements: &str, expected: Option<(u32, &str)>) {
    let (document, at) = cursor(statements);
    let found = document.definition(at).map(|span| {
        let source = document.source();
        (source.line_column(span.start).0, source.slice(span))
    });
    assert_eq!(found, expected, "{statements}");
}

#[test]
fn names_lead_to_their_declarations() {
    check(
        "DEF_VAR Stride\nstride = 1\nSLEEP $0STRIDE\nEND\n",
        Some((3, "Stride")),
    );
    check("DEF_POS P\nP.$0X = 1\nEND\n", Some((3, "P")));
    check("GOSUB $0L1:\nEXIT\nL1:\nRETURN\nEND\n", Some((5, "L1")));
    check("DEF_VAR A\nA = 1\nMESSAGE %$0A%\nEND\n", Some((3, "A")));
    check("SLEEP $010\nEND\n", None);
    check("KEY_IN\nSLEEP $0VAR_KEY\nEND\n", None);
}

#[test]
fn what_a_statement_leaves_out_is_found_too() {
    check("LOOP:\nREM\nLOOP:\nREM\nGO$0TO\nEND\n", Some((5, "LOOP")));
    check("DEF_VAR N\nFOR N = 1 TO 3\nNEX$0T\nEND\n", Some((3, "N")));
}

#[test]
fn references_say_what_is_done() {
    let (document, at) =
        cursor("DEF_VAR A, B\nB = 1\n$0A = B\nA += 1\nSLEEP A\nMESSAGE %A%\nEND\n");
    let kinds: Vec<ReferenceKind> = document
        .references(at, true)
        .iter()
        .map(|mention| mention.kind)
        .collect();
    assert_eq!(
        kinds,
        [
            ReferenceKind::Declares,
            ReferenceKind::Assigns,
            ReferenceKind::Assigns,
            ReferenceKind::Uses,
            ReferenceKind::Uses,
        ]
    );
    let places = document.references(at, false);
    assert_eq!(places.len(), 4);
    assert!(
        places
            .iter()
            .all(|it| document.source().slice(it.span) == "A")
    );
}

#[test]
fn the_outline_nests_labels_in_their_subroutine() {
    let (document, _) = cursor(
        "DEF_VAR A, B\nDEF_POS P\nL1:\nREM\nREM\nL2:\nEXIT\nSUBROUTINE LIFT:\nUP:\nREM\nSUBEND\nEND\n$0",
    );
    let outline = document.outline();
    let names = |of: &[Outline]| -> Vec<(String, OutlineKind)> {
        of.iter().map(|it| (it.name.clone(), it.kind)).collect()
    };
    let named = |name: &str, kind| (name.to_owned(), kind);
    assert_eq!(
        names(&outline),
        [
            named("A", OutlineKind::Variable(VariableKind::Var)),
            named("B", OutlineKind::Variable(VariableKind::Var)),
            named("P", OutlineKind::Variable(VariableKind::Pos)),
            named("L1", OutlineKind::Label),
            named("L2", OutlineKind::Label),
            named("LIFT", OutlineKind::Subroutine),
        ]
    );
    assert_eq!(
        names(&outline[5].children),
        [named("UP", OutlineKind::Label)]
    );
    let text = |one: &Outline| document.source().slice(one.span).to_owned();
    assert_eq!(text(&outline[3]), "L1:\nREM\nREM");
    assert_eq!(text(&outline[4]), "L2:\nEXIT");
    assert_eq!(text(&outline[5]), "LIFT:\nUP:\nREM\nSUBEND");
    assert_eq!(text(&outline[5].children[0]), "UP:\nREM");
}
