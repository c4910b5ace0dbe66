//! The bytes on the wire: `0xFF 0xFE id instruction low high checksum`.
//!
//! Every frame has the same seven bytes. The checksum makes the last five add up to 0 (mod 256).

/// Length of a frame, bytes.
pub const LENGTH: usize = 7;

/// The address that every servo listens to.
pub const BROADCAST: u8 = 0xFE;

const HEADER: [u8; 2] = [0xFF, 0xFE];

/// Request or answer of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instruction {
    /// Remember this target: counts.
    Target,
    /// All servos set off to their targets together.
    Go,
    /// Report the position.
    Ask,
    /// The answer to [`Ask`](Self::Ask): counts.
    Position,
    /// Hold where you are.
    Stop,
}

impl Instruction {
    const ALL: [Instruction; 5] = [
        Instruction::Target,
        Instruction::Go,
        Instruction::Ask,
        Instruction::Position,
        Instruction::Stop,
    ];

    fn from_byte(byte: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|known| *known as u8 == byte)
    }
}

/// One frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Whom it is for, or from.
    pub servo: u8,
    /// Request or answer.
    pub instruction: Instruction,
    /// Counts, where the instruction carries them.
    pub value: i16,
}

impl Frame {
    /// The frame's bytes.
    pub fn encode(&self) -> [u8; LENGTH] {
        let [low, high] = self.value.to_le_bytes();
        let body = [self.servo, self.instruction as u8, low, high];
        let [first, second] = HEADER;
        let [servo, instruction, low, high] = body;
        [first, second, servo, instruction, low, high, checksum(body)]
    }

    /// The frame in `bytes`, unless they were damaged on their way.
    pub fn decode(bytes: [u8; LENGTH]) -> Option<Self> {
        let [first, second, servo, instruction, low, high, sum] = bytes;
        let intact = [first, second] == HEADER && sum == checksum([servo, instruction, low, high]);
        let instruction = Instruction::from_byte(instruction)?;
        intact.then_some(Frame {
            servo,
            instruction,
            value: i16::from_le_bytes([low, high]),
        })
    }
}

fn checksum(body: [u8; 4]) -> u8 {
    body.iter().fold(0, |sum: u8, byte| sum.wrapping_sub(*byte))
}
