//! Warnings of what is read otherwise than it was meant: titles, encodings, values in messages.

use tip_lint::{Options, load};
use tipc::source::{Encoding, Unit};

/// Returns the diagnostics of a file, each as code, line and column.
fn found(bytes: &[u8], options: &Options) -> Vec<String> {
    let loaded = load("misread.prg", bytes, options);
    let place = |start| loaded.source.position(start, Unit::Character);
    let diagnostic = |one: &tipc::diagnostic::Diagnostic| {
        let at = place(one.span.start);
        format!("{} {}:{}", one.code.id(), at.line, at.column)
    };
    loaded.diagnostics.iter().map(diagnostic).collect()
}

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    assert_eq!(
        found(text.as_bytes(), &Options::default()),
        expected,
        "{text}"
    );
}

// clauses: 1.4
#[test]
fn a_title_that_would_be_a_statement_was_forgotten() {
    for line in [
        "PTP F1 R 0 R 0 R 50",
        "INITIAL_POSTURE",
        "wait_inpos all // here",
        "VAR_KEY = 5",
    ] {
        check(&format!("3.1\n{line}\nALL_STOP\nEND\n"), &["W128 2:1"]);
    }
    // Titles, also such as begin with a word of the language, or would be wrong as statements.
    for line in [
        "",
        "Walk",
        "Exit",
        "Stop: a test",
        "REM a walk",
        "End of the walk",
        "Message of the day",
        "Sleep and walk",
        "force control of the hand",
        "N = 5",
        "GOTO the wall",
        "歩行",
    ] {
        check(&format!("3.1\n{line}\nALL_STOP\nEND\n"), &[]);
    }
    check("3.1\nSLEEP 100\nSLEP 100\nEND\n", &["E204 3:1"]);
    check("3.1 // tip: allow(W128)\nALL_STOP\nALL_STOP\nEND\n", &[]);
}

// clauses: 1.1
#[test]
fn files_in_other_encodings_that_can_be_read_are_noticed() {
    let options = Options::default();
    let euc = b"3.1\nA title\nMESSAGE \xA4\xA2\xA4\xA4\nEND\n";
    assert_eq!(found(euc, &options), ["W129 3:9"]);
    let jis = b"3.1\nA title\nMESSAGE \x1B$B$\"\x1B(B\nEND\n";
    assert_eq!(found(jis, &options), ["W129 3:9"]);
    // The same two kana in Shift_JIS and UTF-8, and half-width katakana.
    for text in [
        &b"3.1\nA title\nMESSAGE \x82\xA0\x82\xA2\nEND\n"[..],
        b"3.1\nA title\nMESSAGE \xE3\x81\x82\xE3\x81\x84\nEND\n",
        b"3.1\nA title\nMESSAGE \xB1\nEND\n",
    ] {
        assert_eq!(found(text, &options), [""; 0]);
    }
    let forced = Options {
        encoding: Encoding::ShiftJis,
        ..options
    };
    assert_eq!(found(euc, &forced), [""; 0]);
}

// clauses: 7.47
#[test]
fn values_in_full_width_signs_or_by_their_bare_name_are_not_shown() {
    let shown = |text: &str| {
        let program = format!("3.1\nA title\nDEF_VAR N\nKEY_IN N\nMESSAGE {text}\nEND\n");
        found(program.as_bytes(), &Options::default())
    };
    for text in ["n=％N％", "n=%N％", "n=％Ｎ.2％"] {
        assert_eq!(shown(text), ["W124 5:11"], "{text}");
    }
    assert_eq!(shown("n"), ["W124 5:9"]);
    assert_eq!(shown("”%N%”"), ["W111 5:9"]);
    // What a text does not show is still read without a value, or used by nothing.
    let unassigned = "3.1\nA title\nDEF_VAR B\nSLEEP B\nMESSAGE %B\nEND\n";
    check(unassigned, &["E301 4:7"]);
    check(
        "3.1\nA title\nDEF_VAR B\nMESSAGE %A% %B\nSLEP 1\nEND\n",
        &["W101 3:9", "E204 5:1"],
    );
    // Percentages, and a text that is the name of a variable with another use.
    for text in ["%N%％", "50％から60％まで %N%", "「%N%」"] {
        assert_eq!(shown(text), [""; 0], "{text}");
    }
    check(
        "3.1\nA title\nDEF_VAR N\nKEY_IN N\nMESSAGE n\nSET_V_MAX ALL N\nEND\n",
        &[],
    );
}
