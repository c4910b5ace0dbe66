//! The keys of a terminal: bytes, and the sequences that arrows and function keys send.

/// A key of a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// A character, or a control character such as RETURN and ESC.
    Byte(u8),
    /// An arrow up.
    Up,
    /// An arrow down.
    Down,
    /// An arrow to the left.
    Left,
    /// An arrow to the right.
    Right,
}

const ESCAPE: u8 = 0x1B;

/// The bytes of a terminal as keys. A sequence begins as the key ESC does, which asks a program to halt; the bytes of a sequence come
/// together.
#[derive(Debug, Default)]
pub(super) struct KeyDecoder {
    /// A byte that was read to see whether it belongs to a sequence.
    read: Option<u8>,
}

impl KeyDecoder {
    /// Returns the next key; `None` if `read` has no byte. Keys without a meaning here, such as Home and F5, are left out (ECMA-48 §5.4).
    pub(super) fn key(&mut self, mut read: impl FnMut() -> Option<u8>) -> Option<Key> {
        loop {
            match self.read.take().or_else(&mut read)? {
                ESCAPE => {}
                byte => return Some(Key::Byte(byte)),
            }
            let mut next = read();
            match next {
                Some(b'[') => {
                    next = read();
                    while let Some(b' '..=b'?') = next {
                        next = read();
                    }
                }
                Some(b'O') => next = read(),
                _ => {
                    self.read = next;
                    return Some(Key::Byte(ESCAPE));
                }
            }
            match next {
                Some(b'A') => return Some(Key::Up),
                Some(b'B') => return Some(Key::Down),
                Some(b'C') => return Some(Key::Right),
                Some(b'D') => return Some(Key::Left),
                Some(b'@'..=b'~') => {}
                // No sequence has this byte: it is a key, and may be RETURN.
                broken => self.read = broken,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    fn keys(bytes: &[u8]) -> Vec<Key> {
        let (mut bytes, mut decoder) = (bytes.iter().copied(), KeyDecoder::default());
        std::iter::from_fn(|| decoder.key(|| bytes.next())).collect()
    }

    #[test]
    fn arrows_are_no_escape() {
        let arrows = [Key::Up, Key::Down, Key::Right, Key::Left];
        assert_eq!(keys(b"\x1b[A\x1b[B\x1b[C\x1b[D"), arrows);
        assert_eq!(keys(b"\x1bOA\x1bOB\x1bOC\x1bOD"), arrows);
        assert_eq!(keys(b"\x1b[1;5A"), [Key::Up], "with Ctrl");
    }

    #[test]
    fn other_keys_of_a_terminal_are_left_out() {
        // Home, Delete, F1, F5, and the wheel of a mouse.
        let x = [Key::Byte(b'x')];
        assert_eq!(keys(b"\x1b[H\x1b[3~\x1bOP\x1b[15~\x1b[<64;1;1Mx"), x);
    }

    #[test]
    fn escape_alone_stays_escape() {
        let [escape, x] = [ESCAPE, b'x'].map(Key::Byte);
        assert_eq!(keys(b"\x1b"), [escape]);
        assert_eq!(keys(b"\x1bx"), [escape, x]);
        assert_eq!(keys(b"\x1b\x1b[Ax"), [escape, Key::Up, x]);
    }

    /// The emergency stop is in no sequence, and a sequence that is cut off takes no other key with it.
    #[test]
    fn no_sequence_swallows_return() {
        let [escape, stop] = [ESCAPE, b'\r'].map(Key::Byte);
        assert_eq!(keys(b"\x1b\r"), [escape, stop]);
        for cut in [&b"\x1b[\r"[..], b"\x1b[1;\r", b"\x1bO\r"] {
            assert_eq!(keys(cut), [stop], "{cut:?}");
        }
        assert_eq!(keys(b"\x1b[\x1b[A\r"), [Key::Up, stop]);
    }
}
