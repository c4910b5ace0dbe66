//! The legs of a walking robot without mass: joints that follow their commands under load, their
//! links, and collisions of legs with other legs, blocks or the floor.

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

/// The longest time step, ms.
const LONGEST_STEP: f64 = 20.0;

/// One leg.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegPlant<const J: usize> {
    model: Leg<J>,
    pub(super) servos: [Servo; J],
    pub(super) links: LegLinks<J>,
    /// Length along the links from base to foot, mm.
    length: f64,
    path: Path,
}

/// All legs: an array of them, or a slice, which holds all logic.
#[derive(Clone, Debug)]
pub(super) struct Legs<S: ?Sized> {
    pub(super) dynamics: ServoDynamics,
    /// True if a leg is inside another one, or the floor.
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
            length: (model.joints.iter())
                .map(|joint| Vector::from(joint.link).norm())
                .sum(),
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
        let stiffness = if load > 0.0 && commands.iter().any(is_torque) {
            self.links.stiffness(-gravity, support::STIFFNESS)
        } else {
            [0.0; J]
        };
        let is_free = load <= 0.0;
        let mut turned = false;
        let loads = torques.into_iter().zip(stiffness);
        let joints = self.servos.iter_mut().zip(&self.model.joints);
        for (((servo, joint), command), (torque, stiffness)) in joints.zip(commands).zip(loads) {
            if servo.gave_way && has_lost_hold && is_free {
                continue;
            }
            let before = servo.angle;
            let load = JointLoad { torque, stiffness };
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
            // What lies still on unmoved legs stays as it is, to the bit.
            if turned || !ground.is_at_rest() {
                self.settle(ground, dt);
                moved = true;
            }
            ground.judge(dt);
        }
        let events = self.events(commands, moved, ground);
        ground.close(&events);
    }

    /// Returns true if a joint is below the floor, a leg or the body in a block, or a leg in
    /// another one.
    fn cross(&self, ground: &dyn GroundInterface) -> bool {
        let is_in_block = |leg: &LegPlant<J>| is_in_block(&leg.links, ground);
        if ground.has_blocks() && (ground.is_in_block() || self.each.iter().any(is_in_block)) {
            return true;
        }
        let mut after = &self.each;
        while let Some((leg, others)) = after.split_first() {
            let touches = |other: &LegPlant<J>| {
                let length = (leg.length + other.length) / 2.0;
                touch(&leg.links, &other.links, length)
            };
            if is_below_floor(&leg.links, ground) || others.iter().any(touches) {
                return true;
            }
            after = others;
        }
        false
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

/// Thickness of a leg, as a share of its length.
const THICK: f64 = 0.04;

/// Returns true if a joint of a leg is below the floor.
fn is_below_floor<const J: usize>(leg: &LegLinks<J>, ground: &dyn GroundInterface) -> bool {
    (leg.places().skip(1)).any(|joint| ground.height(joint) < -SINK_TOLERANCE)
}

/// Returns true if a leg is in a block.
pub(super) fn is_in_block<const J: usize>(leg: &LegLinks<J>, ground: &dyn GroundInterface) -> bool {
    leg.lines().any(|line| ground.is_segment_in_block(line))
}

/// Returns true if a leg goes through another one, both of this length (mm). Their first links are
/// part of the body.
pub(super) fn touch<const J: usize>(a: &LegLinks<J>, b: &LegLinks<J>, length: f64) -> bool {
    let thick = THICK * length;
    if a.is_beyond(b, thick) {
        return false;
    }
    let mut lines = a.lines().skip(1);
    lines.any(|one| (b.lines().skip(1)).any(|other| gap(one, other) < thick))
}

/// Returns the distance of two segments (Ericson, *Real-Time Collision Detection*, 2004, §5.1.9),
/// mm.
fn gap([from, to]: [Vector; 2], [other_from, other_to]: [Vector; 2]) -> f64 {
    let (along, other, apart) = (to - from, other_to - other_from, from - other_from);
    let (a, e, f) = (
        along.norm_squared(),
        other.norm_squared(),
        other.dot(&apart),
    );
    let (b, c) = (along.dot(&other), along.dot(&apart));
    let part = |share: f64, whole: f64| {
        if whole > 0.0 {
            (share / whole).clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    let nearest = part(b * f - c * e, a * e - b * b);
    let on_other = part(b * nearest + f, e);
    let nearest = part(b * on_other - c, a);
    (apart + along * nearest - other * on_other).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_as_far_apart_as_their_nearest_points() {
        let at = |x: f64, y: f64, z: f64| Vector::new(x, y, z);
        let flat = [at(0.0, 0.0, 0.0), at(10.0, 0.0, 0.0)];
        // Over the middle, beyond an end, alongside, and a point.
        let others = [
            ([at(5.0, -5.0, 3.0), at(5.0, 5.0, 3.0)], 3.0),
            ([at(13.0, 4.0, 0.0), at(20.0, 4.0, 0.0)], 5.0),
            ([at(-4.0, 2.0, 0.0), at(4.0, 2.0, 0.0)], 2.0),
            ([at(-3.0, 0.0, 4.0), at(-3.0, 0.0, 4.0)], 5.0),
            ([at(5.0, -5.0, 0.0), at(5.0, 5.0, 0.0)], 0.0),
        ];
        for (other, expected) in others {
            assert!((gap(flat, other) - expected).abs() < 1e-12, "{other:?}");
            assert!((gap(other, flat) - expected).abs() < 1e-12, "{other:?}");
        }
    }
}
