//! Simulated hardware: a hand of planar fingers, a floor on a slider, and objects to grasp.
//!
//! Fingers are chains of rigid links with motors, objects are rigid bodies in the x–y plane, y
//! being the height. Where they overlap they push each other apart with springs, dampers and
//! Coulomb friction. Motion advances in even steps of at most 0.5 ms, by the method of Störmer and
//! Verlet (Hairer, Lubich and Wanner, *Geometric Numerical Integration*, 2006, ch. I.1), whose
//! error is of second order. Steps are shorter over light objects, whose contacts swing faster.
//!
//! A physics engine is not used on purpose. An engine such as rapier resolves contacts as
//! constraints, whose forces depend on its solver's iterations; here the reading of a torque sensor
//! follows from documented stiffnesses. An engine needs `alloc`, half a minute and fifty crates to
//! build; this module needs none of them, and gives the same bits on every machine.
//!
//! Links are lines and fingertips points, so that forces act exactly where kinematics has the
//! fingertip. Fingers have no weight, since they are counterbalanced, and do not collide with each
//! other: the fingers of one side are at different z.
//!
//! ```
//! use tip_runtime::model::hand;
//! use tip_runtime::plant::{Scene, SimulatedHand};
//!
//! // The floor is at −130 mm; the cylinder is 60 mm high and stands under the palm's middle.
//! let plant = SimulatedHand::new(&hand::MODEL).with_scene(&Scene::CYLINDER);
//! let cylinder = plant.objects()[0].expect("it is there");
//! let [x, y, _] = cylinder.position;
//! assert!(x.abs() < 1e-9 && (y + 100.0).abs() < 1e-9);
//!
//! let [left, right, _] = plant.fingertips();
//! assert!((left.position[0] + right.position[0]).abs() < 1e-9, "they oppose each other");
//! assert_eq!(left.on_objects, [0.0; 3]);
//! ```

mod contact;
mod contact_model;
mod finger;
mod grasped_object;
mod motor;
mod rigid_body;

use super::self_collision::{Gap, SelfCollision};
use super::sensors::{LegInputs, Overrides};
use super::{DIVERGED, Grasp, Limbs, Plant, is_lit};
use crate::command::Port;
use crate::fault::Fault;
use crate::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use crate::model::{Model, Point};
use crate::scene::{OBJECTS, Scene};
use contact_model::{ContactModel, FingerContacts};

/// A vector in SI units.
type Vector = nalgebra::Vector2<f64>;

/// A fingertip.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fingertip {
    /// Position, mm.
    pub position: Point,
    /// Force of the last link on the floor, N.
    pub on_floor: [f64; 3],
    /// Force of the last link on objects, N.
    pub on_objects: [f64; 3],
    /// The greatest force at the end of a cycle so far, N.
    pub greatest: f64,
}

impl Fingertip {
    /// Returns the force on floor and objects together, N.
    pub fn force(&self) -> f64 {
        let ([x, y, z], [u, v, w]) = (self.on_floor, self.on_objects);
        libm::hypot(libm::hypot(x + u, y + v), z + w)
    }
}

/// An object of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ObjectState {
    /// Position of the centre, mm; z is 0.
    pub position: Point,
    /// Angle, deg.
    pub angle: f64,
    /// Velocity of the centre, mm/s; 0 along z.
    pub velocity: [f64; 3],
    /// Angular velocity, deg/s.
    pub spin: f64,
    /// Height of the lowest point above the floor, mm.
    pub clearance: f64,
    /// The greatest clearance at the end of a cycle so far, mm.
    pub highest: f64,
    /// True if the object touches the floor.
    pub on_floor: bool,
    /// True if the object touches the palm.
    pub at_palm: bool,
}

/// A hand of `L` fingers with `J` joints over a floor. All joints turn about z.
///
/// The slider follows its command exactly, at its greatest speed (1 m/s). See the [module](self)
/// for what is simulated.
#[derive(Clone, Debug)]
pub struct SimulatedHand<const L: usize, const J: usize> {
    contacts: ContactModel<[FingerContacts<J>; L]>,
    bodies: SelfCollision<L, J>,
    overrides: Overrides<[LegInputs<J>; L]>,
    lamps: [u32; 8],
}

