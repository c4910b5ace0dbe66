//! Bytes to text (T.I.P. 3.1 §3), and a text that was changed in an editor back to bytes.

use super::lines::{Line, Lines};
use super::{Source, Span};
use encoding_rs::{DecoderResult, SHIFT_JIS};
use std::collections::HashMap;

/// Choice of how to read the bytes of a source file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8 if the bytes are valid UTF-8, else Shift_JIS.
    #[default]
    Auto,
    /// UTF-8, with or without byte order mark.
    Utf8,
    /// Shift_JIS as Windows knows it (code page 932).
    ShiftJis,
}

/// Character set of a source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Charset {
    /// UTF-8.
    Utf8,
    /// Shift_JIS as Windows knows it (code page 932).
    ShiftJis,
}

impl Charset {
    /// Returns its name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Charset::Utf8 => "UTF-8",
            Charset::ShiftJis => "Shift_JIS",
        }
    }
}

/// The first bytes of a file that are not text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Undecodable {
    /// Character set that was read.
    pub charset: Charset,
    /// Offset in the file, from 0.
    pub byte: usize,
    /// The replacement character in the text instead.
    pub span: Span,
    /// If either charset was allowed: the other one, and the first byte that it lacks.
    pub other: Option<(Charset, usize)>,
}

/// The byte order mark of UTF-8.
pub(super) const MARK: &[u8] = b"\xEF\xBB\xBF";

/// The text of a file, and how it was read.
pub(super) struct Decoded {
    pub(super) text: String,
    pub(super) charset: Charset,
    /// A byte order mark precedes the text and is not part of it.
    pub(super) marked: bool,
    pub(super) bad: Option<Undecodable>,
}

/// Reads bytes; what cannot be read becomes replacement characters.
pub(super) fn decode(bytes: &[u8], encoding: Encoding) -> Decoded {
    match encoding {
        Encoding::Utf8 => decode_utf8(bytes),
        Encoding::ShiftJis => decode_shift_jis(bytes),
        Encoding::Auto => decode_auto(bytes),
    }
}

fn decode_auto(bytes: &[u8]) -> Decoded {
    let Err(first) = std::str::from_utf8(bytes) else {
        return decode_utf8(bytes);
    };
    if bytes.starts_with(MARK) {
        return decode_utf8(bytes);
    }
    let first = first.valid_up_to();
    let mut decoded = decode_shift_jis(bytes);
    let Some(second) = &mut decoded.bad else {
        return decoded;
    };
    // The charset that reads further is the likelier one.
    if second.byte >= first {
        second.other = Some((Charset::Utf8, first));
        return decoded;
    }
    let other = Some((Charset::ShiftJis, second.byte));
    let utf8 = decode_utf8(bytes);
    Decoded {
        bad: utf8.bad.map(|bad| Undecodable { other, ..bad }),
        ..utf8
    }
}

fn decode_utf8(bytes: &[u8]) -> Decoded {
    let body = bytes.strip_prefix(MARK).unwrap_or(bytes);
    let mark = bytes.len() - body.len();
    let (text, bad) = match std::str::from_utf8(body) {
        Ok(text) => (text.to_owned(), None),
        Err(bad) => (String::from_utf8_lossy(body).into_owned(), Some(bad)),
    };
    Decoded {
        text,
        charset: Charset::Utf8,
        marked: mark > 0,
        bad: bad.map(|bad| {
            let offset = bad.valid_up_to();
            undecodable(Charset::Utf8, mark + offset, offset)
        }),
    }
}

fn decode_shift_jis(bytes: &[u8]) -> Decoded {
    let mut text = String::with_capacity(room(bytes));
    let bad = extend(&mut text, bytes).map(|byte| {
        let offset = text.len();
        let (rest, _) = SHIFT_JIS.decode_without_bom_handling(&bytes[byte..]);
        text.push_str(&rest);
        undecodable(Charset::ShiftJis, byte, offset)
    });
    Decoded {
        text,
        charset: Charset::ShiftJis,
        marked: false,
        bad,
    }
}

