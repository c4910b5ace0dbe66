//! Frames in a stream of bytes that may be damaged. The bytes of a frame belong to its [family](crate::family).

use heapless::Vec;

/// Identity that every servo listens to.
pub const BROADCAST: u8 = 0xFE;
/// Maximum length of a frame, bytes.
pub const MAX_FRAME_BYTES: usize = 512;

/// A frame to be sent.
pub type Bytes = Vec<u8, MAX_FRAME_BYTES>;

/// The frame does not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong;

/// Adds bytes to a frame.
///
/// # Errors
/// They do not fit.
pub fn add(frame: &mut Bytes, bytes: &[u8]) -> Result<(), TooLong> {
    frame.extend_from_slice(bytes).map_err(|_| TooLong)
}

/// An answer without its framing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The servo that sent it.
    pub id: u8,
    /// Error byte, command or receiver, as the family has it.
    pub code: u8,
    /// Everything else.
    pub parameters: Bytes,
}

/// The beginning of a stream of bytes.
#[allow(clippy::large_enum_variant, reason = "there is no allocator")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Parsed {
    /// A frame, and the number of its bytes.
    Frame(Frame, usize),
    /// The beginning of a frame, perhaps; more bytes decide.
    Unfinished,
    /// A valid remark of the adapter, and the number of its bytes.
    Remark(usize),
    /// No frame begins here.
    Nothing,
}

/// Returns true if bytes, as many as there are, are those of a header.
pub fn begins(bytes: &[u8], header: &[u8]) -> bool {
    let mut pairs = bytes.iter().zip(header);
    pairs.all(|(byte, wanted)| byte == wanted)
}

/// Returns the inverted sum of bytes: the checksum of Dynamixel protocol 1, Feetech and LX frames.
pub fn checksum(body: &[u8]) -> u8 {
    !body.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte))
}

/// Finds frames in a stream of bytes. After damaged bytes it looks for a frame at each of the following ones, so that an intact
/// frame is found whatever came before it.
#[derive(Clone, Debug, Default)]
pub struct Decoder {
    buffer: Bytes,
    discarded: u64,
}

impl Decoder {
    /// Creates a decoder with nothing in it.
    pub const fn new() -> Self {
        Decoder {
            buffer: Vec::new(),
            discarded: 0,
        }
    }

    /// Adds a byte.
    pub fn push(&mut self, byte: u8) {
        if self.buffer.is_full() {
            self.drop_front(1);
        }
        // There is room now.
        let _ = self.buffer.push(byte);
    }

    /// Returns the next frame; bytes that cannot become one are discarded.
    pub fn next(&mut self, parse: &dyn Fn(&[u8]) -> Parsed) -> Option<Frame> {
        loop {
            if self.buffer.is_empty() {
                return None;
            }
            match parse(&self.buffer) {
                Parsed::Frame(frame, length) => {
                    self.drop_front(length);
                    return Some(frame);
                }
                Parsed::Unfinished => return None,
                Parsed::Remark(length) => self.drop_front(length),
                Parsed::Nothing => self.discard(1),
            }
        }
    }

    /// Returns the next frame after one that is not finished and never will be.
    pub fn next_after_silence(&mut self, parse: &dyn Fn(&[u8]) -> Parsed) -> Option<Frame> {
        while !self.buffer.is_empty() {
            self.discard(1);
            if let Some(frame) = self.next(parse) {
                return Some(frame);
            }
        }
        None
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.discard(self.buffer.len());
    }

    /// Returns the number of bytes that were in no frame.
    pub const fn discarded(&self) -> u64 {
        self.discarded
    }

    fn discard(&mut self, count: usize) {
        self.discarded += count as u64;
        self.drop_front(count);
    }

    fn drop_front(&mut self, count: usize) {
        self.buffer.drain(..count.min(self.buffer.len()));
    }
}