impl<const L: usize, const J: usize> SimulatedHand<L, J> {
    /// Returns the hand in its initial posture over an empty, level floor.
    pub fn new(model: &Model<L, J>) -> Self {
        SimulatedHand {
            contacts: ContactModel::new(model),
            bodies: SelfCollision::new(model),
            overrides: Overrides::new(model),
            lamps: [0; 8],
        }
    }

    /// Puts a floor and objects under the hand.
    #[must_use]
    pub fn with_scene(mut self, scene: &Scene) -> Self {
        self.contacts_mut().replace(scene);
        self
    }

    fn contacts_mut(&mut self) -> &mut ContactModel<[FingerContacts<J>]> {
        &mut self.contacts
    }

    /// Pulls finger `n`, counted from 1, at its tip with a force along x and y (N) from now on,
    /// like a hanging weight.
    pub fn pull(&mut self, n: u8, [x, y]: [f64; 2]) {
        let finger = self
            .contacts
            .fingers
            .get_mut(usize::from(n).wrapping_sub(1));
        if let Some(finger) = finger.filter(|_| x.is_finite() && y.is_finite()) {
            finger.pull = Vector::new(x, y);
        }
    }

    /// Returns the fingertips.
    pub fn fingertips(&self) -> [Fingertip; L] {
        self.contacts.fingers.each_ref().map(FingerContacts::tip)
    }

    /// Returns the true joint angles, whatever the sensors read, deg.
    pub fn angles(&self) -> [[f64; J]; L] {
        self.contacts.fingers.each_ref().map(FingerContacts::angles)
    }

    /// Returns the motor torques, in the robot's torque unit.
    pub fn torques(&self) -> [[f64; J]; L] {
        let unit = self.contacts.torque_unit;
        self.contacts
            .fingers
            .each_ref()
            .map(|finger| finger.torques(unit))
    }

    /// Returns the objects, in the order of the scene.
    pub fn objects(&self) -> [Option<ObjectState>; OBJECTS] {
        self.contacts.objects()
    }

    /// Returns true if a lamp or relay is on.
    pub fn lamp(&self, device: u8) -> bool {
        is_lit(&self.lamps, device)
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for SimulatedHand<L, J> {
    fn has_input(&self, port: Port) -> bool {
        let overrides: &Overrides<[LegInputs<J>]> = &self.overrides;
        overrides.has(port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        let overrides: &mut Overrides<[LegInputs<J>]> = &mut self.overrides;
        overrides.set(port, volts)
    }

    fn limbs(&self) -> Option<Limbs<L, J>> {
        Some(Limbs {
            angles: self.angles(),
            loads: Some(self.fingertips().map(|tip| tip.force())),
            forces: None,
            slips: None,
            torques: self.torques(),
        })
    }

    fn gap(&self) -> Option<Gap> {
        self.bodies.clearance(&self.angles())
    }

    fn grasp(&self) -> Option<Grasp<L>> {
        Some(Grasp {
            fingertips: self.fingertips(),
            objects: self.objects(),
            slider: self.contacts.slider(),
        })
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for SimulatedHand<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        *into = Sensors::ZERO;
        let contacts: &ContactModel<[FingerContacts<J>]> = &self.contacts;
        let overrides: &Overrides<[LegInputs<J>]> = &self.overrides;
        let mut sensors = into.view_mut();
        contacts.measure(&mut sensors);
        overrides.apply(&mut sensors);
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.lamps = outputs.lamps;
        let Outputs {
            joints,
            slider,
            period,
            ..
        } = outputs;
        let before = self.contacts.clone();
        self.contacts_mut().simulate(joints, *slider, *period);
        if self.contacts_mut().is_sane() {
            return Ok(());
        }
        self.contacts = before;
        Err(DIVERGED)
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        let before = self.contacts.clone();
        self.contacts_mut().stop();
        if self.contacts_mut().is_sane() {
            return Ok(());
        }
        self.contacts = before;
        Err(DIVERGED)
    }
}
