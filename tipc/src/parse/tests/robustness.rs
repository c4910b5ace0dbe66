//! Robustness of the parser: it accepts any input, and every location that it reports exists and can be shown.

use crate::diagnostic::Diagnostic;
use crate::parse::parse;
use crate::render::{self, Style};
use crate::source::{Encoding, Source, Span};
use std::time::{Duration, Instant};
use tip_runtime::random::Random;

/// Pieces of programs, good and bad, that a random program is put together from.
const PIECES: &[&str] = &[
    "\n",
    "\r\n",
    "\r",
    ";",
    "//",
    " ",
    "\t",
    ",",
    "　",
    ":",
    "!",
    "-",
    "+",
    "=",
    "==",
    "<",
    "<>",
    ".",
    "5",
    "1E",
    "1E-3",
    "1E999",
    "A",
    "P.X",
    "L1:",
    "L1 :",
    "IF ",
    "THEN",
    "ELSEIF ",
    "ELSE",
    "ENDIF",
    "WHILE ",
    "WEND",
    "REPEAT",
    "UNTIL ",
    "FOR I=1 TO 3",
    " STEP ",
    "NEXT",
    "SUBROUTINE ",
    "SUBEND",
    "CALL ",
    "GOTO ",
    "GOSUB ",
    "RETURN",
    "EXIT",
    "END\n",
    "MESSAGE ",
    "\\n",
    "¥",
    "%A.3%",
    "REM ",
    "PTP F1 ",
    "HS",
    "DEF_VAR ",
    "SIN ",
    "ATAN2 ",
    "あ",
    "ｱ",
    "😀",
    "\u{7F}",
    "\0",
];

fn assert_in_range(source: &Source, span: Span, input: &[u8]) {
    let inside = source.text().get(span.start..span.end).is_some();
    assert!(inside, "{span:?} is no place of {input:?}");
}

fn try_on(bytes: &[u8]) {
    for encoding in [Encoding::Auto, Encoding::Utf8, Encoding::ShiftJis] {
        let (source, bad) = Source::decode("random.prg", bytes, encoding);
        let bad = bad.map(Diagnostic::from);
        if let Some(bad) = &bad {
            assert_in_range(&source, bad.span, bytes);
        }
        let (module, diagnostics) = parse(&source, Some(3.1));
        for diagnostic in diagnostics.iter() {
            assert_in_range(&source, diagnostic.span, bytes);
            for label in &diagnostic.labels {
                assert_in_range(&source, label.span, bytes);
            }
        }
        for diagnostic in diagnostics.iter().chain(&bad).take(3) {
            assert!(!render::human(&source, diagnostic, Style::default()).is_empty());
        }
        for statement in &module.statements {
            assert_in_range(&source, statement.span, bytes);
        }
    }
}

// clauses: 1.1
#[test]
fn random_bytes_do_no_harm() {
    let mut random = Random::new(1);
    for _ in 0..2000 {
        let length = random.index(80);
        let mut bytes = b"3.1\nt\n".to_vec();
        bytes.extend((0..length).map(|_| random.index(256) as u8));
        try_on(&bytes);
        try_on(&bytes[random.index(7)..]);
    }
}

// clauses: 1.10
#[test]
fn random_programs_do_no_harm() {
    let mut random = Random::new(2);
    for _ in 0..3000 {
        let mut text = String::from("3.1\nt\n");
        for _ in 0..random.index(40) {
            text += PIECES[random.index(PIECES.len())];
        }
        try_on(text.as_bytes());
        let mut bytes = text.into_bytes();
        let at = random.index(bytes.len());
        bytes[at] = random.index(256) as u8;
        try_on(&bytes);
    }
}

/// Measures how long the front end takes for `unit` repeated to `length` bytes.
fn time(unit: &str, length: usize) -> Duration {
    let text = format!("3.1\nt\n{}", unit.repeat(length / unit.len()));
    let start = Instant::now();
    let (source, _) = Source::decode("long.prg", text.as_bytes(), Encoding::Auto);
    let (_, diagnostics) = parse(&source, Some(3.1));
    for diagnostic in diagnostics.iter() {
        source.line_column(diagnostic.span.start);
    }
    start.elapsed()
}

// clauses: 1.2
#[test]
fn time_grows_with_the_length_whatever_stands_there() {
    // A quadratic pass takes far longer for these; the bound leaves room for a busy machine.
    let units = [
        "A=1;",
        "L1:",
        "ELSE X;",
        ":",
        "あ",
        "A = ",
        "-",
        "MESSAGE あ//",
        "MESSAGE \\n;",
        "1E-",
        "P.",
        "\r",
        "IF ",
        " ",
        "　",
        "DEF_VAR A あ;",
        "ELSE;",
    ];
    for unit in units {
        let taken = time(unit, 1 << 18);
        assert!(taken < Duration::from_secs(20), "{unit:?} took {taken:?}");
    }
}
