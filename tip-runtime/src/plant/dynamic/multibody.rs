//! The robot as a multibody system: its equations of motion and their integration.

use super::body_dynamics::{BodyDynamics, rise_over_blocks};
use super::fall_detector::FallDetector;
use super::leg::LegBody;
use super::leg_contact::push_legs_apart;
use super::servo::{Drives, TimeStep};
use super::spatial::{CholeskyFactor, Contribution, Inertia, MovingFrame, Spatial};
use super::terrain::{StepContext, Terrain};
use crate::analog;
use crate::command::{MAX, Port};
use crate::hardware::{JointCommand, SensorsMut};
use crate::kinematics::frames;
use crate::model::Leg;
use crate::plant::self_collision::{self, Gap, nearest, nowhere};
use crate::plant::walker::events::hurries;
use crate::plant::{ContactLaw, GRAVITY, TrackingErrors, are_sane};

/// The longest step: s.
const MAX_STEP: f64 = 5e-4;
/// Maximum number of steps in a cycle.
const MAX_STEPS: f64 = 4000.0;
/// Maximum number of repetitions of a step because a motor saturates or is released.
const ANEW: u32 = 4;
/// Height above the lowest contact up to which contacts carry the robot at first, m.
const LEVEL: f64 = 1e-3;

/// Body and legs: an array of legs, or a slice, which holds all logic.
#[derive(Clone, Debug)]
pub(super) struct Multibody<S: ?Sized> {
    pub(super) base: BodyDynamics,
    pub(super) terrain: Terrain,
    pub(super) law: ContactLaw,
    pub(super) drives: Drives,
    /// Number of the robot's torque units in one N·m.
    pub(super) unit: f64,
    /// The sampling time: ms.
    pub(super) period: f64,
    /// The inertia of the whole robot at the last step.
    pub(super) total: Inertia,
    pub(super) detector: FallDetector,
    pub(super) tracking_errors: TrackingErrors,
    pub(super) legs: S,
}

