//! A described robot on a bus of servos: from `[bus]` and `[[drive]]` of its description to joints, limits and
//! [`Drives`], and to simulated servos in its place.

use crate::bus::{Bus, Port, Timing};
use crate::drives::{Drives, Invalid, Joint, Policy, Settings};
use crate::model::{MODELS, Model};
use crate::simulated::{Servo, SimulatedBus};
use core::fmt;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;
use tip_runtime::command::Target;
use tip_runtime::model::{self, Range};
use tip_runtime::plant::Distances;
use tipc::description::{self, Description, WithModel};

/// A described robot whose joints are servos on a bus.
#[derive(Clone, Debug)]
pub struct Described {
    /// `[bus]` of its description.
    pub bus: description::Bus,
    /// The joints, leg by leg.
    pub joints: Vec<Joint>,
    /// Joints of each leg.
    pub of_leg: usize,
    /// Initial posture, deg.
    pub initial: Vec<f64>,
    /// Sampling time, ms.
    pub period: f64,
    /// The distances between its parts.
    pub distances: Distances,
}

/// A reason why a described robot cannot be on a bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotOnBus {
    /// Its description has no `[bus]`, or no drives.
    NoBus,
    /// Its description has this table, which asks for sensors or actuators that no servo is.
    NoServo(&'static str),
}

impl fmt::Display for NotOnBus {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotOnBus::NoBus => f.write_str("the description has no [bus] with drives"),
            NotOnBus::NoServo(table) => write!(
                f,
                "[{table}] cannot be on a bus: its servos measure and move joints only. Leave the table out, or implement \
                 `Hardware` by hand"
            ),
        }
    }
}

impl core::error::Error for NotOnBus {}

/// Returns the servos that a description can name.
pub fn servos() -> Vec<description::Servo> {
    let servo = |model: &Model| description::Servo {
        name: model.name,
        family: model.family.name(),
        travel: Range::new(model.angle(0.0), model.angle(model.largest.into())),
    };
    MODELS.iter().map(servo).collect()
}

/// Reads a description whose drives are servos of these families. `name` is how messages call the file.
///
/// # Errors
/// Everything that is wrong with the file, a line each, with its place.
pub fn read(name: &str, bytes: &[u8]) -> Result<Description, String> {
    description::parse_for_servos(name, bytes, &servos()).map_err(|refused| {
        let lines = refused.diagnostics.iter().map(|fault| {
            let (line, column) = refused.source.line_column(fault.span.start);
            format!("{name}:{line}:{column}: {}\n", fault.message())
        });
        lines.collect()
    })
}

impl Described {
    /// Returns the robot of a description.
    ///
    /// # Errors
    /// It has no bus, or what a bus cannot drive or measure.
    pub fn new(description: &Description) -> Result<Self, NotOnBus> {
        let bus = description.bus().filter(|bus| !bus.drives.is_empty());
        let bus = bus.ok_or(NotOnBus::NoBus)?;
        let facts = description.facts();
        if facts.has_forces {
            return Err(NotOnBus::NoServo("forces"));
        }
        if facts.has_slider {
            return Err(NotOnBus::NoServo("slider"));
        }
        let joint = |drive: &description::Drive| {
            Some(Joint {
                id: drive.id,
                model: Model::named(&drive.model)?,
                sign: drive.sign,
                offset: drive.offset,
                gear: drive.gear,
                limits: drive.limits,
                speed: drive.speed,
                torque: drive.torque,
            })
        };
        // A description that was not read for these servos may name others.
        let joints: Option<Vec<Joint>> = bus.drives.iter().map(joint).collect();
        Ok(Described {
            joints: joints.ok_or(NotOnBus::NoBus)?,
            of_leg: facts.signature.joints.into(),
            initial: description.with_model(Initial),
            period: facts.period,
            distances: description.with_model(Bodies),
            bus: bus.clone(),
        })
    }

    /// Returns the name of a joint, such as "J11".
    pub fn name(&self, joint: usize) -> String {
        let of_leg = self.of_leg.max(1);
        let [leg, joint] = [joint / of_leg, joint % of_leg].map(|it| it as u8 + 1);
        Target::Joint(leg, joint).to_string()
    }

    /// Returns the names of joints and their servos, such as "J11 (servo 1)".
    pub fn names(&self, joints: &[usize]) -> Vec<String> {
        let name = |joint: &usize| {
            let id = self.joints.get(*joint).map_or(0, |joint| joint.id);
            format!("{} (servo {id})", self.name(*joint))
        };
        joints.iter().map(name).collect()
    }

    /// Returns the timing of its bus.
    pub fn timing(&self) -> Timing {
        Timing {
            baud: self.bus.baud,
            return_delay: 500,
            latency: (self.bus.latency * 1000.0) as u32,
        }
    }

    /// Returns the limits beyond which it is stopped.
    pub fn settings(&self) -> Settings {
        let description::Bus {
            silence,
            temperature,
            voltage,
            overload: [load, load_time],
            lag: [lag, lag_time],
            relaxes,
            together,
            stops_collisions,
            ..
        } = self.bus;
        let [at_end, in_emergency] =
            relaxes.map(|relaxes| if relaxes { Policy::Relax } else { Policy::Hold });
        Settings {
            silence,
            temperature,
            voltage,
            overload: (load, load_time),
            lag: (lag, lag_time),
            at_end,
            in_emergency,
            fast: together,
            stops_collisions,
            ..Settings::default()
        }
    }

    /// Returns the drives behind a port. A [`TorqueGuard`](crate::TorqueGuard) moves them.
    ///
    /// # Errors
    /// No robot can have such joints or settings.
    pub fn drives<P: Port>(&self, port: P) -> Result<Drives<P>, Invalid> {
        Drives::new(Bus::new(port, self.timing()), &self.joints, self.settings())
    }

    /// Returns simulated servos a little beside the initial posture.
    pub fn simulated(&self) -> SimulatedBus {
        let servos = self.joints.iter().zip(&self.initial).map(|(joint, angle)| {
            let angle = (angle + 5.0).min(joint.limits.max);
            Servo::new(joint.model, joint.id, joint.counts(angle).into())
        });
        SimulatedBus::new(servos.collect(), self.timing())
    }
}

/// Returns the distances between the parts of a robot.
struct Bodies;

impl WithModel for Bodies {
    type Output = Distances;

    fn with<const L: usize, const J: usize>(self, model: &model::Model<L, J>) -> Distances {
        Distances::new(model)
    }
}

/// Returns the initial posture.
struct Initial;

impl WithModel for Initial {
    type Output = Vec<f64>;

    fn with<const L: usize, const J: usize>(self, model: &model::Model<L, J>) -> Vec<f64> {
        model.legs.iter().flat_map(|leg| leg.initial).collect()
    }
}
