//! The SPECIAL commands of the Hiroshima Hand (T.I.P. 3.1 §8-2). Each takes one cycle.
//!
//! Custom commands take the remaining numbers. `Written` is a hand-written program that consists of
//! `SPECIAL 30`, and ends by END if `SPECIAL_FLAG9` is set:
//!
//! ```
//! use tip_runtime::command::{Flag, Poll};
//! use tip_runtime::machine::{Machine, Status};
//! use tip_runtime::model::hand;
//! use tip_runtime::plant::SimulatedHand;
//! use tip_runtime::program::Robot;
//! use tip_runtime::special::{Call, hand::HandSpecials};
//! # use tip_runtime::command::{Command, Op, Target, Value};
//! # use tip_runtime::fault::Fault;
//! # use tip_runtime::program::{Context, End, Flow, Program, Signature};
//! #
//! # struct Written { at: u32 }
//! #
//! # impl Program for Written {
//! #     fn signature(&self) -> Signature { hand::MODEL.signature() }
//! #     fn name(&self) -> &str { "written" }
//! #     fn title(&self) -> &str { "" }
//! #     fn at(&self) -> u32 { self.at }
//! #     fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
//! #         let special = Command { op: Op::Special, hs: false, target: Target::None, values: &[Value::Absolute(30.0)] };
//! #         match self.at {
//! #             0 => cx.ask(&special, &mut self.at, 1),
//! #             _ if cx.flag(Flag::Special(9)) => Ok(Flow::Finished(End::End)),
//! #             _ => Ok(Flow::Finished(End::Exit)),
//! #         }
//! #     }
//! #     fn scalar(&self, _: usize) -> Option<(&str, Option<f64>)> { None }
//! #     fn set_scalar(&mut self, _: usize, _: f64) {}
//! #     fn line(&self, step: u32) -> u32 { step + 3 }
//! #     fn reset(&mut self) { self.at = 0; }
//! # }
//!
//! let specials = HandSpecials::with_user(|call: Call, robot: &mut dyn Robot| match call.number {
//!     30 => {
//!         robot.set_special_flag(9, true);
//!         Ok(Poll::Done)
//!     }
//!     _ => Err(Fault::Domain),
//! });
//! let plant = SimulatedHand::new(&hand::MODEL);
//! let mut machine = Machine::new(Written { at: 0 }, &hand::MODEL, plant)?.with_special(specials);
//! assert_eq!(machine.cycle(), Status::Running);
//! assert_eq!(machine.cycle(), Status::Finished(End::End));
//! # Ok::<(), tip_runtime::machine::Mismatch>(())
//! ```

use super::{Call, Special};
use crate::command::{Command, MAX, Op, Poll, Target, Teach, Value};
use crate::fault::Fault;
use crate::model::Range;
use crate::program::Robot;
use crate::vibration::{Vibration, Waveform};

/// The numbers of the hand's own commands.
pub const NUMBERS: &[u8] = &[1, 2, 5, 6, 10, 11, 12, 13, 14, 15, 16, 20];

/// Number of fingers of the hand.
const FINGERS: usize = 3;
/// Number of joints of each finger.
const JOINTS: usize = 3;

/// The SPECIAL commands of the hand, in addition to those of a user.
///
/// | number | what |
/// |---|---|
/// | 1, 2 | lever motion: begin, carry on |
/// | 5, 6 | active force closure of the second kind: begin, carry on; sets `SPECIAL_FLAG0` |
/// | 10 | active friction control off |
/// | 11–13 | active friction control of F1, F2, F3: mode, amplitude in V |
/// | 14–16 | its frequency: Hz |
/// | 20 | bar graph 0 or 1 off or on |
///
/// Wrong arguments are a `Domain` error; every other number is the user's.
#[derive(Clone, Debug, Default)]
pub struct HandSpecials<U = ()> {
    lever: Lever,
    closure: Closure,
    friction: FrictionControl,
    user: U,
}

impl HandSpecials {
    /// Returns the hand's commands alone.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }
}

impl<U> HandSpecials<U> {
    /// Returns the hand's commands, and those of `user` for every other number.
    #[must_use]
    pub fn with_user(user: U) -> Self {
        HandSpecials {
            lever: Lever::default(),
            closure: Closure::default(),
            friction: FrictionControl::default(),
            user,
        }
    }
}

