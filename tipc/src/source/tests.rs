use super::{Encoding, Source, first_beyond};
use crate::diagnostic::Diagnostic;
use encoding_rs::SHIFT_JIS;
use std::collections::BTreeMap;

/// Decodes `bytes` and compares the text; the decoding must succeed.
#[track_caller]
fn check(bytes: &[u8], encoding: Encoding, expected: &str) {
    let (source, bad) = Source::decode("a.prg", bytes, encoding);
    assert_eq!(bad, None);
    assert_eq!(source.text(), expected);
}

/// Decodes `bytes`, which must fail at `byte` of the file, shown at `line` and `column`.
#[track_caller]
fn check_bad(bytes: &[u8], encoding: Encoding, byte: usize, location: (u32, u32)) {
    let (source, bad) = Source::decode("a.prg", bytes, encoding);
    let bad = Diagnostic::from(bad.expect("a decoding error"));
    assert_eq!(bad.title(), "TIP_ERR:Format error (PreprocessError)");
    assert!(
        bad.reason.to_string().contains(&format!("byte {byte} ")),
        "{}",
        bad.reason
    );
    assert_eq!(source.line_column(bad.span.start), location);
    assert!(source.text().is_char_boundary(bad.span.end));
}

// clauses: 1.1
#[test]
fn utf8_is_read_with_and_without_mark() {
    check("3.1\nあ".as_bytes(), Encoding::Auto, "3.1\nあ");
    check("\u{FEFF}3.1".as_bytes(), Encoding::Auto, "3.1");
    check("\u{FEFF}3.1".as_bytes(), Encoding::Utf8, "3.1");
}

// clauses: 1.1
#[test]
fn shift_jis_is_read_when_utf8_fails_or_when_forced() {
    // 82 A0 is HIRAGANA A, B1 is half-width KATAKANA A, 5C the backslash, F0 40 the first private character.
    check(b"\x82\xA0\xB1\x5C", Encoding::Auto, "あｱ\\");
    check(b"\xF0\x40", Encoding::ShiftJis, "\u{E000}");
    // The same two bytes are one character of UTF-8 (U+00B1) and two of Shift_JIS.
    check(b"\xC2\xB1", Encoding::Auto, "±");
    check(b"\xC2\xB1", Encoding::ShiftJis, "ﾂｱ");
}

// clauses: 1.1
#[test]
fn bytes_that_are_no_text_are_named() {
    check_bad(b"3.1\nab\xFF", Encoding::Utf8, 6, (2, 3));
    check_bad(b"\xEF\xBB\xBF3.1\n\xFF", Encoding::Auto, 7, (2, 1));
    check_bad(b"3.1\n\x82\xA0\xFFA", Encoding::ShiftJis, 6, (2, 2));
    check_bad(b"3.1\n\x82\xA0\xFFA", Encoding::Auto, 6, (2, 2));
    check_bad(b"a\x82", Encoding::ShiftJis, 1, (1, 2));
    check_bad(b"\x82\x20\x82\xA0", Encoding::ShiftJis, 0, (1, 1));
    // HIRAGANA A as UTF-8 (E3 81 82), LF, FF. As Shift_JIS the third byte needs a second one and LF is not valid there: UTF-8 reads
    // further, so its byte is the one that is named.
    check_bad(b"\xE3\x81\x82\n\xFF", Encoding::Auto, 4, (2, 1));
}

// clauses: 1.1
#[test]
fn one_dos_end_of_file_is_dropped() {
    check(b"END\x1A", Encoding::Auto, "END");
    check(b"END\x1A\x1A", Encoding::Auto, "END\x1A");
    check(b"END\x1A\n", Encoding::Auto, "END\x1A\n");
}

// clauses: 1.1
#[test]
fn every_line_end_ends_a_line() {
    let (source, _) = Source::decode("a.prg", b"a\nb\r\nc\rd\n\re", Encoding::Auto);
    let lines: Vec<&str> = (1..=source.line_count())
        .map(|line| source.line_text(line))
        .collect();
    assert_eq!(lines, ["a", "b", "c", "d", "", "e"]);
    let (source, _) = Source::decode("a.prg", b"a\r\n", Encoding::Auto);
    assert_eq!(source.line_count(), 1);
    let (source, _) = Source::decode("a.prg", b"", Encoding::Auto);
    assert_eq!(
        (
            source.line_count(),
            source.line_text(1),
            source.line_text(7)
        ),
        (1, "", "")
    );
}

#[test]
fn columns_count_characters() {
    let (source, _) = Source::decode("a.prg", "x\n\tあいう".as_bytes(), Encoding::Auto);
    assert_eq!(source.line_column(0), (1, 1));
    assert_eq!(source.line_column(2), (2, 1));
    assert_eq!(source.line_column(6), (2, 3));
    assert_eq!(source.line_column(12), (2, 5));
    assert_eq!(source.line_column(99), (2, 5));
}

#[test]
fn columns_count_characters_far_into_a_line() {
    let text = format!("ab\n{}", "aあ".repeat(5000));
    let (source, _) = Source::decode("a.prg", text.as_bytes(), Encoding::Auto);
    for index in [0, 1, 255, 256, 257, 1023, 1024, 4999] {
        assert_eq!(source.line_column(3 + 4 * index), (2, 2 * index as u32 + 1));
    }
    assert_eq!(source.line_column(text.len()), (2, 10_001));
}

#[test]
fn the_hash_is_fnv1a_of_the_bytes() {
    // Values of the hash's published test vectors.
    for (bytes, hash) in [
        (&b""[..], 0xCBF2_9CE4_8422_2325),
        (b"a", 0xAF63_DC4C_8601_EC8C),
        (b"foobar", 0x8594_4171_F739_67E8),
    ] {
        let (source, _) = Source::decode("a.prg", bytes, Encoding::Auto);
        assert_eq!(source.hash(), hash);
    }
}

/// Returns the number of bytes of each character of code page 932.
fn code_page() -> BTreeMap<char, usize> {
    let singles = (0..=0xFF_u8).map(|byte| vec![byte]);
    let pairs =
        (0x81..=0xFC_u8).flat_map(|lead| (0x40..=0xFC_u8).map(move |trail| vec![lead, trail]));
    let mut page = BTreeMap::new();
    for bytes in singles.chain(pairs) {
        let (text, bad) = SHIFT_JIS.decode_without_bom_handling(&bytes);
        let mut chars = text.chars();
        if let (false, Some(char), None) = (bad, chars.next(), chars.next()) {
            page.entry(char).or_insert(bytes.len());
        }
    }
    page
}

// clauses: 1.2
#[test]
fn byte_lengths_are_those_of_code_page_932() {
    let page = code_page();
    assert!(page.len() > 9000, "{} characters", page.len());
    for char in '\0'..=char::MAX {
        let expected = match page.get(&char) {
            Some(length) => *length,
            None if char == '¥' => 1,
            None => char.len_utf8(),
        };
        let text = char.to_string().repeat(2);
        // Two of them fit into twice their length and not into one byte less.
        assert_eq!(first_beyond(&text, 2 * expected), None, "{char:?}");
        assert_eq!(
            first_beyond(&text, 2 * expected - 1),
            Some(char.len_utf8()),
            "{char:?}"
        );
    }
}
