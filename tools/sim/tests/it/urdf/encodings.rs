//! Files in other encodings than UTF-8, and with something before their declarations.

use crate::urdf::robots::{PLAIN, TIP, fixed, revolute, urdf};
use tip_sim::import::{decode, import};

/// A robot whose joint has a name of Japanese, and whose declaration says more.
fn text(declared: &str) -> String {
    let text = urdf(&[
        revolute("a", "base", "one", PLAIN),
        fixed("one", "foot", TIP),
    ]);
    let text = text.replace(
        "<?xml version=\"1.0\"?>",
        &format!("<?xml version=\"1.0\"{declared}?>"),
    );
    text.replace("name=\"a\"", "name=\"\u{8db3}\"")
}

/// Asserts that the joint has its name.
#[track_caller]
fn reads(bytes: &[u8]) {
    let text = decode(bytes).unwrap_or_else(|error| panic!("{error}"));
    let import = import("test.urdf", &text).unwrap_or_else(|error| panic!("{error}"));
    assert!(import.toml.contains("# \u{8db3}"), "{}", import.toml);
}

fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    text.encode_utf16().flat_map(bytes).collect()
}

/// Returns the text with the name in another encoding of one byte for each ASCII letter.
fn in_place(text: &str, name: &[u8]) -> Vec<u8> {
    let (before, after) = text.split_once('\u{8db3}').expect("the name");
    [before.as_bytes(), name, after.as_bytes()].concat()
}

#[test]
fn utf_8_and_16_are_known_by_their_marks() {
    for declared in [
        "",
        " encoding=\"utf-8\"",
        " encoding=\"UTF-16\"",
        " encoding='Shift_JIS'",
    ] {
        let text = text(declared);
        let marked = format!("\u{feff}{text}");
        reads(marked.as_bytes());
        reads(&utf16(&marked, u16::to_le_bytes));
        reads(&utf16(&marked, u16::to_be_bytes));
        // Letters of ASCII with zeros beside them are UTF-16 as well.
        reads(&utf16(&text, u16::to_le_bytes));
        reads(&utf16(&text, u16::to_be_bytes));
    }
    reads(text("").as_bytes());
    reads(text(" encoding=\"UTF-16\"").as_bytes());
}

#[test]
fn a_declaration_names_the_encoding() {
    // U+8DB3 in Shift_JIS and EUC-JP.
    for name in ["Shift_JIS", "SHIFT_JIS", "shift-jis", "sjis", "Windows-31J"] {
        let text = text(&format!(" encoding=\"{name}\""));
        reads(&in_place(&text, b"\x91\xAB"));
        reads(&in_place(&format!("\r\n \n{text}"), b"\x91\xAB"));
    }
    reads(&in_place(
        &text(" encoding = 'euc-jp' standalone='yes'"),
        b"\xC2\xAD",
    ));
    for latin in ["ISO-8859-1", "iso-8859-1", "latin1", "Windows-1252"] {
        let text = text(&format!(" encoding='{latin}'"));
        let decoded = decode(&in_place(&text, b"\xE9")).expect("it is Latin-1");
        assert!(decoded.contains("name=\"\u{e9}\""), "{decoded}");
    }
}

#[test]
fn what_cannot_be_decoded_is_refused_with_the_name_of_the_encoding() {
    let refused = |bytes: &[u8]| decode(bytes).expect_err("it is refused").to_string();
    for name in ["EBCDIC-CP-FR", "utf-7", "x", ""] {
        let said = refused(text(&format!(" encoding=\"{name}\"")).as_bytes());
        let wanted = format!(
            "the file says that its encoding is `{name}`, which cannot be read: save it as UTF-8"
        );
        assert_eq!(said, wanted);
    }
    let wide: Vec<u8> = text("")
        .chars()
        .flat_map(|c| u32::from(c).to_le_bytes())
        .collect();
    assert!(refused(&wide).contains("`UTF-32`"));
    assert!(refused(&[b"\xFF\xFE\0\0", &*wide].concat()).contains("`UTF-32`"));
    // The name is on the fifth line, after `<joint name="`.
    let broken = refused(&in_place(&text(""), b"\x91\xAB"));
    assert!(
        broken.starts_with("line 5, column 14: these bytes are not UTF-8"),
        "{broken}"
    );
    let broken = refused(&in_place(&text(" encoding=\"Shift_JIS\""), b"\x91\xFF"));
    assert!(
        broken.starts_with("line 5, column 14: these bytes are not Shift_JIS"),
        "{broken}"
    );
}

#[test]
fn blank_lines_before_the_declaration_do_not_matter() {
    let sound = import("test.urdf", &text("")).expect("it is sound");
    for before in ["\n", "\r\n\t \n", "\u{feff}", "\u{feff}\n\n"] {
        let late = format!("{before}{}", text(" encoding=\"utf-8\""));
        assert_eq!(
            import("test.urdf", &late).as_ref(),
            Ok(&sound),
            "{before:?}"
        );
    }
    // Places are those of the file.
    let broken = format!("\n\n{}", text("").replace("</robot>", "</rabot>"));
    let error = import("test.urdf", &broken).expect_err("it is refused");
    assert!(error.to_string().ends_with("at 12:1"), "{error}");
}
