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

mod body_dynamics;
mod contact;
mod fall_detector;
mod leg;
mod leg_contact;
mod multibody;
mod servo;
mod spatial;
mod terrain;

pub use servo::Drives;

use super::self_collision::{self, Gap};
use super::sensors::{LegInputs, Overrides, SensorNoise};
use super::{
    ContactLaw, DIVERGED, Fall, Foot, GRAVITY, Limbs, Motion, Noise, Plant, Pose, TrackingErrors,
    Travel, fill_joints, is_lit,
};
use crate::command::Port;
use crate::fault::Fault;
use crate::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use crate::model::{Leg, Model, Point};
use crate::scene::Scene;
use body_dynamics::{BodyDynamics, ExternalForce};
use fall_detector::FallDetector;
use leg::LegBody;
use multibody::Multibody;
use nalgebra::Vector3;
use spatial::{Inertia, Spatial};
use terrain::Terrain;

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
    robot: Multibody<[LegBody<J>; L]>,
    overrides: Overrides<[LegInputs<J>; L]>,
    noise: Option<SensorNoise>,
    lamps: [u32; 8],
}

impl<const L: usize, const J: usize> DynamicPlant<L, J> {
    /// Returns the robot in its initial posture on a level floor.
    pub fn new(model: &Model<L, J>) -> Self {
        let base = BodyDynamics::new(model.body);
        let terrain = Terrain::of(&Scene::EMPTY);
        let forces = model.forces.as_ref();
        let mut plant = DynamicPlant {
            robot: Multibody {
                detector: FallDetector::new(&base.frame, &terrain),
                base,
                terrain,
                law: ContactLaw::of_robot(1.0, 1.0, 1.0),
                drives: Drives::default(),
                unit: forces.map_or(1.0, |forces| forces.unit.per_newton_metre()),
                period: model.standards.period,
                tracking_errors: TrackingErrors::NONE,
                total: Inertia::NONE,
                legs: [LegBody::new(Leg::BLANK); L],
            },
            overrides: Overrides::new(model),
            noise: None,
            lamps: [0; 8],
        };
        let robot = plant.robot_mut();
        robot.set_initial_postures(&model.legs);
        for (leg, capsules) in robot.legs.iter_mut().zip(self_collision::capsules(model)) {
            leg.capsules = capsules;
        }
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
        self.robot.base.frame.position.z += height / 1000.0;
        self.robot_mut().refresh();
        self
    }