impl<const J: usize> Multibody<[LegBody<J>]> {
    /// Puts every leg in its initial posture.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn set_initial_postures(&mut self, models: &[Leg<J>]) {
        for (leg, model) in self.legs.iter_mut().zip(models) {
            *leg = LegBody::new(model);
        }
    }

    /// Places the robot at the world's origin, as deep in the floor as its lowest contacts carry
    /// it.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn stand(&mut self) {
        let mass = self.base.mass() + self.legs.iter().map(LegBody::mass).sum::<f64>();
        let feet = self.legs.iter().map(|leg| leg.foot_mass(&self.drives));
        self.law = ContactLaw::of_robot(mass, feet.fold(f64::INFINITY, f64::min), MAX_STEP);
        let normal = self.terrain.normal;
        self.base = BodyDynamics::new(self.base.model);
        self.base.frame.rotation = self.terrain.tilt();
        self.base.frame.position = self.terrain.origin();
        if self.base.model.is_some() {
            let heights = self.legs.iter().flat_map(ends);
            let heights = heights.chain(self.base.corners().map(|corner| corner.z));
            let lowest = heights.clone().fold(f64::INFINITY, f64::min);
            let carriers = heights.filter(|height| *height <= lowest + LEVEL).count();
            let weight = mass * GRAVITY * normal.z;
            let depth = weight / (self.law.stiffness * carriers.max(1) as f64);
            self.base.frame.position -= normal * (lowest + depth);
        }
        let rise = self.rise();
        self.base.frame.position.z += rise;
        self.legs.iter_mut().for_each(LegBody::clear_contacts);
        self.refresh();
        self.detector = FallDetector::new(&self.base.frame, &self.terrain);
        self.update(0.0);
        self.detector.begin();
    }

    /// Returns the depth of the robot in the blocks on the floor, m.
    fn rise(&mut self) -> f64 {
        self.refresh();
        let frame = &self.base.frame;
        let terrain = &self.terrain;
        let legs = self.legs.iter();
        let links = legs.flat_map(|leg| (0..J).filter_map(|j| leg.link(j, frame)));
        let links = links.map(|link| terrain.rise(link.map(|place| frame.position + place)));
        let body = self.base.extent();
        let body = body.map_or(0.0, |extent| rise_over_blocks(&extent, frame, terrain));
        links.fold(body, f64::max)
    }

    /// Simulates a control cycle with commands.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn simulate(&mut self, commands: &[[JointCommand; J]]) {
        for (leg, commands) in self.legs.iter_mut().zip(commands) {
            leg.command(commands, self.unit);
        }
        self.cycle(commands);
        let speed = self.drives.servos.speed;
        let mut is_too_fast = false;
        let mut stray = 0.0_f64;
        for (leg, commands) in self.legs.iter_mut().zip(commands) {
            is_too_fast |= hurries(commands, speed);
            stray = stray.max(leg.stray(commands));
        }
        self.tracking_errors.count(is_too_fast, stray);
    }

    /// Returns true if all positions and speeds are valid.
    pub(super) fn is_sane(&self) -> bool {
        let MovingFrame {
            position,
            velocity,
            rate,
            rotation,
        } = &self.base.frame;
        let body = [position, velocity, rate].into_iter();
        let body = body.flat_map(|vector| vector.iter().copied());
        let joints = self.legs.iter().flat_map(|leg| &leg.servos);
        let joints = joints.flat_map(|servo| [servo.angle, servo.rate, servo.torque]);
        are_sane(body.chain(rotation.matrix().iter().copied()).chain(joints))
    }

    /// Simulates a control cycle in which every joint is held.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn hold(&mut self) {
        for leg in &mut self.legs {
            leg.hold();
        }
        self.cycle(&[]);
    }

    /// Simulates a control cycle; legs without commands are held.
    fn cycle(&mut self, commands: &[[JointCommand; J]]) {
        let time = self.period / 1000.0;
        let steps = libm::ceil(time / MAX_STEP).clamp(1.0, MAX_STEPS) as u32;
        let step = TimeStep::of(time / f64::from(steps), &self.drives.servos);
        for left in (1..=steps).rev() {
            self.step(&step, commands, f64::from(left));
        }
        self.base.push.count_cycle();
        self.update(self.period);
        self.detector.cycle += 1;
    }

    /// Returns the least distance of two parts of the robot.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn gap(&self) -> Option<Gap> {
        let inverse = self.base.frame.rotation.inverse();
        let mut lines = nowhere();
        for (lines, leg) in lines.iter_mut().zip(&self.legs) {
            for (j, line) in lines.iter_mut().enumerate() {
                if let Some(link) = leg.link(j, &self.base.frame) {
                    *line = link.map(|end| inverse * end * 1000.0);
                }
            }
        }
        let body = self_collision::body(self.base.model.as_ref());
        let capsules = self.legs.iter().map(|leg| &leg.capsules);
        nearest(body.as_ref(), capsules, &lines)
    }

    /// Integrates one of the steps that are `left` of a cycle (semi-implicit Euler method).
    fn step(&mut self, step: &TimeStep, commands: &[[JointCommand; J]], left: f64) {
        let frame = self.base.frame;
        let Multibody {
            base,
            terrain,
            law,
            drives,
            total,
            legs,
            ..
        } = self;
        let context = StepContext {
            frame: &frame,
            drives,
            law,
            terrain: base.model.is_some().then_some(&*terrain),
            step,
        };
        let mut share = base.place(&context);
        for (i, leg) in legs.iter_mut().enumerate() {
            share.add(leg.place(&context));
            leg.aim(&context, commands.get(i), left);
        }
        push_legs_apart(legs, &frame, law);
        *total = share.inertia;
        let is_loose = base.model.is_some();
        let mut body = [0.0; 6];
        let mut turns = [[0.0; J]; MAX];
        for _ in 0..=ANEW {
            if is_loose {
                body = acceleration(&share, legs, &context);
            }
            let mut changes = false;
            for (leg, turns) in legs.iter_mut().zip(&mut turns) {
                changes |= leg.saturate(&context, &body, turns);
            }
            if !changes {
                break;
            }
        }
        for (leg, turns) in legs.iter_mut().zip(&turns) {
            leg.advance(&context, turns);
        }
        base.advance(body, step.dt);
    }

    /// Updates positions and contacts, without moving.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn refresh(&mut self) {
        let frame = self.base.frame;
        let step = TimeStep::of(0.0, &self.drives.servos);
        let context = StepContext {
            frame: &frame,
            drives: &self.drives,
            law: &self.law,
            terrain: self.base.model.is_some().then_some(&self.terrain),
            step: &step,
        };
        let mut share = self.base.place(&context);
        for leg in &mut self.legs {
            share.add(leg.place(&context));
        }
        self.total = share.inertia;
    }

    /// Updates the fall detector.
    fn update(&mut self, period: f64) {
        let feet = self.legs.iter().map(|leg| &leg.foot);
        self.detector
            .update(period, &self.base, &self.terrain, self.total.centre(), feet);
    }

    /// Measures joints and soles.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn measure(&self, sensors: &mut SensorsMut<'_, J>) {
        let joints = sensors.angles.iter_mut().zip(sensors.torques.iter_mut());
        for ((angles, torques), leg) in joints.zip(&self.legs) {
            *angles = leg.servos.map(|servo| servo.angle.to_degrees());
            *torques = leg.servos.map(|servo| servo.torque * self.unit);
        }
        for (number, leg) in (1..).zip(&self.legs) {
            let volts = analog::volts_of_load(leg.foot.load);
            sensors.inputs.set(Port::Paw(number), volts);
        }
    }

    /// Returns twice the kinetic energy, J.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn double_kinetic_energy(&self) -> f64 {
        let twist = self.base.frame.twist();
        let legs = self
            .legs
            .iter()
            .map(|leg| leg.double_kinetic_energy(&twist, &self.drives));
        twist.dot(&self.total.momentum(&twist)) + legs.sum::<f64>()
    }

    /// Returns the momentum about the body's origin.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn momentum(&self) -> Spatial {
        let own = self.total.momentum(&self.base.frame.twist());
        let legs = self.legs.iter().map(LegBody::momentum);
        legs.fold(own, |sum, leg| sum + leg)
    }
}

/// Returns the acceleration of the body, angular first, after the elimination of its legs.
fn acceleration<const J: usize>(
    share: &Contribution,
    legs: &[LegBody<J>],
    context: &StepContext<'_>,
) -> [f64; 6] {
    let mut matrix = share.inertia.matrix();
    let mut forces = share.force.entries().map(|force| -force);
    for leg in legs {
        leg.eliminate(context, &mut matrix, &mut forces);
    }
    CholeskyFactor::of(matrix).map_or([0.0; 6], |factor| factor.solve(forces))
}

/// Iterates over the heights of the ends of a leg's links in the robot's frame, m.
fn ends<const J: usize>(leg: &LegBody<J>) -> impl Iterator<Item = f64> + Clone + '_ {
    let mut heights = [0.0; J];
    let angles = leg.servos.map(|servo| servo.angle.to_degrees());
    let joints = &leg.model.joints;
    let frames = frames(leg.model.base, joints, &angles).zip(joints);
    for (height, (frame, joint)) in heights.iter_mut().zip(frames) {
        let [_, _, z] = frame.point(joint.link);
        *height = z / 1000.0;
    }
    heights.into_iter()
}
