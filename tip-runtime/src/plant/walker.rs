//! A walking robot on a floor, quasi-static and deterministic.
//!
//! Joints are position servos with a lag, a speed and a torque limit. The body rests on its feet or
//! its belly under gravity; it moves as its stance feet sweep. Nothing swings or bounces: inertia
//! is left out on purpose, so that a run shows the effect of the motion program and not the
//! vibrations of a particular robot. Falling bodies fall no faster than gravity accelerates them.
//! Cycles in which inertia, friction or contact would have mattered are counted: [`Unmodelled`].
//!
//! ```
//! use tip_runtime::model::titan8;
//! use tip_runtime::plant::SimulatedPlant;
//!
//! // 12 kg of body and 2 kg a leg, on feet and belly.
//! let plant = SimulatedPlant::new(&titan8::MODEL);
//! let on_feet: f64 = plant.feet().iter().map(|foot| foot.load).sum();
//! assert!((on_feet + plant.belly_load() - 20.0 * 9.80665).abs() < 1e-6);
//! assert!(plant.margin() > 0.0, "its centre of mass is above what carries it");
//! ```

pub(super) mod events;
pub(super) mod fall;
mod ground;
mod legs;
mod links;
mod pose;
mod servo;
mod stance;
mod support;

pub use events::{TrackingErrors, Unmodelled};
pub use fall::Fall;
pub use pose::{Pose, Travel};
pub use servo::ServoDynamics;

use super::self_collision::{self, Gap};
use super::sensors::{LegInputs, Overrides};
use super::{DIVERGED, Limbs, Motion, Plant, are_sane, fill_joints, is_lit};
use crate::command::Port;
use crate::fault::Fault;
use crate::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use crate::model::{Leg, Model, Point};
use crate::scene::Scene;
use ground::Ground;
use legs::{LegPlant, Legs};
use nalgebra::Vector3;
use pose::Obstacles;

/// One foot of a simulated robot.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Foot {
    /// Position in the world, mm.
    pub position: Point,
    /// The part of the robot's weight on this foot, N.
    pub load: f64,
    /// Slip along the floor since the touchdown, mm; 0 in the air.
    pub slip: f64,
}

impl Foot {
    /// Returns true if the foot carries load.
    pub fn touches(&self) -> bool {
        self.load > 0.0
    }
}

/// A walking robot on a floor, without mass.
///
/// The world frame has z up; the robot starts at its origin, heading along y, on its initial
/// posture. See the [module](self) for what is simulated and what is not.
#[derive(Clone, Debug)]
pub struct SimulatedPlant<const L: usize, const J: usize> {
    legs: Legs<[LegPlant<J>; L]>,
    ground: Ground<L>,
    overrides: Overrides<[LegInputs<J>; L]>,
    lamps: [u32; 8],
}

impl<const L: usize, const J: usize> SimulatedPlant<L, J> {
    /// Returns the robot in its initial posture on a level floor.
    pub fn new(model: &Model<L, J>) -> Self {
        let mut plant = SimulatedPlant {
            legs: Legs {
                dynamics: ServoDynamics::default(),
                body: self_collision::body(model.body.as_ref()),
                crosses: false,
                each: [LegPlant::new(Leg::BLANK); L],
            },
            ground: Ground::new(model.body),
            overrides: Overrides::new(model),
            lamps: [0; 8],
        };
        let legs: &mut Legs<[LegPlant<J>]> = &mut plant.legs;
        legs.set_initial_postures(&model.legs);
        for (leg, capsules) in legs.each.iter_mut().zip(self_collision::capsules(model)) {
            leg.capsules = capsules;
        }
        plant.settle();
        plant
    }

    /// Puts the robot on the floor of a scene. The robot goes through blocks, and its feet stay where they are;
    /// cycles in which it meets a block, or friction would not have held the feet, are [counted](Self::unmodelled).
    #[must_use]
    pub fn with_scene(mut self, scene: &Scene) -> Self {
        self.ground.replace(scene.floor);
        self.settle();
        self.ground.unmodelled.friction = scene.friction;
        self.ground.begin();
        self.ground.obstacles = Obstacles(scene.blocks);
        self
    }

    /// Replaces the servos of all joints.
    #[must_use]
    pub fn with_servos(mut self, dynamics: ServoDynamics) -> Self {
        self.legs.dynamics = dynamics;
        self
    }

    /// Returns the pose of the body in the world.
    pub fn body(&self) -> Pose {
        self.ground.floor.pose(&self.ground.body)
    }

    /// Returns the feet.
    pub fn feet(&self) -> [Foot; L] {
        let ground = &self.ground;
        let mut leg = 0..L;
        self.legs.each.each_ref().map(|LegPlant { links, .. }| {
            let leg = leg.next().unwrap_or(L);
            Foot {
                position: ground.floor.point(ground.body.point(links.foot)),
                load: ground.loads.feet.get(leg).copied().unwrap_or(0.0),
                slip: ground.stance.slip(leg),
            }
        })
    }