/// Reads Shift_JIS up to its end or to the first byte that is none, which is returned.
fn extend(text: &mut String, bytes: &[u8]) -> Option<usize> {
    let mut decoder = SHIFT_JIS.new_decoder_without_bom_handling();
    let mut at = 0;
    loop {
        let (result, read) = decoder.decode_to_string_without_replacement(&bytes[at..], text, true);
        at += read;
        match result {
            DecoderResult::InputEmpty => return None,
            DecoderResult::OutputFull => text.reserve(room(&bytes[at..])),
            DecoderResult::Malformed(length, behind) => {
                return Some(at - usize::from(length) - usize::from(behind));
            }
        }
    }
}

/// Returns the maximum length of Shift_JIS as text: three bytes for each one that is not ASCII. The decoder needs some
/// spare room.
fn room(bytes: &[u8]) -> usize {
    bytes.len() + 2 * bytes.iter().filter(|byte| !byte.is_ascii()).count() + 16
}

fn undecodable(charset: Charset, byte: usize, offset: usize) -> Undecodable {
    let end = offset + char::REPLACEMENT_CHARACTER.len_utf8();
    Undecodable {
        charset,
        byte,
        span: Span::new(offset, end),
        other: None,
    }
}

/// The bytes by which ISO-2022-JP changes to Japanese characters.
const ISO_2022_JP: &[&[u8]] = &[b"\x1b$B", b"\x1b$@"];

/// Returns the encoding that bytes look like, if it is one that programs cannot have.
pub fn looks_like(bytes: &[u8]) -> Option<&'static str> {
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Some("UTF-16");
    }
    let has = |sign: &&[u8]| bytes.windows(sign.len()).any(|window| window == *sign);
    if ISO_2022_JP.iter().any(has) {
        return Some("ISO-2022-JP (JIS)");
    }
    // Full-width letters of UTF-8 are pairs of such bytes, too.
    (std::str::from_utf8(bytes).is_err() && is_euc_jp(bytes)).then_some("EUC-JP")
}

/// Returns true if there are characters beyond ASCII and all are pairs of bytes as EUC-JP has them, kana among them:
/// what is rare in Shift_JIS.
fn is_euc_jp(bytes: &[u8]) -> bool {
    let mut rest = bytes;
    let mut kana = 0;
    while let [first, after @ ..] = rest {
        rest = match (first, after) {
            (0x00..=0x7F, _) => after,
            (0x8E | 0xA1..=0xFE, [0xA1..=0xFE, after @ ..]) => {
                kana += usize::from(matches!(first, 0xA4 | 0xA5));
                after
            }
            _ => return false,
        };
    }
    kana > 0
}

impl Source {
    /// Returns the bytes of this file with another text in the place of its own: encoding, byte order mark and DOS end
    /// of file stay, and so do the bytes of each line that the file has already, which encoding its text again would
    /// not always lead back to. New lines end as the first one does.
    ///
    /// # Errors
    /// A character that the file's encoding lacks.
    pub fn encode(&self, text: &str) -> Result<Vec<u8>, char> {
        let known: HashMap<&str, Line> = self
            .lines()
            .map(|line| (self.slice(line.span), line))
            .collect();
        let first = self.slice(self.line(1).end);
        let usual = if first.is_empty() { "\n" } else { first };
        let mut out = self.mark().to_vec();
        for line in Lines::of(text.as_bytes()) {
            let own = text.get(line.span.start..line.span.end).unwrap_or_default();
            let here = self.line(line.number);
            let known = match self.slice(here.span) == own {
                true => Some(&here),
                false => known.get(own),
            };
            match known {
                Some(line) => out.extend_from_slice(self.original(line.span)),
                None => self.encode_line(own, &mut out)?,
            }
            if line.end != Span::new(text.len(), text.len()) {
                let end = known.map(|line| self.slice(line.end)).unwrap_or_default();
                let end = if end.is_empty() { usual } else { end };
                out.extend_from_slice(end.as_bytes());
            }
        }
        out.extend_from_slice(self.tail());
        Ok(out)
    }

