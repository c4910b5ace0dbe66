//! Display of MESSAGE, piece by piece (T.I.P. 3.1 §7-9-4).

use tipc::program::{Action, MessagePart, Operand, Scalar};
use tipc::{Options, load};

/// Returns the pieces of a text in a program with the VARs A (scalar 1), BIG (2) and the POS P.
fn parts(text: &str) -> Vec<MessagePart> {
    let program = format!(
        "3.1\nmessage\nDEF_VAR A BIG\nDEF_POS P\nA = 1\nBIG = A\nP.X = BIG\nMESSAGE {text}\nEND\n"
    );
    let loaded = load("message.prg", program.as_bytes(), &Options::default());
    let found = loaded.diagnostics;
    let program = loaded.program.unwrap_or_else(|| panic!("{found:#?}"));
    match &program.steps()[3].action {
        Action::Message { parts } => parts.clone(),
        other => panic!("{other:?}"),
    }
}

fn text(text: &str) -> MessagePart {
    MessagePart::Text(text.to_owned())
}

fn value(variable: usize, decimals: u8) -> MessagePart {
    let scalar = Scalar {
        variable,
        member: 0,
    };
    let operand = Operand::Scalar {
        scalar,
        negative: false,
    };
    MessagePart::Value { operand, decimals }
}

// clauses: 7.47
#[test]
fn an_empty_text_has_no_parts() {
    assert_eq!(parts(""), []);
    assert_eq!(parts(" \t "), []);
}

// clauses: 7.47
#[test]
fn values_stand_between_texts() {
    assert_eq!(parts("%A%"), [value(1, 0)]);
    assert_eq!(
        parts("a=%a% of %Big.3%!"),
        [
            text("a="),
            value(1, 0),
            text(" of "),
            value(2, 3),
            text("!")
        ]
    );
    assert_eq!(
        parts("%A%%BIG.0%%A.7%"),
        [value(1, 0), value(2, 0), value(1, 7)]
    );
}

// clauses: 7.47
#[test]
fn what_matches_nothing_is_text() {
    for plain in [
        "50%", "%A.8%", "%A.%", "%A.12%", "%C%", "%P%", "%P.X%", "%A .1%", "% A%", "%VR1%", "%%",
    ] {
        assert_eq!(parts(plain), [text(plain)]);
    }
    assert_eq!(parts("%VAR_KEY.1"), [text("%VAR_KEY.1")]);
}

// clauses: 7.47
#[test]
fn a_percent_that_begins_nothing_leaves_the_next_one_free() {
    assert_eq!(parts("100%%A%"), [text("100%"), value(1, 0)]);
    assert_eq!(parts("%X%A%"), [text("%X"), value(1, 0)]);
    assert_eq!(parts("%A.9%BIG%"), [text("%A.9"), value(2, 0)]);
}

// clauses: 7.47
#[test]
fn bell_and_tab_are_characters() {
    assert_eq!(parts(r"ding\a\tdong"), [text("ding\u{7}\tdong")]);
    assert_eq!(parts("\u{A5}a\u{A5}t."), [text("\u{7}\t.")]);
    assert_eq!(parts(r"\A\T\x\"), [text(r"\A\T\x\")]);
    assert_eq!(parts(r"\%A%"), [text(r"\"), value(1, 0)]);
}

// clauses: 7.47
#[test]
fn a_doubled_backslash_escapes_nothing() {
    assert_eq!(parts(r"C:\\a\\t\\n"), [text(r"C:\\a\\t\\n")]);
    assert_eq!(parts(r"\\\a"), [text("\\\\\u{7}")]);
}

// clauses: 1.6 7.47
#[test]
fn a_full_width_space_is_two() {
    assert_eq!(parts("左\u{3000}%A%"), [text("左  "), value(1, 0)]);
}
