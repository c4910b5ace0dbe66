//! Models of any size: the parts of a robot, its reach, and its machine.

use crate::dyn_machine::{DynMachine, NativeCommands};
use crate::event_console::EventConsole;
use crate::program_runner::ProgramRunner;
use crate::sim_hardware::{DynHardware, OfSize, SimHardware};
use tip_runtime::command::{Op, Target};
use tip_runtime::kinematics::{
    Chain, Frame, LegPoint, first_beyond_limits, frames, inverse, inverse_from, nearest, search,
};
use tip_runtime::machine::{Machine, Mismatch};
use tip_runtime::model::{
    Body, Family, Forces, Inverse, Joint, Leg, Model, Point, Range, Slider, Standards,
};
use tip_runtime::plant::{
    Distances, DynamicPlant, Scene, SelfCollision, SimulatedPlant, Simulation,
};

/// The parts of a robot, whatever its size.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RobotDescription {
    /// Its body, if it walks.
    pub body: Option<Body>,
    /// Parameters of torques and forces, if it has any.
    pub forces: Option<Forces>,
    /// Its inverse kinematics.
    pub inverse: Inverse,
    /// Joints of each leg.
    pub joints: usize,
    /// Its legs or fingers, F1 first.
    pub legs: Vec<Limb>,
    /// The slider that carries the floor under a hand, if it has one.
    pub slider: Option<Slider>,
    /// Its parameters at program start.
    pub standards: Standards,
    /// Place of each foot in the initial posture, mm.
    pub feet: Vec<Point>,
}

/// A leg or finger: a serial chain of any number of joints.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Limb {
    /// Place of the first joint in the robot frame, mm.
    pub base: Point,
    /// The joints from base to foot.
    pub joints: Vec<Joint>,
    /// The initial posture, deg.
    pub initial: Vec<f64>,
}

impl<const J: usize> From<&Leg<J>> for Limb {
    fn from(leg: &Leg<J>) -> Self {
        Limb {
            base: leg.base,
            joints: leg.joints.to_vec(),
            initial: leg.initial.to_vec(),
        }
    }
}

impl Limb {
    /// Returns the frame of each link at these angles (deg), from base to foot.
    pub fn frames(&self, angles: &[f64]) -> Vec<Frame> {
        frames(self.base, &self.joints, angles).collect()
    }

    /// Returns the place of the foot at these angles, deg, in the robot frame, mm.
    pub fn foot(&self, angles: &[f64]) -> Point {
        let last = frames(self.base, &self.joints, angles).zip(&self.joints);
        last.last()
            .map_or(self.base, |(frame, joint)| frame.point(joint.link))
    }
}

/// A model of any size, without logic of its own.
pub(crate) trait DynModel: Send + Sync {
    fn description(&self) -> RobotDescription;
    /// Returns the miss of a PTP or PTP_ANGLE to these numbers, if it does not reach them. `limits` are the working
    /// limits of all joints, leg by leg, or empty for those of the model.
    fn miss(&self, op: Op, target: Target, values: &[f64], limits: &[Range]) -> Option<Miss>;
    /// Returns the joints that a PTP or PTP_ANGLE turns and their angles (deg) at its end, joint and leg from 0. `from` are the
    /// angles of all joints before it, leg by leg. Returns none for a target that is not reached, or whose end depends on
    /// the way there.
    fn turns(&self, op: Op, target: Target, values: &[f64], from: &[f64]) -> Vec<(usize, f64)>;
    /// Returns the distances between its parts.
    fn distances(&self) -> Distances;
    /// Returns true if two links, by leg and joint from 0, are compared in a search for collisions.
    fn compares(&self, one: (usize, usize), other: (usize, usize)) -> bool;
    /// Simulates the robot on its legs.
    fn walker(&self, simulation: Simulation, scene: &Scene) -> Box<dyn DynHardware>;
    /// Puts a program on the robot.
    fn machine(
        &self,
        program: ProgramRunner,
        hardware: SimHardware,
        special: Box<dyn NativeCommands>,
    ) -> Result<Box<dyn DynMachine>, Mismatch>;
}

impl<const L: usize, const J: usize> DynModel for Model<L, J> {
    fn description(&self) -> RobotDescription {
        let (legs, feet) = limbs(&self.legs);
        RobotDescription {
            body: self.body,
            forces: self.forces,
            inverse: self.inverse,
            joints: J,
            legs,
            slider: self.slider,
            standards: self.standards,
            feet,
        }
    }

