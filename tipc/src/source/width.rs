//! Byte lengths as code page 932 counts them, whatever the file's encoding.

use encoding_rs::SHIFT_JIS;
use std::sync::LazyLock;

/// One bit for each character of the basic plane: whether two bytes of code page 932 spell it.
type DoubleByte = Box<[u64; 1024]>;

static DOUBLE_BYTE: LazyLock<DoubleByte> = LazyLock::new(|| {
    let mut set: DoubleByte = Box::new([0; 1024]);
    for lead in (0x81..=0x9F).chain(0xE0..=0xFC) {
        for trail in 0x40..=0xFC {
            let pair = [lead, trail];
            let (text, bad) = SHIFT_JIS.decode_without_bom_handling(&pair);
            if let (false, Some(char)) = (bad, text.chars().next()) {
                let code = char as usize & 0xFFFF;
                set[code / 64] |= 1 << (code % 64);
            }
        }
    }
    set
});

/// Where in `text` the first character is that does not fit into `limit` bytes of code page 932: half-width 1,
/// full-width 2; a character outside it counts its UTF-8 bytes.
pub(crate) fn first_beyond(text: &str, limit: usize) -> Option<usize> {
    // No character is longer in code page 932 than in UTF-8.
    if text.len() <= limit {
        return None;
    }
    let mut length = 0;
    for (at, char) in text.char_indices() {
        length += char_length(char);
        if length > limit {
            return Some(at);
        }
    }
    None
}

/// How many bytes of code page 932 spell `text`; on a terminal, how many columns it takes.
pub fn byte_length(text: &str) -> usize {
    match text.is_ascii() {
        true => text.len(),
        false => text.chars().map(char_length).sum(),
    }
}

fn char_length(char: char) -> usize {
    match char {
        '\0'..='\u{80}' | '\u{A5}' | '\u{FF61}'..='\u{FF9F}' => 1,
        _ if is_double_byte(char) => 2,
        _ => char.len_utf8(),
    }
}

fn is_double_byte(char: char) -> bool {
    let code = char as usize;
    code <= 0xFFFF && DOUBLE_BYTE[code / 64] >> (code % 64) & 1 == 1
}
