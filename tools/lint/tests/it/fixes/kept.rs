//! Bytes that no fix touches stay as they are, whatever they spell.

use super::{Certain, Likely, loaded, repaired};

fn fixed(bytes: &[u8]) -> Vec<u8> {
    repaired(bytes, Likely).loaded.source.bytes()
}

/// Shift_JIS as Windows writes it: half-width katakana, a second byte 0x5C (ソ, 表), characters that CP932 spells in two ways
/// (`∪` as 0x879C and 0x81BE), one of the user's area, and a DOS end of file.
// clauses: 1.1
#[test]
fn shift_jis_is_never_encoded_again() {
    let file = |lines: [&[u8]; 6]| lines.join(&b"\r\n"[..]);
    let text: &[u8] = b"MESSAGE \x95\x5C \xB1\xB2 // \x87\x9C \x81\xBE \xF0\x40 \xFA\x54";
    let old = file([
        b"3.1",
        b"\x83\x5C",
        text,
        b"# \x95\x5C",
        b"IF KB_HIT",
        b"END IF\r\nEND\r\n\x1A",
    ]);
    let new = file([
        b"3.1",
        b"\x83\x5C",
        text,
        b"// \x95\x5C",
        b"IF KB_HIT THEN",
        b"ENDIF\r\nEND\r\n\x1A",
    ]);
    assert_eq!(fixed(&old), new);
    // ＮＥＸＴ
    let old = b"3.1\n\x83\x5C\nDEF_VAR I\nFOR I = 1 TO 2\n\x82\x6D\x82\x64\x82\x77\x82\x73\nEND\n";
    let new = b"3.1\n\x83\x5C\nDEF_VAR I\nFOR I = 1 TO 2\nNEXT\nEND\n";
    assert_eq!(fixed(old), new);
}

// clauses: 1.1
#[test]
fn utf_8_keeps_its_mark() {
    let old = "\u{FEFF}3.1\n歩く\n  IF KB_HIT\t// 表\nENDIF\nEND\n\u{1A}";
    let new = "\u{FEFF}3.1\n歩く\n  IF KB_HIT THEN\t// 表\nENDIF\nEND\n\u{1A}";
    assert_eq!(fixed(old.as_bytes()), new.as_bytes());
}

// clauses: 1.1
#[test]
fn lines_end_as_they_did() {
    for end in ["\n", "\r\n", "\r"] {
        let lines = |lines: &[&str]| lines.join(end).into_bytes();
        let old = lines(&["3.1", "t", "DEF_VAR N = 1", "IF KB_HIT THEN SLEEP N", "END"]);
        let new = lines(&[
            "3.1",
            "t",
            "DEF_VAR N",
            "N = 1",
            "IF KB_HIT THEN",
            "  SLEEP N",
            "ENDIF",
            "END",
        ]);
        assert_eq!(fixed(&old), new);
    }
}

// clauses: 1.1
#[test]
fn what_cannot_be_decoded_stays_as_it_is() {
    for bytes in [
        &b"3.1\nt\nIF KB_HIT\n\x83\nENDIF\nEND\n"[..],
        b"3.1\nt\nIF KB_HIT\nENDIF\n\xFF\xFE\nEND\n",
        b"\xEF\xBB\xBF3.1\nt\nIF KB_HIT\n\x95\x5C\nENDIF\nEND\n",
    ] {
        let repaired = repaired(bytes, Likely);
        assert!(repaired.applied.is_empty(), "{bytes:?}");
        assert_eq!(repaired.loaded.source.bytes(), bytes);
        assert_eq!(repaired.loaded.diagnostics, loaded(bytes).diagnostics);
    }
}

#[test]
fn a_program_that_loads_is_changed_by_no_certain_fix() {
    let program = b"3.1\nt\nDEF_VAR UNUSED\nSLEEP -1\nEND\n";
    assert!(repaired(program, Certain).applied.is_empty());
}

#[test]
fn after_end_nothing_is_changed() {
    let text = b"3.1\nt\nGOTO L1\nL1: REM\nEND\nGOTO L1\nIF KB_HIT\n";
    assert_eq!(
        fixed(text),
        b"3.1\nt\nGOTO L1:\nL1: REM\nEND\nGOTO L1\nIF KB_HIT\n"
    );
}
