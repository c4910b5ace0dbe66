//! A walking robot on a floor, quasi-static and deterministic.
//!
//! Joints are position servos with a lag, a speed and a torque limit. The body rests on whatever
//! carries it, feet or belly, under gravity; it moves as its stance feet sweep. Nothing swings,
//! bounces or flies: inertia is left out on purpose, so that a run says what the motion program
//! does and not how a particular robot vibrates.

mod body;
mod contacts;
mod fall;
mod floor;
mod links;
mod polygon;
mod servo;
mod stance;
mod support;

pub use body::Pose;
pub use fall::Fall;
pub use floor::Floor;
pub use servo::ServoDynamics;

use super::override_sensors::Overrides;
use super::{Motion, Plant};
use crate::analog;
use crate::command::Port;
use crate::fault::Fault;
use crate::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
use crate::model::Model;
use body::Body;
use contacts::Contacts;
use fall::FallWatch;
use links::{LegLinks, Mass};
use nalgebra::Vector3;
use servo::{JointLoad, Servo};
use stance::Stance;
use support::{Load, Support};

/// The longest time that is simulated in one piece: ms.
const LONGEST_STEP: f64 = 20.0;

/// One foot of a simulated robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// Where it is in the world: mm.
    pub position: [f64; 3],
    /// How much of the robot it carries: N.
    pub load: f64,
    /// How far it has slipped along the floor since it touched down: mm; 0 in the air.
    pub slip: f64,
}

impl Foot {
    /// Whether it carries anything.
    pub fn touches(&self) -> bool {
        self.load > 0.0
    }
}

/// A walking robot on a floor.
///
/// The world frame has z up; the robot starts at its origin, heading along y, on its initial
/// posture. See the [module](self) for what is simulated and what is not.
#[derive(Clone, Debug)]
pub struct SimulatedPlant<const L: usize, const J: usize> {
    model: Model<L, J>,
    dynamics: ServoDynamics,
    floor: Floor,
    /// The direction of gravity in the floor's frame.
    gravity: Point,
    /// The same in the robot's frame, as the body lies now.
    down: Point,
    servos: [[Servo; J]; L],
    legs: [LegLinks<J>; L],
    mass: Mass,
    body: Body,
    at_rest: bool,
    loads: Contacts<f64, L>,
    stance: Stance<L>,
    falls: FallWatch,
    overrides: Overrides<L, J>,
    lamps: [u32; 8],
    /// Writings so far.
    cycle: u64,
}

impl<const L: usize, const J: usize> SimulatedPlant<L, J> {
    /// The robot in its initial posture on a level floor.
    pub fn new(model: &Model<L, J>) -> Self {
        let servos = model.legs.map(|leg| leg.initial.map(Servo::at));
        let mut legs = [LegLinks::NOWHERE; L];
        links::place(&mut legs, model, &servos);
        let mut plant = SimulatedPlant {
            model: *model,
            dynamics: ServoDynamics::default(),
            floor: Floor::LEVEL,
            gravity: Floor::LEVEL.gravity(),
            down: Point::zeros(),
            servos,
            legs,
            mass: links::mass(model, &legs),
            body: Body::standing(model.body.as_ref()),
            at_rest: false,
            loads: Contacts::new([0.0; L], [0.0; 4]),
            stance: Stance::new(),
            falls: FallWatch::new(),
            overrides: Overrides::new(),
            lamps: [0; 8],
            cycle: 0,
        };
        plant.settle();
        plant
    }

    /// Puts the robot on another floor.
    #[must_use]
    pub fn with_floor(mut self, floor: Floor) -> Self {
        self.floor = floor;
        self.gravity = floor.gravity();
        self.body = Body::standing(self.model.body.as_ref());
        self.stance = Stance::new();
        self.settle();
        self
    }

    /// Gives all joints other servos.
    #[must_use]
    pub fn with_servos(mut self, dynamics: ServoDynamics) -> Self {
        self.dynamics = dynamics;
        self
    }

    /// Feet that are no more than `lift` mm above the lowest one, along the body's z axis, count as
    /// standing when falls are watched (20 mm by default). A program that leans the body
    /// on purpose needs more.
    #[must_use]
    pub fn with_lift(mut self, lift: f64) -> Self {
        self.falls.lift = lift;
        self
    }

    /// Where the body is, in the world.
    pub fn body(&self) -> Pose {
        self.floor.pose(&self.body)
    }

    /// The feet.
    pub fn feet(&self) -> [Foot; L] {
        let mut leg = 0..L;
        self.legs.map(|links| {
            let leg = leg.next().unwrap_or(L);
            Foot {
                position: self.floor.point(self.body.point(links.foot)),
                load: self.loads.feet.get(leg).copied().unwrap_or(0.0),
                slip: self.stance.slip(leg),
            }
        })
    }

    /// Which feet carry anything.
    pub fn contacts(&self) -> [bool; L] {
        self.loads.feet.map(|load| load > 0.0)
    }

