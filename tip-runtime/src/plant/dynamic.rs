//! A walking robot with mass: links and body swing, bounce, slide and tip over, deterministic to
//! the bit.
//!
//! The body floats, and every link is a uniform rod, the body a uniform box around its origin. Joints are position servos
//! with a lag, a speed and a torque limit, or give the torque that they are commanded. Feet, joints and corners of the
//! body touch the floor through springs and dampers, with Coulomb friction. Time goes on in steps of 0.5 ms or less,
//! by the semi-implicit Euler method.
//!
//! Inside of this module all values are in m, kg, s, rad and N.
//!
//! ```
//! use tip_runtime::model::titan8;
//! use tip_runtime::plant::DynamicPlant;
//!
//! // 12 kg of body and 2 kg a leg, on feet and belly.
//! let plant = DynamicPlant::new(&titan8::MODEL);
//! let on_feet: f64 = plant.feet().iter().map(|foot| foot.load).sum();
//! assert!((on_feet + plant.belly_load() - 20.0 * 9.80665).abs() < 1e-6);
//! ```

mod bump;
mod clash;
mod contact;
mod factor;
mod foothold;
mod frame;
mod leg;
mod links;
mod noise;
mod robot;
mod servo;
mod spatial;
mod terrain;
#[cfg(test)]
mod tests;
mod trunk;
mod watch;
mod world;

pub use servo::Drives;

use super::override_sensors::{LegInputs, Overrides};
use super::{DIVERGED, Fall, Following, Foot, Limbs, Motion, Noise, Plant, Pose, Travel};
use crate::command::Port;
use crate::fault::Fault;
use crate::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use crate::model::{Leg, Model, Point};
use crate::scene::Scene;
use contact::Law;
use leg::LegBody;
use nalgebra::Vector3;
use noise::Disturbance;
use robot::Robot;
use spatial::{Inertia, Spatial};
use terrain::Terrain;
use trunk::{Push, Trunk};
use watch::Watch;
use world::GRAVITY;

/// The velocity of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist {
    /// Velocity of the origin, in the world, mm/s.
    pub velocity: [f64; 3],
    /// Angular velocity about the axes of the world, deg/s.
    pub rate: [f64; 3],
}

/// The mechanical energy of a robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy {
    /// Kinetic energy of body, links and rotors, J.
    pub kinetic: f64,
    /// Potential energy of all masses above the world's origin, J.
    pub potential: f64,
}

/// The momentum of body and links, in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Momentum {
    /// Linear momentum, N·s.
    pub linear: [f64; 3],
    /// Angular momentum about the centre of mass, N·m·s.
    pub angular: [f64; 3],
}

/// A walking robot with mass.
///
/// The world frame has z up; the robot starts at its origin, heading along y, on its initial posture. See the
/// [module](self) for what is simulated.
#[derive(Clone, Debug)]
pub struct DynamicPlant<const L: usize, const J: usize> {
    robot: Robot<[LegBody<J>; L]>,
    overrides: Overrides<[LegInputs<J>; L]>,
    noise: Option<Disturbance>,
    lamps: [u32; 8],
}

impl<const L: usize, const J: usize> DynamicPlant<L, J> {
    /// Returns the robot in its initial posture on a level floor.
    pub fn new(model: &Model<L, J>) -> Self {
        let trunk = Trunk::new(model.body);
        let terrain = Terrain::of(&Scene::EMPTY);
        let forces = model.forces.as_ref();
        let mut plant = DynamicPlant {
            robot: Robot {
                watch: Watch::new(&trunk.frame, &terrain),
                trunk,
                terrain,
                law: Law::of(1.0, 1.0, 1.0),
                drives: Drives::default(),
                unit: forces.map_or(1.0, |forces| forces.unit.per_newton_metre()),
                period: model.standards.period,
                clearance: 0.0,
                following: Following::NONE,
                whole: Inertia::NONE,
                legs: [LegBody::new(Leg::BLANK); L],
            },
            overrides: Overrides::new(model),
            noise: None,
            lamps: [0; 8],
        };
        let robot = plant.robot_mut();
        robot.put(&model.legs);
        robot.stand();
        plant
    }

