//! Lines 1 and 2.

use crate::parse::parse;
use crate::source::{Encoding, Source};

/// Checks whether a compiler of version `wanted` reads a program whose first line is `line`; if not, nothing else is
/// reported.
#[track_caller]
fn check(line: &str, wanted: f64, expected: bool) {
    let text = format!("{line}\n　two　words ;\t\nFOO");
    let (source, _) = Source::decode("test.prg", text.as_bytes(), Encoding::Utf8);
    let (module, diagnostics) = parse(&source, Some(wanted));
    let messages: Vec<String> = diagnostics.iter().map(|one| one.message()).collect();
    if expected {
        assert_eq!(module.title, "two  words ;");
        assert_eq!(messages, ["Not exist END"]);
    } else {
        assert_eq!(module.statements.len(), 0);
        assert_eq!(messages, ["Wrong version number"]);
    }
}

// clauses: 1.3 1.4 1.6
#[test]
fn versions_are_compared_as_numbers() {
    check("3.1", 3.1, true);
    check("3.10", 3.1, true);
    check("　3.1 \t// comment", 3.1, true);
    check("3.1//", 3.1, true);
    check("2", 2.0, true);
    check("3.1", 3.0, false);
    check("3.01", 3.1, false);
    check("3.1 beta", 3.1, false);
    check("3.1;", 3.1, false);
    check("3.1 3.1", 3.1, false);
    check("", 3.1, false);
    check("// 3.1", 3.1, false);
    check("inf", f64::INFINITY, false);
    check("３.１", 3.1, false);
}
