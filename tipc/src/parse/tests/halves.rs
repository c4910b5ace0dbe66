//! A long program is read by two threads, and must come out as if one had read it.

use crate::parse::{Part, halves, parse, parse_part};
use crate::source::{Encoding, Source};

/// What is wrong, or not, in one of the halves.
const PIECES: &[&str] = &[
    "PTP F1 1 2 3",
    "END\nPTP F1 1 2 3",
    "END NEXT",
    "/* begins\nand goes on",
    "/* begins */",
    "*/",
    "10 PTP F1 P",
    "90 END",
    "IF KB_HIT {",
    "{",
    "}",
    "DEF_VAR A-B\nA-B = 1",
    "A-B = 1",
    "DEF_VAR C; D",
    "IF KB_HIT\nTHEN",
    "THEN",
    "PRINT \"N=\"; N",
    "MAIN LOOP:",
    "DEF_POS P ; P.X = 1",
];

fn source(text: &str) -> Source {
    let (source, bad) = Source::decode("long.prg", text.as_bytes(), Encoding::Utf8);
    assert_eq!(bad, None);
    source
}

#[track_caller]
fn check(text: &str) {
    let source = source(text);
    assert!(halves(&source).is_some());
    let whole = parse_part(&source, 3.1, Part::WHOLE, &mut |_| ());
    assert_eq!(parse(&source, 3.1), whole, "{text:.60}");
}

#[test]
fn halves_are_read_as_a_whole() {
    let clean = "DEF_VAR E ; E = 1\nL: SLEEP 20\n".repeat(600);
    for first in PIECES {
        for second in PIECES {
            check(&format!(
                "3.1\nlong\n{clean}{first}\n{clean}{second}\n{clean}END\n"
            ));
        }
        check(&format!("3.1\nlong\n{clean}{first}\n{clean}"));
    }
}

/// The line in the middle belongs to one half, whichever it is.
#[test]
fn a_piece_in_the_middle_is_read_once() {
    for piece in PIECES {
        for before in 999..1003 {
            let begin = "REM\n".repeat(before);
            let end = "REM\n".repeat(1001);
            check(&format!("3.1\nlong\n{begin}{piece}\n{end}END\n"));
        }
    }
}

#[test]
fn a_short_program_has_no_halves() {
    let text = "REM\n".repeat(1900);
    assert!(halves(&source(&format!("3.1\nshort\n{text}END\n"))).is_none());
}