impl<U: Special> Special for HandSpecials<U> {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        let arguments = call.arguments;
        match call.number {
            1 => self.lever.begin(arguments, robot)?,
            2 => self.lever.carry_on(arguments, robot)?,
            5 => self.closure.begin(arguments, robot)?,
            6 => self.closure.carry_on(arguments, robot)?,
            10 => self.friction.stop(arguments, robot)?,
            11..=13 => self.friction.switch(call.number - 10, arguments, robot)?,
            14..=16 => self.friction.tune(call.number - 13, arguments, robot)?,
            20 => show_graph(arguments, robot)?,
            _ => return self.user.poll(call, robot),
        }
        Ok(Poll::Done)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.closure.elapse(robot.period());
        self.user.cycle(robot)
    }
}

/// SPECIAL 20: takes a graph's number, then 1 for on or 0 for off.
fn show_graph(arguments: [Option<f64>; 2], robot: &mut dyn Robot) -> Result<(), Fault> {
    let [Some(graph), Some(on)] = arguments else {
        return Err(Fault::Domain);
    };
    robot.show_graph(u8::from(bit(graph)?), bit(on)?)
}

fn bit(value: f64) -> Result<bool, Fault> {
    match value {
        0.0 => Ok(false),
        1.0 => Ok(true),
        _ => Err(Fault::Domain),
    }
}

/// Refuses a number that is negative or infinite.
fn not_negative(value: f64) -> Result<f64, Fault> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Fault::Domain)
    }
}

/// The stiffness that keeps the height: N/mm.
const HEIGHT_STIFFNESS: f64 = 0.2;

const MILLIMETRES_PER_METRE: f64 = 1000.0;

/// Lever motion: a soft spring draws the end of each finger's second link sideways to the middle of the hand, a stiff
/// one keeps its height. The fingertip joint is left alone.
#[derive(Clone, Debug, Default)]
struct Lever {
    /// Heights to keep, mm.
    heights: Option<[f64; FINGERS]>,
    /// Stiffness towards the middle, N/m.
    stiffness: Option<f64>,
}

impl Lever {
    /// SPECIAL 1: stores the measured heights, and the stiffness, if one is given.
    fn begin(&mut self, arguments: [Option<f64>; 2], robot: &mut dyn Robot) -> Result<(), Fault> {
        let [stiffness, None] = arguments else {
            return Err(Fault::Domain);
        };
        let stiffness = stiffness.map(not_negative).transpose()?;
        let mut heights = [0.0; FINGERS];
        for (n, height) in (1..).zip(&mut heights) {
            let [_, y, ..] = robot.teach(Teach::Position, Target::Joint(n, 3))?;
            *height = y;
        }
        *self = Lever {
            heights: Some(heights),
            stiffness,
        };
        Ok(())
    }

    /// SPECIAL 2: sets the springs, with the stiffness given here, or else that of SPECIAL 1.
    fn carry_on(
        &mut self,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let ([stiffness, None], Some(heights)) = (arguments, self.heights) else {
            return Err(Fault::Domain);
        };
        let stiffness = not_negative(stiffness.or(self.stiffness).ok_or(Fault::Domain)?)?;
        let sideways = stiffness / MILLIMETRES_PER_METRE;
        for (n, height) in (1..).zip(heights) {
            let point = Target::Joint(n, 3);
            robot.pull(point, [0.0, height, 0.0], [sideways, HEIGHT_STIFFNESS, 0.0])?;
        }
        Ok(())
    }
}

/// The state of a finger at the beginning of the closure.
#[derive(Clone, Copy, Debug, Default)]
struct HeldFinger {
    /// Steady torques, mN·m.
    torques: [f64; MAX],
    /// Desired joint angles `θ_d`, deg.
    angles: [f64; MAX],
    /// Position of the fingertip, mm.
    fingertip: [f64; 2],
}

/// The closure in progress.
#[derive(Clone, Copy, Debug)]
struct Carrying {
    fingers: [HeldFinger; FINGERS],
    /// mN·m/deg.
    gain: f64,
    /// Distance that the fingertips are to move, mm; without one they move on.
    distance: Option<f64>,
    /// Desired displacement so far, mm along x and y.
    displacement: [f64; 2],
    arrived: bool,
    /// Time since the last SPECIAL 6, ms; `None` before the first one.
    elapsed: Option<f64>,
}

/// Active force closure of the second kind: the fingertips move the object that they hold, each joint by its steady
/// torque and a correction, `τ = τ₀ + k (θ_d − θ)`.
#[derive(Clone, Debug, Default)]
struct Closure(Option<Carrying>);

