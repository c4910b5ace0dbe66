//! The lines that an external plant gets, and the words of the protocol.

use crate::model::Anatomy;
use crate::sim_hardware::Commands;
use std::fmt::Write as _;
use tip_runtime::command::Port;
use tip_runtime::hardware::JointCommand;

/// The version of the protocol.
pub(super) const VERSION: u32 = 1;
/// The longest answer: bytes, without the end of the line.
pub(super) const LONGEST: u64 = 65_536;

pub(super) const HELLO: &str = "hello";
pub(super) const CYCLE: &str = "cycle";
pub(super) const READY: &str = "ready";
pub(super) const STATE: &str = "state";
/// The last line.
pub(super) const BYE: &str = "bye\n";

pub(super) const NUMBER: &str = "n";
pub(super) const PROTOCOL: &str = "version";
pub(super) const ANGLES: &str = "angles";
pub(super) const TORQUES: &str = "torques";
pub(super) const LOADS: &str = "loads";
pub(super) const SLIDER: &str = "slider";
pub(super) const POSE: &str = "pose";

/// What an external plant has to know of a robot, and how many numbers belong to it.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    robot: String,
    pub(super) legs: usize,
    /// Of each leg.
    pub(super) joints: usize,
    /// ms.
    period: f64,
    /// The initial posture, leg by leg: deg.
    initial: Vec<f64>,
    /// How many of the robot's torque unit one N·m is.
    pub(super) per_newton_metre: f64,
    /// Whether it senses and gives torques.
    pub(super) has_torques: bool,
    pub(super) has_slider: bool,
    /// One on each leg if it stands on them.
    pub(super) soles: usize,
}

impl Layout {
    pub(super) fn of(robot: &str, anatomy: &Anatomy) -> Self {
        let legs = anatomy.legs.len();
        let unit = anatomy.forces.map(|forces| forces.unit.per_newton_metre());
        Layout {
            // Words end at blanks.
            robot: robot.replace(char::is_whitespace, "_"),
            legs,
            joints: anatomy.joints,
            period: anatomy.standards.period,
            initial: anatomy
                .legs
                .iter()
                .flat_map(|leg| &leg.initial)
                .copied()
                .collect(),
            per_newton_metre: unit.unwrap_or(1.0),
            has_torques: unit.is_some(),
            has_slider: anatomy.slider.is_some(),
            soles: if anatomy.body.is_some() { legs } else { 0 },
        }
    }

    /// The inputs that read what events set.
    pub(super) fn inputs(&self) -> impl Iterator<Item = Port> {
        let soles = u8::try_from(self.soles).unwrap_or(u8::MAX);
        let knobs = Port::Knob(1).named();
        knobs
            .chain((1..=soles).map(Port::Paw))
            .chain([Port::Antenna])
    }

    /// The first line.
    pub(super) fn hello(&self) -> String {
        let Layout {
            robot,
            legs,
            joints,
            period,
            ..
        } = self;
        let initial = list(self.initial.iter().copied());
        let needs = match (self.has_torques, self.has_slider) {
            (false, false) => ANGLES,
            (true, false) => "angles,torques",
            (false, true) => "angles,slider",
            (true, true) => "angles,torques,slider",
        };
        format!(
            "{HELLO} {PROTOCOL}={VERSION} robot={robot} legs={legs} joints={joints} \
             period={period:?} initial={initial} needs={needs}\n"
        )
    }

    /// The line of a control cycle.
    pub(super) fn cycle(&self, number: u64, commands: &Commands<'_>) -> String {
        let unit = self.per_newton_metre;
        let (joints, period) = (commands.joints, commands.period);
        let modes: Vec<&str> = joints.iter().map(|command| mode(*command)).collect();
        let targets = list(joints.iter().map(|command| match command {
            JointCommand::Angle { angle, .. } => *angle,
            JointCommand::Torque(torque) => torque / unit,
        }));
        let rates = list(joints.iter().map(|command| match command {
            JointCommand::Angle { rate, .. } => *rate,
            JointCommand::Torque(_) => 0.0,
        }));
        let mut line = format!(
            "{CYCLE} {NUMBER}={number} period={period:?} modes={} targets={targets} rates={rates}",
            modes.join(",")
        );
        if self.has_slider {
            line = format!("{line} {SLIDER}={}", list(commands.slider.into_iter()));
        }
        line + "\n"
    }
}

/// The line of an emergency.
pub(super) fn stop(number: u64) -> String {
    format!("stop {NUMBER}={number}\n")
}

fn mode(command: JointCommand) -> &'static str {
    match command {
        JointCommand::Angle { .. } => "angle",
        JointCommand::Torque(_) => "torque",
    }
}

/// Numbers with commas between, each the shortest that gives the same bits again.
fn list(numbers: impl Iterator<Item = f64>) -> String {
    let mut text = String::new();
    for (index, number) in numbers.enumerate() {
        let comma = if index == 0 { "" } else { "," };
        // Writing to a String cannot fail.
        let _ = write!(text, "{comma}{number:?}");
    }
    text
}