    /// Returns true for each foot that carries load.
    pub fn contacts(&self) -> [bool; L] {
        self.ground.loads.feet.map(|load| load > 0.0)
    }

    /// Returns the greatest slip of a foot in one stance so far, mm.
    pub fn worst_slip(&self) -> f64 {
        self.ground.stance.worst()
    }

    /// Returns the load of the belly, N.
    pub fn belly_load(&self) -> f64 {
        self.ground.loads.belly.iter().sum()
    }

    /// Returns the centre of mass in the world, mm.
    pub fn centre_of_mass(&self) -> Point {
        let centre = self.ground.body.point(self.ground.mass.centre);
        self.ground.floor.point(centre)
    }

    /// Returns the distance of the centre of mass from the edge of the support polygon, mm;
    /// negative outside.
    pub fn margin(&self) -> f64 {
        self.ground.falls.margin
    }

    /// Returns the number of falls; most of those without mass leave the body upright.
    pub fn falls(&self) -> u32 {
        self.ground.falls.falls.count
    }

    /// Returns the counts of effects that mass would have had.
    pub fn unmodelled(&self) -> Unmodelled {
        self.ground.unmodelled.counted
    }

    /// Returns the counts of commands that joints and feet could not follow.
    pub fn tracking_errors(&self) -> TrackingErrors {
        self.ground.unmodelled.tracking_errors
    }

    /// Returns the travel of the body from its start.
    pub fn travel(&self) -> Travel {
        self.ground
            .start
            .travel(&self.ground.floor, &self.ground.body)
    }

    /// Returns the first fall.
    pub fn first_fall(&self) -> Option<Fall> {
        self.ground.falls.falls.first
    }

    /// Returns the true joint angles, whatever the sensors read, deg.
    pub fn angles(&self) -> [[f64; J]; L] {
        let mut angles = [[0.0; J]; L];
        fill_joints(
            &self.legs.each,
            |leg| &leg.servos,
            &mut angles,
            |servo| servo.angle,
        );
        angles
    }

    /// Returns the motor torques, N·m.
    pub fn torques(&self) -> [[f64; J]; L] {
        let mut torques = [[0.0; J]; L];
        fill_joints(
            &self.legs.each,
            |leg| &leg.servos,
            &mut torques,
            |servo| servo.torque,
        );
        torques
    }

    /// Returns true if a lamp or relay is on.
    pub fn lamp(&self, device: u8) -> bool {
        is_lit(&self.lamps, device)
    }

    fn settle(&mut self) {
        let legs: &mut Legs<[LegPlant<J>]> = &mut self.legs;
        legs.settle(&mut self.ground, 0.0);
        self.ground.begin();
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for SimulatedPlant<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        *into = Sensors::ZERO;
        let legs: &Legs<[LegPlant<J>]> = &self.legs;
        let overrides: &Overrides<[LegInputs<J>]> = &self.overrides;
        let mut sensors = into.view_mut();
        legs.measure(&mut sensors, &self.ground);
        overrides.apply(&mut sensors);
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.lamps = outputs.lamps;
        let legs: &mut Legs<[LegPlant<J>]> = &mut self.legs;
        legs.advance(&outputs.joints, outputs.period, &mut self.ground);
        self.ground.cycle += 1;
        match are_sane(self.body().position.into_iter()) {
            true => Ok(()),
            false => Err(DIVERGED),
        }
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        // Servos hold where they are; without inertia nothing is left that could move.
        self.ground.cycle += 1;
        Ok(())
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for SimulatedPlant<L, J> {
    fn has_input(&self, port: Port) -> bool {
        let overrides: &Overrides<[LegInputs<J>]> = &self.overrides;
        overrides.has(port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        let overrides: &mut Overrides<[LegInputs<J>]> = &mut self.overrides;
        overrides.set(port, volts)
    }

    fn motion(&self) -> Option<Motion> {
        // A robot that is bolted down has no body that moves.
        self.ground.is_loose().then(|| Motion {
            pose: self.body(),
            travel: self.travel(),
            falls: self.falls(),
            upright_falls: self.ground.falls.falls.upright(),
            margin: self.margin(),
            least_margin: self.ground.falls.least,
            slip: self.worst_slip(),
            tracking_errors: self.tracking_errors(),
            unmodelled: Some(self.unmodelled()),
        })
    }

    fn first_fall(&self) -> Option<Fall> {
        self.first_fall()
    }

    fn gap(&self) -> Option<Gap> {
        let legs: &Legs<[LegPlant<J>]> = &self.legs;
        legs.gap()
    }

    fn limbs(&self) -> Option<Limbs<L, J>> {
        Some(Limbs {
            angles: self.angles(),
            loads: self.ground.is_loose().then_some(self.ground.loads.feet),
            forces: None,
            slips: self
                .ground
                .is_loose()
                .then(|| self.feet().map(|foot| foot.slip)),
            torques: self.torques(),
        })
    }
}

/// A vector in mm, or without a unit.
type Vector = Vector3<f64>;