impl Closure {
    /// SPECIAL 5: takes gain and distance, stores the state of the fingers and clears
    /// SPECIAL_FLAG0.
    fn begin(&mut self, arguments: [Option<f64>; 2], robot: &mut dyn Robot) -> Result<(), Fault> {
        let [Some(gain), distance] = arguments else {
            return Err(Fault::Domain);
        };
        let mut fingers = [HeldFinger::default(); FINGERS];
        for (n, finger) in (1..).zip(&mut fingers) {
            *finger = HeldFinger {
                torques: robot.torques(n)?,
                angles: robot.teach(Teach::Angle, Target::Foot(n))?,
                fingertip: fingertip(n, robot)?,
            };
        }
        self.0 = Some(Carrying {
            fingers,
            gain: not_negative(gain)?,
            distance: distance.map(not_negative).transpose()?,
            displacement: [0.0; 2],
            arrived: false,
            elapsed: None,
        });
        robot.set_special_flag(0, false);
        Ok(())
    }

    /// SPECIAL 6: takes the velocity along x and y; called repeatedly. The desired displacement
    /// grows by it for the time since the last call.
    fn carry_on(
        &mut self,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let ([Some(x), Some(y)], Some(mut carrying)) = (arguments, self.0) else {
            return Err(Fault::Domain);
        };
        let velocity = [crate::ops::finite(x)?, crate::ops::finite(y)?];
        carrying.advance(velocity, robot)?;
        let torques = carrying.torques(robot)?;
        for (n, torques) in (1..).zip(torques) {
            robot.command(&Command {
                op: Op::Torque,
                hs: false,
                target: Target::Foot(n),
                values: &torques.map(Value::Absolute),
            })?;
        }
        if carrying.arrived {
            robot.set_special_flag(0, true);
        }
        self.0 = Some(carrying);
        Ok(())
    }

    /// Adds a cycle of `period` ms to the elapsed time.
    fn elapse(&mut self, period: f64) {
        if let Some(Carrying {
            elapsed: Some(elapsed),
            ..
        }) = &mut self.0
        {
            *elapsed += period;
        }
    }
}

impl Carrying {
    /// Checks whether the fingertips have arrived; if not, their desired positions move at
    /// `velocity` (mm/s).
    fn advance(&mut self, velocity: [f64; 2], robot: &dyn Robot) -> Result<(), Fault> {
        let gone = self.gone_along(velocity, robot)?;
        self.arrived |= self.distance.is_some_and(|distance| gone >= distance);
        let seconds = self.elapsed.replace(0.0).unwrap_or(0.0) / 1000.0;
        if !self.arrived {
            for (displacement, velocity) in self.displacement.iter_mut().zip(velocity) {
                *displacement += velocity * seconds;
            }
        }
        Ok(())
    }

    /// Returns the mean distance that the fingertips have moved along a velocity, mm.
    fn gone_along(&self, [vx, vy]: [f64; 2], robot: &dyn Robot) -> Result<f64, Fault> {
        let speed = libm::hypot(vx, vy);
        if speed == 0.0 {
            return Ok(0.0);
        }
        let mut sum = 0.0;
        for (n, finger) in (1..).zip(&self.fingers) {
            let ([x, y], [from_x, from_y]) = (fingertip(n, robot)?, finger.fingertip);
            sum += (x - from_x) * (vx / speed) + (y - from_y) * (vy / speed);
        }
        Ok(sum / FINGERS as f64)
    }

    /// Returns the torque of each joint, mN·m.
    fn torques(&mut self, robot: &dyn Robot) -> Result<[[f64; JOINTS]; FINGERS], Fault> {
        let mut torques = [[0.0; JOINTS]; FINGERS];
        let [dx, dy] = self.displacement;
        for (n, (finger, torques)) in (1..).zip(self.fingers.iter_mut().zip(&mut torques)) {
            let [x, y] = finger.fingertip;
            finger.angles = robot.inverse(n, &finger.angles, [x + dx, y + dy, 0.0])?;
            let measured = robot.teach(Teach::Angle, Target::Foot(n))?;
            let errors = finger.angles.iter().zip(measured).map(|(d, at)| d - at);
            for (torque, (steady, error)) in
                torques.iter_mut().zip(finger.torques.iter().zip(errors))
            {
                *torque = crate::ops::finite(steady + self.gain * error)?;
            }
        }
        Ok(torques)
    }
}

fn fingertip(n: u8, robot: &dyn Robot) -> Result<[f64; 2], Fault> {
    let [x, y, ..] = robot.teach(Teach::Position, Target::Foot(n))?;
    Ok([x, y])
}

/// Valid frequencies of SPECIAL 14 to 16, Hz.
const FREQUENCIES: Range = Range::new(0.0, 60.0);
/// Default frequency, Hz.
const STANDARD_FREQUENCY: f64 = 30.0;