    fn miss(&self, op: Op, target: Target, values: &[f64], limits: &[Range]) -> Option<Miss> {
        MovableParts::from(self).miss(op, target, values, limits)
    }

    fn turns(&self, op: Op, target: Target, values: &[f64], from: &[f64]) -> Vec<(usize, f64)> {
        MovableParts::from(self).turns(op, target, values, from)
    }

    fn distances(&self) -> Distances {
        Distances::new(self)
    }

    fn compares(&self, one: (usize, usize), other: (usize, usize)) -> bool {
        SelfCollision::new(self).compares(one, other)
    }

    fn walker(&self, simulation: Simulation, scene: &Scene) -> Box<dyn DynHardware> {
        match simulation {
            Simulation::QuasiStatic => OfSize::boxed(SimulatedPlant::new(self).with_scene(scene)),
            Simulation::Dynamic => OfSize::boxed(DynamicPlant::new(self).with_scene(scene)),
        }
    }

    fn machine(
        &self,
        program: ProgramRunner,
        hardware: SimHardware,
        special: Box<dyn NativeCommands>,
    ) -> Result<Box<dyn DynMachine>, Mismatch> {
        let machine = Machine::new(program, self, hardware)?;
        let machine = machine.with_console(EventConsole::default());
        Ok(Box::new(machine.with_special(special)))
    }
}

// Out of line, or it would be copied for each number of legs.
#[inline(never)]
fn limbs<const J: usize>(legs: &[Leg<J>]) -> (Vec<Limb>, Vec<Point>) {
    let legs: Vec<Limb> = legs.iter().map(Limb::from).collect();
    let feet = feet(&legs);
    (legs, feet)
}

fn feet(legs: &[Limb]) -> Vec<Point> {
    legs.iter().map(|leg| leg.foot(&leg.initial)).collect()
}

/// A target that is missed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Miss {
    /// A joint would have to turn beyond its limits.
    Turns {
        joint: Target,
        /// The angle beyond the limit, deg; negative below the lower one.
        by: f64,
        limits: Range,
        /// Index of the number of the command that turns the joint, if each number turns one joint.
        number: Option<usize>,
    },
    /// Gap between the end of the foot's path and the target, mm.
    Ends { by: f64 },
    /// The slider does not go so far.
    Slides { axis: &'static str, travel: Range },
}

/// Gap that the search may leave to a target within reach, mm.
const LEFT_OVER: f64 = 1.0;
/// Difference of angles that rounding explains, deg.
const ROUNDING: f64 = 1e-6;

/// The points and joints that commands move, of a model with any number of legs.
struct MovableParts<'a, const J: usize> {
    legs: &'a [Leg<J>],
    family: Family,
    inverse: Inverse,
    slider: Option<&'a Slider>,
}

impl<'a, const L: usize, const J: usize> From<&'a Model<L, J>> for MovableParts<'a, J> {
    fn from(model: &'a Model<L, J>) -> Self {
        MovableParts {
            legs: &model.legs,
            family: model.family,
            inverse: model.inverse,
            slider: model.slider.as_ref(),
        }
    }
}

impl<const J: usize> MovableParts<'_, J> {
    /// Returns the miss of a PTP or PTP_ANGLE, if it does not reach its target.
    #[inline(never)] // Else it is compiled for each number of legs.
    fn miss(&self, op: Op, target: Target, values: &[f64], limits: &[Range]) -> Option<Miss> {
        let leg = |n: u8| {
            let index = usize::from(n).checked_sub(1)?;
            let mut leg = *self.legs.get(index)?;
            let limits = limits.get(index * J..).unwrap_or_default();
            for (joint, limits) in leg.joints.iter_mut().zip(limits) {
                joint.limits = *limits;
            }
            Some(leg)
        };
        match (op, target) {
            (Op::PtpAngle, Target::Foot(n)) => angles(&leg(n)?, n, 0, values),
            (Op::PtpAngle, Target::Joint(n, m)) => {
                angles(&leg(n)?, n, usize::from(m).checked_sub(1)?, values)
            }
            (Op::Ptp, Target::Floor) => slider(self.slider?, values.try_into().ok()?),
            (Op::Ptp, Target::Foot(n)) => place(
                &leg(n)?,
                n,
                (self.inverse, LegPoint::Tip),
                values.try_into().ok()?,
            ),
            (Op::Ptp, Target::Joint(n, m)) if self.family == Family::Hand => {
                let point = LegPoint::Joint(usize::from(m).checked_sub(1)?);
                place(&leg(n)?, n, (self.inverse, point), values.try_into().ok()?)
            }
            _ => None,
        }
    }
}