    /// Adds a text in the encoding of this file.
    fn encode_line(&self, text: &str, out: &mut Vec<u8>) -> Result<(), char> {
        if self.charset() == Charset::Utf8 {
            out.extend_from_slice(text.as_bytes());
            return Ok(());
        }
        for char in text.chars() {
            let mut buffer = [0; 4];
            let (bytes, _, failed) = SHIFT_JIS.encode(char.encode_utf8(&mut buffer));
            if failed {
                return Err(char);
            }
            out.extend_from_slice(&bytes);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::looks_like;
    use crate::source::{Encoding, Source};

    // clauses: 1.1
    #[test]
    fn encodings_are_known_by_their_bytes() {
        for (bytes, encoding) in [
            (&b"\xFF\xFE3\0.\x001\0"[..], Some("UTF-16")),
            (b"\xFE\xFF\x003\0.\x001", Some("UTF-16")),
            (b"3.1\n\x1b$B4k\x1b(B\n", Some("ISO-2022-JP (JIS)")),
            // EUC-JP for two hiragana.
            (b"3.1\n\xA4\xA2\xA4\xA4\n", Some("EUC-JP")),
            // The same two in Shift_JIS and UTF-8, and half-width katakana of Shift_JIS.
            (b"3.1\n\x82\xA0\x82\xA2\n", None),
            (b"3.1\n\xE3\x81\x82\xE3\x81\x84\n", None),
            (b"3.1\n\xB1\n", None),
            // Full-width `ELSE` of UTF-8.
            ("3.1\nＥＬＳＥ\n".as_bytes(), None),
            (b"3.1\nEND\n", None),
        ] {
            assert_eq!(looks_like(bytes), encoding, "{bytes:x?}");
        }
    }

    fn source(bytes: &[u8]) -> Source {
        Source::decode("a.prg", bytes, Encoding::Auto).0
    }

    #[test]
    fn the_text_itself_gives_the_bytes_of_the_file() {
        let files: [&[u8]; 6] = [
            b"",
            b"3.1\n\nEND",
            b"\xEF\xBB\xBF3.1\r\nEND\r\n\x1A",
            b"3.1\ra\r\nb\nEND\n",
            // NEC's and IBM's rows have one character twice: EE FA is not what its text is encoded to.
            b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\n",
            b"3.1\n\x83\x7D\n",
        ];
        for bytes in files {
            let source = source(bytes);
            let again = source.encode(source.text());
            assert_eq!(again.as_deref(), Ok(bytes), "{bytes:?}");
        }
    }

    #[test]
    fn lines_that_stay_keep_their_bytes_and_new_ones_are_encoded_alike() {
        // An editor gives back LF.
        let file = source(b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\nEND\r\n\x1A");
        let edited = file
            .text()
            .replace("\r\n", "\n")
            .replace("END", "REM\n// 歩\nEND");
        let bytes = file.encode(&edited);
        let expected = b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\nREM\r\n// \x95\xE0\r\nEND\r\n\x1A";
        assert_eq!(bytes.as_deref(), Ok(&expected[..]));
    }

    #[test]
    fn what_the_encoding_lacks_is_an_error() {
        let file = source(b"3.1\r\n\x95\xE0\r\n");
        assert_eq!(file.encode("3.1\n\u{1F916}\n"), Err('\u{1F916}'));
        let file = source("3.1\n歩\n".as_bytes());
        let text = "3.1\n\u{1F916}\n";
        assert_eq!(file.encode(text).as_deref(), Ok(text.as_bytes()));
    }
}