    /// The farthest that any foot has slipped on one stance so far: mm.
    pub fn worst_slip(&self) -> f64 {
        self.stance.worst()
    }

    /// How much the belly carries: N.
    pub fn belly_load(&self) -> f64 {
        self.loads.belly.iter().sum()
    }

    /// The centre of mass in the world: mm.
    pub fn centre_of_mass(&self) -> [f64; 3] {
        self.floor.point(self.body.point(self.mass.centre))
    }

    /// How far inside the support polygon the centre of mass is: mm; negative outside.
    pub fn margin(&self) -> f64 {
        self.falls.margin
    }

    /// How often the centre of mass left the support polygon.
    pub fn falls(&self) -> u32 {
        self.falls.count
    }

    /// The first of these falls.
    pub fn first_fall(&self) -> Option<Fall> {
        self.falls.first
    }

    /// Joint angles as they are, whatever the sensors say: deg.
    pub fn angles(&self) -> [[f64; J]; L] {
        let angles = |leg: &[Servo; J]| leg.each_ref().map(|servo| servo.angle);
        self.servos.each_ref().map(angles)
    }

    /// What the motors give: N·m.
    pub fn torques(&self) -> [[f64; J]; L] {
        let torques = |leg: &[Servo; J]| leg.each_ref().map(|servo| servo.torque);
        self.servos.each_ref().map(torques)
    }

    /// Whether a lamp or relay is on.
    pub fn lamp(&self, device: u8) -> bool {
        let word = self.lamps.get(usize::from(device / 32));
        word.is_some_and(|word| word >> (device % 32) & 1 == 1)
    }

    fn advance(&mut self, outputs: &Outputs<L, J>) {
        let steps = libm::ceil(outputs.period / LONGEST_STEP).clamp(1.0, 1000.0);
        for _ in 0..steps as u32 {
            let before = self.angles();
            self.drive(&outputs.joints, outputs.period / steps / 1000.0);
            // What lies still on unmoved legs stays as it is, to the bit.
            if self.angles() != before || !self.at_rest {
                self.settle();
            }
        }
    }

    /// Moves every joint for `dt` s under the load that it had.
    fn drive(&mut self, commands: &[[JointCommand; J]; L], dt: f64) {
        let gravity = self.down;
        let stride = self.dynamics.within(dt);
        let legs = self.servos.iter_mut().zip(&self.model.legs);
        let forces = self.legs.iter().zip(&self.loads.feet);
        for (((servos, leg), (links, load)), commands) in legs.zip(forces).zip(commands) {
            let push = -gravity * *load;
            let torques = links.load_torques(leg, push, gravity);
            let is_torque = |command: &JointCommand| matches!(command, JointCommand::Torque(_));
            let stiffness = if *load > 0.0 && commands.iter().any(is_torque) {
                links.stiffness(-gravity, support::STIFFNESS)
            } else {
                [0.0; J]
            };
            let loads = torques.into_iter().zip(stiffness);
            let joints = servos.iter_mut().zip(&leg.joints);
            for (((servo, joint), command), (torque, stiffness)) in joints.zip(commands).zip(loads)
            {
                let load = JointLoad { torque, stiffness };
                servo.advance(joint, *command, load, stride);
            }
        }
    }

    /// Lets the body come to rest on its contacts, and takes stance feet along.
    fn settle(&mut self) {
        links::place(&mut self.legs, &self.model, &self.servos);
        self.mass = links::mass(&self.model, &self.legs);
        let Some(body) = &self.model.body else {
            self.at_rest = true;
            self.down = self.body.rotation().inverse() * self.gravity;
            return;
        };
        let points = Contacts::of(body, &self.legs);
        let load = Load {
            centre: self.mass.centre,
            weight: self.mass.weight,
            gravity: self.gravity,
        };
        let Support {
            normal,
            height,
            found,
        } = support::rest(&points, &load, &self.body);
        self.at_rest = found;
        self.body.rest(normal, height);
        self.loads = support::loads(&points, normal, height);
        let rotation = self.stance.follow(&points, &self.loads, &mut self.body);
        self.down = rotation.inverse() * self.gravity;
        self.falls.watch(
            &points,
            &self.loads,
            self.mass.centre,
            self.down,
            self.cycle,
        );
    }

    fn paws(&self) -> [f64; L] {
        self.loads.feet.map(analog::volts_of_load)
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for SimulatedPlant<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        *into = Sensors {
            angles: self.angles(),
            torques: self.torques(),
            paws: self.paws(),
            ..Sensors::ZERO
        };
        self.overrides.apply(into);
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.lamps = outputs.lamps;
        self.advance(outputs);
        self.cycle += 1;
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) {
        // Servos hold where they are; without inertia nothing is left that could move.
        self.cycle += 1;
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for SimulatedPlant<L, J> {
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.overrides.set(&self.model, port, volts)
    }

    fn motion(&self) -> Option<Motion> {
        Some(Motion {
            pose: self.body(),
            falls: self.falls(),
            margin: self.margin(),
            slip: self.worst_slip(),
        })
    }
}

type Point = Vector3<f64>;
