//! The legs of a walking robot without mass: joints that follow their commands under load, their
//! links, and collisions of legs with each other, the body, blocks or the floor.

use super::events::{CycleEvents, Path, hurries};
use super::ground::GroundInterface;
use super::links::{LegLinks, Mass};
use super::pose::SINK_TOLERANCE;
use super::servo::{JointLoad, Servo, ServoDynamics, StepLimits};
use super::{Vector, support};
use crate::analog;
use crate::command::Port;
use crate::hardware::{JointCommand, SensorsMut};
use crate::model::Leg;
use crate::plant::GRAVITY;
use crate::plant::cuboid::Cuboid;
use crate::plant::self_collision::{Capsules, Gap, nearest, nowhere};

/// The longest time step, ms.
const LONGEST_STEP: f64 = 20.0;

/// A simulated leg and its servos.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegPlant<const J: usize> {
    model: Leg<J>,
    pub(super) servos: [Servo; J],
    pub(super) links: LegLinks<J>,
    pub(super) capsules: Capsules<J>,
    path: Path,
}

/// All legs: an array of them, or a slice, which holds all logic.
#[derive(Clone, Debug)]
pub(super) struct Legs<S: ?Sized> {
    pub(super) dynamics: ServoDynamics,
    /// The box of the body.
    pub(super) body: Option<Cuboid>,
    /// True if a leg is inside the floor or a block.
    pub(super) crosses: bool,
    pub(super) each: S,
}

impl<const J: usize> LegPlant<J> {
    /// Returns a leg in its initial posture.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn new(model: &Leg<J>) -> Self {
        LegPlant {
            model: *model,
            servos: model.initial.map(Servo::at),
            links: LegLinks::NOWHERE,
            capsules: Capsules::NONE,
            path: Path::NONE,
        }
    }

    /// Moves every joint under the load of its foot (N) and gravity; returns true if any turned.
    /// Joints that gave way under a body that `has_lost_hold` do not push their foot back before it has
    /// come down.
    fn drive(
        &mut self,
        commands: &[JointCommand; J],
        load: f64,
        (gravity, has_lost_hold): (Vector, bool),
        step: StepLimits,
    ) -> bool {
        let push = -gravity * load;
        let torques = self.links.load_torques(&self.model, push, gravity);
        let is_torque = |command: &JointCommand| matches!(command, JointCommand::Torque(_));
        let is_returning = self.servos.iter().any(Servo::is_returning);
        let lifts = if is_returning {
            self.links
                .levers(-gravity)
                .map(|lever| (GRAVITY * 1000.0 / lever).to_degrees())
        } else {
            [f64::INFINITY; J]
        };
        let stiffness = if load > 0.0 && commands.iter().any(is_torque) {
            self.links.stiffness(-gravity, support::STIFFNESS)
        } else {
            [0.0; J]
        };
        let is_free = load <= 0.0;
        let mut turned = false;
        let loads = torques.into_iter().zip(stiffness).zip(lifts);
        let joints = self.servos.iter_mut().zip(&self.model.joints);
        for (((servo, joint), command), ((torque, stiffness), lift)) in
            joints.zip(commands).zip(loads)
        {
            if servo.gave_way && has_lost_hold && is_free {
                continue;
            }
            let before = servo.angle;
            let load = JointLoad {
                torque,
                stiffness,
                lift,
            };
            servo.advance(joint, *command, load, step);
            turned |= servo.angle != before;
        }
        turned
    }
}