/// The vibration mode of a finger.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// 0: nothing; so do 5 and 7, which the language reserves.
    Still,
    /// 1: the fingertip joint.
    Fingertip,
    /// 2: all joints, to and fro together.
    Together,
    /// 3: all joints, in the direction that loosens.
    Loosening,
    /// 4 clockwise, 6 counter-clockwise, as seen with x to the right and y up: the fingertip carries
    /// the object around slowly and slips back fast.
    Rolling { clockwise: bool },
}

impl Mode {
    fn new(number: f64) -> Result<Self, Fault> {
        Ok(match number {
            0.0 | 5.0 | 7.0 => Mode::Still,
            1.0 => Mode::Fingertip,
            2.0 => Mode::Together,
            3.0 => Mode::Loosening,
            4.0 => Mode::Rolling { clockwise: true },
            6.0 => Mode::Rolling { clockwise: false },
            _ => return Err(Fault::Domain),
        })
    }

    /// Returns waveform and share of the amplitude of each joint of finger `n`. Positive is
    /// closing; a fingertip that points to the object moves up then, whichever side it is on.
    fn waves(self, n: u8) -> [Option<(Waveform, f64)>; JOINTS] {
        let fingertip = |waveform, share| [None, None, Some((waveform, share))];
        match self {
            Mode::Still => [None; JOINTS],
            Mode::Fingertip => fingertip(Waveform::Sine, 1.0),
            Mode::Together => [Some((Waveform::Sine, 1.0)); JOINTS],
            Mode::Loosening => [Some((Waveform::OneSided, -1.0)); JOINTS],
            // F1 is on the left of the object, where clockwise is up; the others are opposite.
            Mode::Rolling { clockwise } => {
                let up = clockwise == (n == 1);
                fingertip(Waveform::Sawtooth, if up { 1.0 } else { -1.0 })
            }
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct VibratingFinger {
    mode: Mode,
    /// V.
    amplitude: f64,
    /// Hz.
    frequency: f64,
}

/// Active friction control: fingers vibrate, so that the object that they hold slips in the wanted direction.
#[derive(Clone, Debug)]
struct FrictionControl([VibratingFinger; FINGERS]);

impl Default for FrictionControl {
    fn default() -> Self {
        let still = VibratingFinger {
            mode: Mode::Still,
            amplitude: 0.0,
            frequency: STANDARD_FREQUENCY,
        };
        FrictionControl([still; FINGERS])
    }
}

impl FrictionControl {
    /// SPECIAL 10: stops the vibration of every finger.
    fn stop(&mut self, arguments: [Option<f64>; 2], robot: &mut dyn Robot) -> Result<(), Fault> {
        let [None, None] = arguments else {
            return Err(Fault::Domain);
        };
        for (n, finger) in (1..).zip(&mut self.0) {
            finger.mode = Mode::Still;
            finger.shake(n, robot)?;
        }
        Ok(())
    }

    /// SPECIAL 11 to 13: sets mode and amplitude of finger `n`, from 1, and restarts its wave.
    fn switch(
        &mut self,
        n: u8,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let [Some(mode), Some(amplitude)] = arguments else {
            return Err(Fault::Domain);
        };
        let (mode, amplitude) = (Mode::new(mode)?, not_negative(amplitude)?);
        let finger = self.finger(n)?;
        finger.mode = Mode::Still;
        finger.shake(n, robot)?;
        finger.mode = mode;
        finger.amplitude = amplitude;
        finger.shake(n, robot)
    }

    /// SPECIAL 14 to 16: sets the frequency of finger `n`, from 1; its wave keeps the phase.
    fn tune(
        &mut self,
        n: u8,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let [Some(frequency), None] = arguments else {
            return Err(Fault::Domain);
        };
        if !FREQUENCIES.contains(frequency) {
            return Err(Fault::Domain);
        }
        let finger = self.finger(n)?;
        finger.frequency = frequency;
        finger.shake(n, robot)
    }

    fn finger(&mut self, n: u8) -> Result<&mut VibratingFinger, Fault> {
        let at = usize::from(n).wrapping_sub(1);
        self.0.get_mut(at).ok_or(Fault::Domain)
    }
}

impl VibratingFinger {
    /// Commands the vibration of finger `n`'s joints.
    fn shake(&self, n: u8, robot: &mut dyn Robot) -> Result<(), Fault> {
        for (m, wave) in (1..).zip(self.mode.waves(n)) {
            let vibration = wave.map(|(waveform, share)| Vibration {
                waveform,
                amplitude: share * self.amplitude,
                frequency: self.frequency,
            });
            robot.vibrate(Target::Joint(n, m), vibration)?;
        }
        Ok(())
    }
}
