//! Models of any size: what a robot has, what it reaches, and the machine that it is in.

mod miss;

pub(crate) use miss::Miss;

use crate::dyn_machine::{DynMachine, NativeCommands};
use crate::event_console::EventConsole;
use crate::program_runner::ProgramRunner;
use crate::sim_hardware::{DynHardware, OfSize, SimHardware};
use miss::MovableParts;
use tip_runtime::command::{Op, Target};
use tip_runtime::kinematics::{Frame, frames};
use tip_runtime::machine::{Machine, Mismatch};
use tip_runtime::model::{Body, Forces, Inverse, Joint, Leg, Model, Point, Slider, Standards};
use tip_runtime::plant::{DynamicPlant, Scene, SimulatedPlant, Simulation};

/// The parts of a robot, whatever its size.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Anatomy {
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

/// A model of any size. Each size has its own; logic is outside.
pub(crate) trait DynModel: Send + Sync {
    fn anatomy(&self) -> Anatomy;
    /// Returns what a PTP or PTP_ANGLE to these numbers misses, if it does.
    fn miss(&self, op: Op, target: Target, values: &[f64]) -> Option<Miss>;
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
    fn anatomy(&self) -> Anatomy {
        let (legs, feet) = limbs(&self.legs);
        Anatomy {
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

    fn miss(&self, op: Op, target: Target, values: &[f64]) -> Option<Miss> {
        MovableParts::from(self).miss(op, target, values)
    }

    fn walker(&self, simulation: Simulation, scene: &Scene) -> Box<dyn DynHardware> {
        match simulation {
            Simulation::QuasiStatic => {
                let plant = SimulatedPlant::new(self).with_floor(scene.floor);
                let plant = plant.with_friction(scene.friction);
                OfSize::boxed(plant.with_blocks(scene.blocks))
            }
            Simulation::Dynamic => OfSize::boxed(DynamicPlant::new(self).with_scene(scene)),
        }
    }

    fn machine(
        &self,
        program: ProgramRunner,
        hardware: SimHardware,
        special: Box<dyn NativeCommands>,
    ) -> Result<Box<dyn DynMachine>, Mismatch> {
        let console = EventConsole::default();
        let machine = Machine::new(program, self, hardware, console, special)?;
        Ok(Box::new(machine))
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