impl<const J: usize> Legs<[LegPlant<J>]> {
    /// Puts every leg in its initial posture.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn set_initial_postures(&mut self, models: &[Leg<J>]) {
        for (leg, model) in self.each.iter_mut().zip(models) {
            *leg = LegPlant::new(model);
        }
    }

    /// Simulates a control cycle of `period` ms.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn advance(
        &mut self,
        commands: &[[JointCommand; J]],
        period: f64,
        ground: &mut dyn GroundInterface,
    ) {
        let steps = libm::ceil(period / LONGEST_STEP).clamp(1.0, 1000.0);
        let dt = period / steps / 1000.0;
        let mut moved = false;
        for _ in 0..steps as u32 {
            let turned = self.drive(commands, dt, ground);
            // A body at rest on legs that have not moved keeps its pose, to the bit.
            if turned || !ground.is_at_rest() {
                self.settle(ground, dt);
                moved = true;
            }
            ground.judge(dt);
        }
        let events = self.events(commands, moved, ground);
        ground.close(&events);
    }

    /// Returns true if a joint is below the floor, or a leg or the body in a block.
    fn cross(&self, ground: &dyn GroundInterface) -> bool {
        let is_in_block = |leg: &LegPlant<J>| is_in_block(&leg.links, ground);
        if ground.has_blocks() && (ground.is_in_block() || self.each.iter().any(is_in_block)) {
            return true;
        }
        let mut legs = self.each.iter();
        legs.any(|leg| is_below_floor(&leg.links, ground))
    }

    /// Returns the least distance of two parts of the robot.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn gap(&self) -> Option<Gap> {
        let mut lines = nowhere();
        for (lines, leg) in lines.iter_mut().zip(&self.each) {
            for (line, link) in lines.iter_mut().zip(leg.links.lines()) {
                *line = link;
            }
        }
        let capsules = self.each.iter().map(|leg| &leg.capsules);
        nearest(self.body.as_ref(), capsules, &lines)
    }

    /// Returns the events of a cycle that no robot with mass shows.
    fn events(
        &mut self,
        commands: &[[JointCommand; J]],
        moved: bool,
        ground: &dyn GroundInterface,
    ) -> CycleEvents {
        if moved {
            self.crosses = self.cross(ground);
        }
        let speed = self.dynamics.speed;
        let mut events = CycleEvents {
            crosses: self.crosses,
            ..CycleEvents::default()
        };
        for (leg, commands) in self.each.iter_mut().zip(commands) {
            let stray = leg.path.stray(&leg.model, commands, leg.links.foot);
            events.hurries |= hurries(commands, speed);
            events.stray = events.stray.max(stray);
        }
        events
    }

    /// Moves every joint for `dt` s under its previous load; returns true if any turned.
    fn drive(
        &mut self,
        commands: &[[JointCommand; J]],
        dt: f64,
        ground: &mut dyn GroundInterface,
    ) -> bool {
        let gravity = (ground.down(), ground.has_lost_hold());
        let step = self.dynamics.within(dt);
        let legs = self.each.iter_mut().zip(ground.loads()).zip(commands);
        legs.fold(false, |turned, ((leg, load), commands)| {
            leg.drive(commands, *load, gravity, step) | turned
        })
    }

    /// Places every leg whose joints have turned, and lets the body come to rest on them within
    /// `dt` s.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn settle(&mut self, ground: &mut dyn GroundInterface, dt: f64) {
        for leg in &mut self.each {
            leg.links
                .place(&leg.model, leg.servos.map(|servo| servo.angle));
        }
        let mass = self.mass(ground.body_mass());
        for (foot, leg) in ground.feet().iter_mut().zip(&self.each) {
            *foot = leg.links.foot;
        }
        ground.settle(mass, dt);
    }

    /// Measures joints and soles.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn measure(&self, sensors: &mut SensorsMut<'_, J>, ground: &dyn GroundInterface) {
        let joints = sensors.angles.iter_mut().zip(sensors.torques.iter_mut());
        for ((angles, torques), leg) in joints.zip(&self.each) {
            *angles = leg.servos.map(|servo| servo.angle);
            *torques = leg.servos.map(|servo| servo.torque);
        }
        for (leg, load) in (1..).zip(ground.loads()) {
            let sole = Port::Paw(leg);
            sensors.inputs.set(sole, analog::volts_of_load(*load));
        }
    }

    /// Returns the mass of body (kg, kg·mm) and links.
    fn mass(&self, body: (f64, Vector)) -> Mass {
        let (mut mass, mut moment) = body;
        for leg in &self.each {
            for (joint, centre) in leg.model.joints.iter().zip(&leg.links.centres) {
                mass += joint.mass;
                moment += centre * joint.mass;
            }
        }
        Mass {
            centre: if mass > 0.0 { moment / mass } else { moment },
            weight: mass * GRAVITY,
        }
    }
}

/// Returns true if a joint of a leg is below the floor.
fn is_below_floor<const J: usize>(leg: &LegLinks<J>, ground: &dyn GroundInterface) -> bool {
    (leg.places().skip(1)).any(|joint| ground.height(joint) < -SINK_TOLERANCE)
}

/// Returns true if a leg is in a block.
pub(super) fn is_in_block<const J: usize>(leg: &LegLinks<J>, ground: &dyn GroundInterface) -> bool {
    leg.lines().any(|line| ground.is_segment_in_block(line))
}