    /// Puts the robot on the floor of a scene.
    #[must_use]
    pub fn with_scene(mut self, scene: &Scene) -> Self {
        self.robot.terrain = Terrain::of(scene);
        self.robot_mut().stand();
        self
    }

    /// Replaces the motors of all joints.
    #[must_use]
    pub fn with_drives(mut self, drives: Drives) -> Self {
        self.robot.drives = drives;
        self.robot_mut().stand();
        self
    }

    /// Lifts the robot by `height` mm above its stand, before it is released.
    #[must_use]
    pub fn lifted(mut self, height: f64) -> Self {
        self.robot.trunk.frame.position.z += height / 1000.0;
        self.robot_mut().refresh();
        self
    }

    /// Sets the velocity of the body. A robot that is bolted down stays where it is.
    #[must_use]
    pub fn with_twist(mut self, twist: Twist) -> Self {
        if self.robot.trunk.model.is_some() {
            let frame = &mut self.robot.trunk.frame;
            frame.velocity = Vector::from(twist.velocity) / 1000.0;
            frame.rate = Vector::from(twist.rate.map(f64::to_radians));
        }
        self
    }

    /// Sets the angular velocities of the joints, deg/s.
    #[must_use]
    pub fn with_rates(mut self, rates: [[f64; J]; L]) -> Self {
        for (leg, rates) in self.robot.legs.iter_mut().zip(rates) {
            for (servo, rate) in leg.servos.iter_mut().zip(rates) {
                servo.rate = rate.to_radians();
            }
        }
        self
    }

    /// Returns the pose of the body in the world.
    pub fn body(&self) -> Pose {
        let frame = &self.robot.trunk.frame;
        Pose::new((frame.position * 1000.0).into(), &frame.rotation)
    }

    /// Returns the velocity of the body.
    pub fn twist(&self) -> Twist {
        let frame = &self.robot.trunk.frame;
        Twist {
            velocity: (frame.velocity * 1000.0).into(),
            rate: frame.rate.map(f64::to_degrees).into(),
        }
    }

    /// Returns the feet.
    pub fn feet(&self) -> [Foot; L] {
        let feet = self.robot.legs.each_ref().map(|leg| leg.foot);
        feet.map(|foot| Foot {
            position: (foot.place * 1000.0).into(),
            load: foot.load,
            slip: foot.slip * 1000.0,
        })
    }

    /// Returns the load that the body carries by itself, N.
    pub fn belly_load(&self) -> f64 {
        let trunk = &self.robot.trunk;
        trunk.loads.iter().sum::<f64>() + trunk.propped
    }

    /// Returns the centre of mass in the world, mm.
    pub fn centre_of_mass(&self) -> Point {
        let mut now = self.clone();
        now.robot_mut().refresh();
        now.centre().into()
    }

    /// Returns the centre of mass at the last placement, mm.
    fn centre(&self) -> Vector {
        (self.robot.trunk.frame.position + self.robot.whole.centre()) * 1000.0
    }

    /// Returns the kinetic and potential energy.
    pub fn energy(&self) -> Energy {
        let mut now = self.clone();
        let robot = now.robot_mut();
        robot.refresh();
        Energy {
            kinetic: robot.vigour() / 2.0,
            potential: robot.whole.mass() * GRAVITY * now.centre().z / 1000.0,
        }
    }

    /// Returns the momentum of body and links; rotors count in kinetic energy only.
    pub fn momentum(&self) -> Momentum {
        let mut now = self.clone();
        let robot = now.robot_mut();
        robot.refresh();
        let Spatial { angular, linear } = robot.momentum();
        Momentum {
            linear: linear.into(),
            angular: (angular - robot.whole.centre().cross(&linear)).into(),
        }
    }

