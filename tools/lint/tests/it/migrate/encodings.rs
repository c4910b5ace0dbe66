//! Bytes that no rule touches stay as they are, whatever they spell.

use super::result;
use tip_lint::migrate::migrate;
use tipc::source::Encoding;

fn bytes(old: &[u8], encoding: Encoding) -> Vec<u8> {
    let migration = migrate("old.prg", old, encoding).expect("this is text");
    let questions: Vec<_> = migration.questions().collect();
    assert!(questions.is_empty(), "{questions:#?}");
    migration.bytes().expect("decided").to_vec()
}

/// Shift_JIS: a title with half-width katakana and a second byte 0x5C (ソ, 表), a comment with characters that CP932
/// spells in two ways (`∪` as 0x879C and 0x81BE), one of the user's area, and a DOS end of file.
// clauses: 10.1 1.1
#[test]
fn shift_jis_is_never_encoded_again() {
    let title = b"\xB1\xB2 \x83\x5C\x95\x5C";
    let comment = b"// \x87\x9C \x81\xBE \xF0\x40 \xFA\x54";
    let join = |lines: &[&[u8]]| lines.join(&b"\r\n"[..]);
    let old = join(&[
        b"2.0",
        title,
        b"VAR1 = - 2 // \x83\x5C",
        comment,
        b"MESSAGE \x95\x5C%d01%\x83\x5C",
        b"END\r\n\x1A",
    ]);
    let new = join(&[
        b"3.1",
        title,
        b"DEF_VAR VAR1",
        b"VAR1 = -2 // \x83\x5C",
        comment,
        b"MESSAGE \x95\x5C%VAR1%\x83\x5C",
        b"END\r\n\x1A",
    ]);
    assert_eq!(bytes(&old, Encoding::Auto), new);
    assert_eq!(bytes(&old, Encoding::ShiftJis), new);
}

// clauses: 10.1 1.1
#[test]
fn utf_8_keeps_its_mark() {
    let old = "\u{FEFF}2.0\n歩く\nVAR1 = - 2 // 表\nEND\n";
    let new = "\u{FEFF}3.1\n歩く\nDEF_VAR VAR1\nVAR1 = -2 // 表\nEND\n";
    assert_eq!(result(old), new);
}

// clauses: 10.1 1.1
#[test]
fn lines_end_as_they_did() {
    for end in ["\n", "\r\n", "\r"] {
        let lines = |lines: &[&str]| lines.join(end);
        let old = lines(&["2.0", "t", "VAR1 = 1", "END"]);
        let new = lines(&["3.1", "t", "DEF_VAR VAR1", "VAR1 = 1", "END"]);
        assert_eq!(result(&old), new);
    }
}

// clauses: 10.1 1.6
#[test]
fn layout_is_kept() {
    let old =
        "2.0\nt\n\n\t\u{3000}var1\u{3000}=\t- var2 \t// x\n\n; ;\n  END  // e\nbehind VAR9 REM\n";
    let new = "3.1\nt\nDEF_VAR VAR1, VAR2\n\n\t\u{3000}var1\u{3000}=\t-var2 \t// x\n\n; ;\n  END  // e\nbehind VAR9 REM\n";
    assert_eq!(result(old), new);
}

// clauses: 10.1 1.1
#[test]
fn bytes_that_are_no_text_are_reported() {
    let loaded = migrate("old.prg", b"2.0\nt\n\x83\nEND\n", Encoding::Utf8).expect_err("no UTF-8");
    assert_eq!(loaded.diagnostics.len(), 1);
    assert_eq!(loaded.diagnostics[0].message(), "Format error");
}