impl<const J: usize> MovableParts<'_, J> {
    #[inline(never)] // Else it is compiled for each number of legs.
    fn turns(&self, op: Op, target: Target, values: &[f64], from: &[f64]) -> Vec<(usize, f64)> {
        if self.miss(op, target, values, &[]).is_some() {
            return Vec::new();
        }
        let found = match (op, target) {
            (Op::PtpAngle, Target::Foot(n)) => Some((n, 0, values.to_vec())),
            (Op::PtpAngle, Target::Joint(n, m)) => Some((n, usize::from(m) - 1, values.to_vec())),
            (Op::Ptp, Target::Foot(n)) => self.closed_form(n, values, from),
            _ => None,
        };
        found.map_or(Vec::new(), |(n, m, angles)| {
            let first = (usize::from(n) - 1) * J + m;
            (first..).zip(angles).collect()
        })
    }

    /// Returns the angles at the end of a PTP, if its leg has a closed form.
    fn closed_form(&self, n: u8, values: &[f64], from: &[f64]) -> Option<(u8, usize, Vec<f64>)> {
        let at = usize::from(n).checked_sub(1)?;
        let leg = self.legs.get(at).filter(|_| self.inverse.is_closed())?;
        let before = from.as_chunks::<J>().0.get(at)?;
        let angles = inverse_from(self.inverse, leg, before, values.try_into().ok()?)?;
        Some((n, 0, angles.to_vec()))
    }
}

/// Returns the first joint, from `first` on, that cannot turn so far.
fn angles<const J: usize>(leg: &Leg<J>, n: u8, first: usize, values: &[f64]) -> Option<Miss> {
    let joints = leg.joints.iter().enumerate().skip(first);
    joints
        .zip(values)
        .enumerate()
        .find_map(|(number, ((m, joint), angle))| {
            beyond(joint.limits, *angle).map(|by| Miss::Turns {
                joint: name(n, m),
                by,
                limits: joint.limits,
                number: Some(number),
            })
        })
}

/// Returns the excess of an angle over its limits; negative below them.
fn beyond(limits: Range, angle: f64) -> Option<f64> {
    let by = if angle > limits.max {
        angle - limits.max
    } else {
        angle - limits.min
    };
    (!limits.widened(ROUNDING).contains(angle)).then_some(by)
}

fn place<const J: usize>(
    leg: &Leg<J>,
    n: u8,
    (kind, point): (Inverse, LegPoint),
    target: Point,
) -> Option<Miss> {
    if kind.is_closed() {
        let Some(found) = inverse(kind, leg, target) else {
            return ends(leg, (kind, point), target, 0.0);
        };
        let m = first_beyond_limits(leg, &found)?;
        let limits = leg.joints[m].limits;
        return Some(Miss::Turns {
            joint: name(n, m),
            by: beyond(limits, found[m])?,
            limits,
            number: None,
        });
    }
    let target = kind.flat(target);
    match search(leg, point, target, kind.axes()) {
        Some(_) => None,
        None => ends(leg, (kind, point), target, LEFT_OVER),
    }
}

/// Returns the miss at the end of the point's motion, if it is not near its target.
fn ends<const J: usize>(
    leg: &Leg<J>,
    (kind, point): (Inverse, LegPoint),
    target: Point,
    near: f64,
) -> Option<Miss> {
    let angles = nearest(leg, &leg.initial, point, target, kind.axes())?;
    let there = Chain::new(leg, &angles).point(point)?;
    let there = kind.flat(there);
    let gap = there.iter().zip(target).map(|(a, b)| (a - b) * (a - b));
    let by = gap.sum::<f64>().sqrt();
    (by >= near).then_some(Miss::Ends { by })
}

fn slider(slider: &Slider, target: Point) -> Option<Miss> {
    let axes = ["x", "y", "z"].into_iter().zip(slider.travel).zip(target);
    let mut missed = axes.filter(|((_, travel), at)| !travel.contains(*at));
    missed
        .next()
        .map(|((axis, travel), _)| Miss::Slides { axis, travel })
}

fn name(n: u8, m: usize) -> Target {
    Target::Joint(n, u8::try_from(m + 1).unwrap_or(u8::MAX))
}
