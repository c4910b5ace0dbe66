//! The keyboard buffer.

/// Keys that wait for KEY_IN.
#[derive(Clone, Copy, Debug)]
pub(super) struct Keyboard {
    bytes: [u8; Self::CAPACITY],
    len: usize,
}

impl Keyboard {
    const CAPACITY: usize = 64;

    pub(super) const fn new() -> Self {
        Keyboard {
            bytes: [0; Self::CAPACITY],
            len: 0,
        }
    }

    /// Drops the byte if the buffer is full.
    pub(super) fn push(&mut self, byte: u8) {
        if let Some(slot) = self.bytes.get_mut(self.len) {
            *slot = byte;
            self.len += 1;
        }
    }

    /// Takes the oldest key, upper-cased; all others are lost.
    pub(super) fn take(&mut self) -> Option<u8> {
        let oldest = (!self.is_empty()).then_some(self.bytes[0]);
        self.clear();
        oldest.map(|byte| byte.to_ascii_uppercase())
    }

    pub(super) const fn clear(&mut self) {
        self.len = 0;
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.len == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // clauses: 2.23 7.33 7.34
    #[test]
    fn the_oldest_of_at_most_64_keys_is_taken_and_the_rest_is_lost() {
        let mut keyboard = Keyboard::new();
        assert_eq!(keyboard.take(), None);
        for byte in b'a'..=b'a' + 25 {
            keyboard.push(byte);
        }
        for _ in 0..100 {
            keyboard.push(b'?');
        }
        assert_eq!(keyboard.len, 64);
        assert_eq!(keyboard.take(), Some(b'A'));
        assert_eq!(keyboard.take(), None);
        keyboard.push(b'{');
        assert_eq!(keyboard.take(), Some(b'{'));
    }
}
