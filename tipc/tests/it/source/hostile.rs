//! Texts that no one would write, made of characters whose bytes are known.

use tip_runtime::random::Random;
use tipc::source::{Encoding, Source};

/// A character as a reader of the file sees it, and the bytes that spell it there.
type Spelled = (char, &'static [u8]);
/// Characters that stand together.
type Piece = &'static [Spelled];

const COMMON: &[Piece] = &[
    &[('A', b"A")],
    &[('3', b"3"), ('.', b"."), ('1', b"1")],
    &[(' ', b" ")],
    &[('\t', b"\t")],
    &[(';', b";")],
    &[('/', b"/"), ('/', b"/")],
    &[('\n', b"\n")],
    &[('\n', b"\n")],
    &[('\r', b"\r")],
    &[('\r', b"\r"), ('\n', b"\n")],
    &[('\n', b"\n"), ('\r', b"\r")],
    &[('\0', b"\0")],
    &[('\u{1A}', b"\x1A")],
    &[('\u{B}', b"\x0B"), ('\u{C}', b"\x0C")],
];

const UTF8: &[Piece] = &[
    &[('é', b"\xC3\xA9")],
    &[('あ', b"\xE3\x81\x82")],
    &[('ｱ', b"\xEF\xBD\xB1")],
    &[('🤖', b"\xF0\x9F\xA4\x96")],
    &[('\u{3000}', b"\xE3\x80\x80")],
    &[('\u{85}', b"\xC2\x85"), ('\u{2028}', b"\xE2\x80\xA8")],
    &[('\u{FEFF}', b"\xEF\xBB\xBF")],
    &[('\u{FFFD}', b"\xEF\xBF\xBD")],
];

/// Bytes that are not UTF-8: what can go on with the next byte is followed by one that ends it.
const NOT_UTF8: &[Piece] = &[
    &[('\u{FFFD}', b"\xFF")],
    &[('\u{FFFD}', b"\x80")],
    &[('\u{FFFD}', b"\xE3\x81"), ('x', b"x")],
    &[('\u{FFFD}', b"\xF0\x9F\xA4"), ('\n', b"\n")],
    &[('\u{FFFD}', b"\xF0\x9F\xA4"), ('\u{FFFD}', b"\xEF\xBF\xBD")],
    &[('\u{FFFD}', b"\xC0"), ('\u{FFFD}', b"\xAF")],
    &[
        ('\u{FFFD}', b"\xED"),
        ('\u{FFFD}', b"\xA0"),
        ('\u{FFFD}', b"\x80"),
    ],
];

/// The union sign has two codes, the circled one is an extension of NEC, the ideograph one of IBM, E000 a user's own.
const SHIFT_JIS: &[Piece] = &[
    &[('あ', b"\x82\xA0")],
    &[('表', b"\x95\x5C")],
    &[('ソ', b"\x83\x5C")],
    &[('ｱ', b"\xB1"), ('ﾞ', b"\xDE")],
    &[('\\', b"\\")],
    &[('∪', b"\x81\xBE")],
    &[('∪', b"\x87\x9C")],
    &[('①', b"\x87\x40")],
    &[('纊', b"\xFA\x5C")],
    &[('Ж', b"\x84\x47")],
    &[('\u{E000}', b"\xF0\x40")],
    &[('\u{3000}', b"\x81\x40")],
    &[('\u{80}', b"\x80")],
];

/// Bytes that are not Shift_JIS: a lead byte takes the next one with it only if that is not ASCII.
const NOT_SHIFT_JIS: &[Piece] = &[
    &[('\u{FFFD}', b"\xFF")],
    &[('\u{FFFD}', b"\xA0")],
    &[('\u{FFFD}', b"\x81\xFF")],
    &[('\u{FFFD}', b"\x85\xA0")],
    &[('\u{FFFD}', b"\x81"), (' ', b" ")],
    &[('\u{FFFD}', b"\x82"), ('\r', b"\r"), ('\n', b"\n")],
    &[('\u{FFFD}', b"\xE0"), ('0', b"0")],
];

/// A file whose characters are known.
pub(crate) struct File {
    pub(crate) encoding: Encoding,
    pub(crate) marked: bool,
    pub(crate) characters: Vec<Spelled>,
    pub(crate) bytes: Vec<u8>,
}

impl File {
    /// Returns a file of that many pieces. It is sometimes marked, undecodable, and ended as DOS does.
    pub(crate) fn random(random: &mut Random, pieces: usize) -> File {
        let (encoding, good, bad) = match random.index(2) {
            0 => (Encoding::Utf8, UTF8, NOT_UTF8),
            _ => (Encoding::ShiftJis, SHIFT_JIS, NOT_SHIFT_JIS),
        };
        let kinds = 1 + random.index(3);
        let mut characters = Vec::new();
        for _ in 0..pieces {
            let pieces = [COMMON, good, bad][random.index(kinds)];
            characters.extend(pieces[random.index(pieces.len())]);
        }
        let marked = encoding == Encoding::Utf8 && random.index(3) == 0;
        // A text that starts with the mark's character would lose it.
        let first = characters.iter().position(|(char, _)| *char != '\u{FEFF}');
        characters.drain(..first.unwrap_or(characters.len()));
        let mut bytes = match marked {
            true => b"\xEF\xBB\xBF".to_vec(),
            false => Vec::new(),
        };
        bytes.extend(characters.iter().flat_map(|(_, bytes)| *bytes));
        if random.index(3) == 0 || bytes.ends_with(b"\x1A") {
            bytes.push(0x1A);
        }
        File {
            encoding,
            marked,
            characters,
            bytes,
        }
    }

    /// Returns the file, decoded to the characters that it is made of.
    pub(crate) fn source(&self) -> Source {
        let (source, _) = Source::decode("hostile.prg", &self.bytes, self.encoding);
        let text: String = self.characters.iter().map(|(char, _)| *char).collect();
        assert_eq!(source.text(), text, "{:x?}", self.bytes);
        source
    }
}