    /// Sets the velocity of the body. A robot that is bolted down stays where it is.
    #[must_use]
    pub fn with_twist(mut self, twist: Twist) -> Self {
        if self.robot.base.model.is_some() {
            let frame = &mut self.robot.base.frame;
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
        let frame = &self.robot.base.frame;
        Pose::new((frame.position * 1000.0).into(), &frame.rotation)
    }

    /// Returns the velocity of the body.
    pub fn twist(&self) -> Twist {
        let frame = &self.robot.base.frame;
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
        let base = &self.robot.base;
        base.loads.iter().sum::<f64>() + base.edge_load
    }

    /// Returns the centre of mass in the world, mm.
    pub fn centre_of_mass(&self) -> Point {
        let mut now = self.clone();
        now.robot_mut().refresh();
        now.centre().into()
    }

    /// Returns the centre of mass at the last placement, mm.
    fn centre(&self) -> Vector {
        (self.robot.base.frame.position + self.robot.total.centre()) * 1000.0
    }

    /// Returns the kinetic and potential energy.
    pub fn energy(&self) -> Energy {
        let mut now = self.clone();
        let robot = now.robot_mut();
        robot.refresh();
        Energy {
            kinetic: robot.double_kinetic_energy() / 2.0,
            potential: robot.total.mass() * GRAVITY * now.centre().z / 1000.0,
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
            angular: (angular - robot.total.centre().cross(&linear)).into(),
        }
    }

    /// Returns the travel of the body from its start.
    pub fn travel(&self) -> Travel {
        self.robot.detector.travel(&self.robot.base.frame)
    }

    /// Returns the true joint angles, whatever the sensors read, deg.
    pub fn angles(&self) -> [[f64; J]; L] {
        let mut angles = [[0.0; J]; L];
        fill_joints(
            &self.robot.legs,
            |leg| &leg.servos,
            &mut angles,
            |servo| servo.angle.to_degrees(),
        );
        angles
    }

    /// Returns the angular velocities of the joints, deg/s.
    pub fn rates(&self) -> [[f64; J]; L] {
        let mut rates = [[0.0; J]; L];
        fill_joints(
            &self.robot.legs,
            |leg| &leg.servos,
            &mut rates,
            |servo| servo.rate.to_degrees(),
        );
        rates
    }

    /// Returns the motor torques, N·m.
    pub fn torques(&self) -> [[f64; J]; L] {
        let mut torques = [[0.0; J]; L];
        fill_joints(
            &self.robot.legs,
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

    fn robot_mut(&mut self) -> &mut Multibody<[LegBody<J>]> {
        &mut self.robot
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for DynamicPlant<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        *into = Sensors::ZERO;
        let robot: &Multibody<[LegBody<J>]> = &self.robot;
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
        self.robot_mut().simulate(&outputs.joints);
        if self.robot_mut().is_sane() {
            return Ok(());
        }
        self.robot = before;
        Err(DIVERGED)
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        let before = self.robot.clone();
        self.robot_mut().hold();
        if self.robot_mut().is_sane() {
            return Ok(());
        }
        self.robot = before;
        Err(DIVERGED)
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for DynamicPlant<L, J> {
    fn has_input(&self, port: Port) -> bool {
        let overrides: &Overrides<[LegInputs<J>]> = &self.overrides;
        overrides.has(port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        let overrides: &mut Overrides<[LegInputs<J>]> = &mut self.overrides;
        overrides.set(port, volts)
    }

    fn can_be_pushed(&self) -> bool {
        self.robot.base.model.is_some()
    }

    fn can_have_noise(&self) -> bool {
        true
    }

    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        self.robot.base.push = ExternalForce {
            force: Vector::from(force),
            cycles,
        };
        self.can_be_pushed()
    }

    fn set_noise(&mut self, noise: Noise) -> bool {
        self.noise = Some(SensorNoise::of(noise));
        true
    }

    fn motion(&self) -> Option<Motion> {
        let detector = &self.robot.detector;
        self.robot.base.model.is_some().then(|| Motion {
            pose: self.body(),
            travel: self.travel(),
            falls: detector.falls.count,
            upright_falls: detector.falls.upright(),
            margin: detector.margin,
            least_margin: detector.least,
            slip: detector.slip * 1000.0,
            tracking_errors: self.robot.tracking_errors,
            unmodelled: None,
        })
    }

    fn first_fall(&self) -> Option<Fall> {
        // A robot that is bolted down does not fall, whatever holds its feet.
        let falls = &self.robot.detector.falls;
        falls.first.filter(|_| self.can_be_pushed())
    }

    fn gap(&self) -> Option<Gap> {
        let robot: &Multibody<[LegBody<J>]> = &self.robot;
        robot.gap()
    }

    fn limbs(&self) -> Option<Limbs<L, J>> {
        let is_loose = self.robot.base.model.is_some();
        let (mut loads, mut forces) = ([0.0; L], [[0.0; 3]; L]);
        leg::fill_feet(&self.robot.legs, &mut loads, &mut forces);
        Some(Limbs {
            angles: self.angles(),
            loads: is_loose.then_some(loads),
            forces: is_loose.then_some(forces),
            slips: is_loose.then(|| self.feet().map(|foot| foot.slip)),
            torques: self.torques(),
        })
    }
}

/// A vector in m, or without a unit.
type Vector = Vector3<f64>;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plant::self_collision::Capsules;

    #[test]
    fn the_largest_robot_moves_in_sixteen_kilobytes() {
        // Its model, the pairs of its parts and its inputs do not change.
        let model = size_of::<[Leg<9>; 9]>();
        let inputs = size_of::<Overrides<[LegInputs<9>; 9]>>();
        let pairs = size_of::<[Capsules<9>; 9]>();
        let working = size_of::<DynamicPlant<9, 9>>() - model - inputs - pairs;
        assert!(working <= 16 * 1024, "{working}");
    }
}
