//! Encodings that a program cannot have, known by their bytes, so that a finding can name them.

/// The bytes by which ISO-2022-JP changes to Japanese characters.
const ISO_2022_JP: &[&[u8]] = &[b"\x1b$B", b"\x1b$@"];

/// The encoding that bytes look like, if it is one that programs cannot have.
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

/// Whether there are characters beyond ASCII and all are pairs of bytes as EUC-JP has them, kana among them: what is
/// rare in Shift_JIS.
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

#[cfg(test)]
mod tests {
    use super::looks_like;

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
}
