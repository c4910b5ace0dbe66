//! What a robot of some size is made of, ready to be simulated.

mod miss;

pub(crate) use miss::Miss;

use crate::desk::Desk;
use crate::echo::Echo;
use crate::engine::Engine;
use crate::native::Native;
use crate::outside::Outside;
use crate::plant::Plant;
use crate::rig::Rig;
use crate::shell::Shell;
use miss::Reach;
use tip_runtime::command::{Op, Port, Target};
use tip_runtime::kinematics::{Frame, frames};
use tip_runtime::machine::{Machine, Mismatch};
use tip_runtime::model::{self, Forces, Inverse, Joint, Leg, Model, Point, Slider, Standards};
use tip_runtime::plant::{self, DynamicPlant, Scene, SimulatedHand, SimulatedPlant, Simulation};

/// A model, and what simulates it, whatever its size.
pub(crate) trait Body {
    fn anatomy(&self) -> Anatomy;
    fn has_input(&self, around: &Around, port: Port) -> bool;
    /// How it and what is around it begin, if everything has mass.
    fn beginning(&self, around: &Around) -> Beginning;
    /// What a PTP or PTP_ANGLE to these numbers misses, if it does.
    fn miss(&self, op: Op, target: Target, values: &[f64]) -> Option<Miss>;
    fn start(&self, around: &Around, seats: Seats) -> Result<Box<dyn Shell>, Mismatch>;
}

/// What a robot has, whatever its size.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Anatomy {
    /// Its body, if it walks.
    pub body: Option<model::Body>,
    /// What it can do with torques and forces, if anything.
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
    /// Where each foot is in the initial posture: mm.
    pub feet: Vec<Point>,
}

/// A leg or finger: a serial chain of any number of joints.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Limb {
    /// The first joint in the robot frame: mm.
    pub base: Point,
    /// The joints from base to foot.
    pub joints: Vec<Joint>,
    /// The initial posture: deg.
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
    /// The frame of each link at these angles (deg), from base to foot.
    pub fn frames(&self, angles: &[f64]) -> Vec<Frame> {
        frames(self.base, &self.joints, angles).collect()
    }

    /// Where the foot is at these angles (deg), in the robot frame: mm.
    pub fn foot(&self, angles: &[f64]) -> Point {
        let last = frames(self.base, &self.joints, angles).zip(&self.joints);
        last.last()
            .map_or(self.base, |(frame, joint)| frame.point(joint.link))
    }
}

/// Where a robot and the objects around it are before the first control cycle.
pub(crate) struct Beginning {
    /// Of the body; `None` if it is bolted down.
    pub(crate) pose: Option<plant::Pose>,
    /// What a hand is to grasp, in the order of the scene; `None` of any other robot.
    pub(crate) objects: Option<[Option<plant::ObjectState>; plant::OBJECTS]>,
}

/// How a robot is simulated, and what is around it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Around {
    pub(crate) plant: Plant,
    pub(crate) scene: Scene,
}

/// What runs on a robot, whatever its size.
pub(crate) struct Seats {
    pub(crate) program: Engine,
    pub(crate) desk: Desk,
    pub(crate) special: Native,
    /// What simulates the robot in place of its own plant.
    pub(crate) outside: Option<Box<dyn Outside>>,
}

pub(crate) struct Sized<const L: usize, const J: usize> {
    model: &'static Model<L, J>,
    hardware: Hardware<L, J>,
}

enum Hardware<const L: usize, const J: usize> {
    Walker,
    /// Made where its size is known, so that only hands of that size are compiled.
    Hand(fn(&Model<L, J>, &Scene) -> Rig<L, J>),
    Own(Rig<L, J>),
}

impl<const L: usize, const J: usize> Sized<L, J> {
    pub(crate) fn walker(model: &'static Model<L, J>) -> Self {
        Sized {
            model,
            hardware: Hardware::Walker,
        }
    }

    pub(crate) fn hand(model: &'static Model<L, J>) -> Self {
        Sized {
            model,
            hardware: Hardware::Hand(|model, scene| {
                Rig::new(SimulatedHand::new(model).with_scene(scene))
            }),
        }
    }

    pub(crate) fn own(
        model: &'static Model<L, J>,
        plant: impl plant::Plant<L, J> + Clone + 'static,
    ) -> Self {
        Sized {
            model,
            hardware: Hardware::Own(Rig::new(plant)),
        }
    }

    fn rig(&self, Around { plant, scene }: &Around) -> Rig<L, J> {
        match (plant.walking(scene), &self.hardware) {
            (_, Hardware::Own(rig)) => rig.clone(),
            (None, _) => Rig::echo(Echo::new(self.model)),
            (Some(_), Hardware::Hand(make)) => make(self.model, scene),
            (Some(Simulation::QuasiStatic), Hardware::Walker) => {
                let plant = SimulatedPlant::new(self.model).with_floor(scene.floor);
                let plant = plant.with_friction(scene.friction);
                Rig::new(plant.with_blocks(scene.blocks))
            }
            (Some(Simulation::Dynamic), Hardware::Walker) => {
                Rig::new(DynamicPlant::new(self.model).with_scene(scene))
            }
        }
    }
}

impl<const L: usize, const J: usize> Body for Sized<L, J> {
    fn anatomy(&self) -> Anatomy {
        let (legs, feet) = limbs(&self.model.legs);
        Anatomy {
            body: self.model.body,
            forces: self.model.forces,
            inverse: self.model.inverse,
            joints: J,
            legs,
            slider: self.model.slider,
            standards: self.model.standards,
            feet,
        }
    }

    fn has_input(&self, around: &Around, port: Port) -> bool {
        plant::Plant::has_input(&self.rig(around), port)
    }

    fn beginning(&self, around: &Around) -> Beginning {
        let rig = self.rig(&Around {
            plant: Plant::Dynamic,
            ..*around
        });
        Beginning {
            pose: plant::Plant::motion(&rig).map(|motion| motion.pose),
            objects: plant::Plant::grasp(&rig).map(|grasp| grasp.objects),
        }
    }

    fn miss(&self, op: Op, target: Target, values: &[f64]) -> Option<Miss> {
        Reach::from(self.model).miss(op, target, values)
    }

    fn start(&self, around: &Around, seats: Seats) -> Result<Box<dyn Shell>, Mismatch> {
        let Seats {
            program,
            desk,
            special,
            outside,
        } = seats;
        let rig = outside.map_or_else(|| self.rig(around), Rig::outside);
        let machine = Machine::new(program, self.model, rig, desk, special)?;
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
