//! The servo bus as hardware of the control loop: the one trait that a robot must bring.
//!
//! Every frame on the wire has seven bytes: `0xFF 0xFE id instruction low high checksum`. The checksum makes the last five
//! add up to 0 (mod 256).

use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};

/// The legs of TITAN VIII.
pub const LEGS: usize = 4;
/// The joints of a leg.
pub const JOINTS: usize = 3;

/// The servo of a joint. Motor angle = sign · joint angle + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// The address on the bus.
    pub id: u8,
    /// 1 or −1: which way the motor turns when the joint's angle grows.
    pub sign: f64,
    /// The motor angle when the joint is at 0, deg.
    pub offset: f64,
}

/// The servos of all joints, leg by leg, as the robot's builder measured them.
pub const DRIVES: [[Drive; JOINTS]; LEGS] = [
    [
        drive(11, 1.0, 0.0),
        drive(12, 1.0, -1.5),
        drive(13, -1.0, 90.0),
    ],
    [
        drive(21, -1.0, 2.0),
        drive(22, -1.0, 0.0),
        drive(23, 1.0, -90.0),
    ],
    [
        drive(31, -1.0, -0.5),
        drive(32, 1.0, 0.0),
        drive(33, -1.0, 91.0),
    ],
    [
        drive(41, 1.0, 0.0),
        drive(42, -1.0, 1.0),
        drive(43, 1.0, -90.0),
    ],
];

/// Encoder counts of a full turn.
const COUNTS_PER_TURN: f64 = 4096.0;
/// Encoder count at a motor angle of 0.
const MIDDLE: f64 = 2048.0;

const fn drive(id: u8, sign: f64, offset: f64) -> Drive {
    Drive { id, sign, offset }
}

impl Drive {
    /// Returns the encoder count at which the servo holds its joint at `angle` (deg).
    pub fn counts(&self, angle: f64) -> f64 {
        MIDDLE + (self.sign * angle + self.offset) * COUNTS_PER_TURN / 360.0
    }

    /// Returns the joint's angle (deg) at an encoder count.
    pub fn angle(&self, counts: f64) -> f64 {
        ((counts - MIDDLE) * 360.0 / COUNTS_PER_TURN - self.offset) * self.sign
    }
}

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
    /// Hold the present position.
    Stop,
}

/// A frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The servo that it is for, or from.
    pub servo: u8,
    /// Request or answer.
    pub instruction: Instruction,
    /// Counts, where the instruction carries them.
    pub value: i16,
}

impl Frame {
    /// Returns the bytes of the frame.
    pub fn encode(&self) -> [u8; LENGTH] {
        let [low, high] = self.value.to_le_bytes();
        let body = [self.servo, self.instruction as u8, low, high];
        let sum = body.iter().fold(0, |sum: u8, byte| sum.wrapping_sub(*byte));
        let [first, second] = HEADER;
        [first, second, body[0], body[1], body[2], body[3], sum]
    }

    /// Returns the frame in `bytes`, unless they were damaged on their way.
    pub fn decode(bytes: [u8; LENGTH]) -> Option<Self> {
        use Instruction::{Ask, Go, Position, Stop, Target};
        let [_, _, servo, instruction, low, high, _] = bytes;
        let all = [Target, Go, Ask, Position, Stop];
        let frame = Frame {
            servo,
            instruction: *all.get(usize::from(instruction))?,
            value: i16::from_le_bytes([low, high]),
        };
        (frame.encode() == bytes).then_some(frame)
    }
}

/// The byte stream of the bus. Implement it for your serial port.
pub trait Link {
    /// Sends the bytes of a frame; returns false if the wire is dead.
    fn send(&mut self, bytes: [u8; LENGTH]) -> bool;
    /// Returns the bytes of the next frame, or `None` if none came in time.
    fn receive(&mut self) -> Option<[u8; LENGTH]>;
}

/// TITAN VIII on position servos.
#[derive(Clone, Debug)]
pub struct ServoBus<L>(pub L);

impl<L: Link> ServoBus<L> {
    fn send(
        &mut self,
        servo: u8,
        instruction: Instruction,
        value: i16,
    ) -> Result<(), HardwareFault> {
        let frame = Frame {
            servo,
            instruction,
            value,
        };
        let sent = self.0.send(frame.encode());
        sent.then_some(())
            .ok_or(HardwareFault::new("servo bus: dead"))
    }

    fn ask(&mut self, servo: u8) -> Result<i16, HardwareFault> {
        self.send(servo, Instruction::Ask, 0)?;
        let fault = |cause| HardwareFault::new(cause).of_servo(servo.into());
        let bytes = self.0.receive().ok_or(fault("no answer"))?;
        let frame = Frame::decode(bytes).ok_or(fault("damaged answer"))?;
        let is_its = frame.servo == servo && frame.instruction == Instruction::Position;
        is_its
            .then_some(frame.value)
            .ok_or(fault("answer of another servo"))
    }
}

impl<L: Link> Hardware<LEGS, JOINTS> for ServoBus<L> {
    fn read(&mut self, into: &mut Sensors<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        for ((leg, angles), drives) in (1..).zip(&mut into.angles).zip(&DRIVES) {
            for ((joint, angle), drive) in (1..).zip(angles).zip(drives) {
                let counts = self
                    .ask(drive.id)
                    .map_err(|fault| fault.at_joint(leg, joint))?;
                *angle = drive.angle(f64::from(counts));
            }
        }
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        for (command, drive) in outputs.joints.iter().flatten().zip(DRIVES.iter().flatten()) {
            let JointCommand::Angle { angle, .. } = *command else {
                return Err(HardwareFault::new("position servos give no torque"));
            };
            let counts = drive.counts(angle).round() as i16;
            self.send(drive.id, Instruction::Target, counts)?;
        }
        self.send(BROADCAST, Instruction::Go, 0)
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        self.send(BROADCAST, Instruction::Stop, 0)
    }
}