    /// Returns the travel of the body from its start.
    pub fn travel(&self) -> Travel {
        self.robot.watch.travel(&self.robot.trunk.frame)
    }

    /// Returns the true joint angles, whatever the sensors read, deg.
    pub fn angles(&self) -> [[f64; J]; L] {
        let mut angles = [[0.0; J]; L];
        leg::fill_joints(&self.robot.legs, &mut angles, |servo| {
            servo.angle.to_degrees()
        });
        angles
    }

    /// Returns the angular velocities of the joints, deg/s.
    pub fn rates(&self) -> [[f64; J]; L] {
        let mut rates = [[0.0; J]; L];
        leg::fill_joints(&self.robot.legs, &mut rates, |servo| {
            servo.rate.to_degrees()
        });
        rates
    }

    /// Returns the motor torques, N·m.
    pub fn torques(&self) -> [[f64; J]; L] {
        let mut torques = [[0.0; J]; L];
        leg::fill_joints(&self.robot.legs, &mut torques, |servo| servo.torque);
        torques
    }

    /// Returns true if a lamp or relay is on.
    pub fn lamp(&self, device: u8) -> bool {
        let word = self.lamps.get(usize::from(device / 32));
        word.is_some_and(|word| word >> (device % 32) & 1 == 1)
    }

    fn robot_mut(&mut self) -> &mut Robot<[LegBody<J>]> {
        &mut self.robot
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for DynamicPlant<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        *into = Sensors::ZERO;
        let robot: &Robot<[LegBody<J>]> = &self.robot;
        let overrides: &Overrides<[LegInputs<J>]> = &self.overrides;
        let mut sensors = into.view_mut();
        robot.measure(&mut sensors);
        if let Some(noise) = &mut self.noise {
            noise.apply(&mut sensors);
        }
        overrides.apply(&mut sensors);
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.lamps = outputs.lamps;
        self.robot.period = outputs.period;
        let before = self.robot.clone();
        self.robot_mut().obey(&outputs.joints);
        if self.robot_mut().is_sane() {
            return Ok(());
        }
        self.robot = before;
        Err(DIVERGED)
    }

    fn stop(&mut self, _why: &Fault) {
        let before = self.robot.clone();
        self.robot_mut().hold();
        if !self.robot_mut().is_sane() {
            self.robot = before;
        }
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for DynamicPlant<L, J> {
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        let overrides: &mut Overrides<[LegInputs<J>]> = &mut self.overrides;
        overrides.set(port, volts)
    }

    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        self.robot.trunk.push = Push {
            force: Vector::from(force),
            cycles,
        };
        self.robot.trunk.model.is_some()
    }

    fn set_noise(&mut self, noise: Noise) -> bool {
        self.noise = Some(Disturbance::of(noise));
        true
    }

    fn motion(&self) -> Option<Motion> {
        let watch = &self.robot.watch;
        self.robot.trunk.model.is_some().then(|| Motion {
            pose: self.body(),
            travel: self.travel(),
            falls: watch.falls.count,
            upright_falls: watch.falls.upright(),
            margin: watch.margin,
            least_margin: watch.least,
            slip: watch.slip * 1000.0,
            following: self.robot.following,
            unmodelled: None,
        })
    }

    fn first_fall(&self) -> Option<Fall> {
        self.robot.watch.falls.first
    }

    fn limbs(&self) -> Option<Limbs<L, J>> {
        let is_loose = self.robot.trunk.model.is_some();
        let (mut loads, mut forces) = ([0.0; L], [[0.0; 3]; L]);
        leg::fill_feet(&self.robot.legs, &mut loads, &mut forces);
        Some(Limbs {
            angles: self.angles(),
            loads: is_loose.then_some(loads),
            forces: is_loose.then_some(forces),
            torques: self.torques(),
        })
    }
}

/// A vector in m, or without a unit.
type Vector = Vector3<f64>;
