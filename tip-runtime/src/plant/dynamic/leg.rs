//! The dynamics of a leg: links with mass, motors, and contacts with the ground.
//!
//! A leg meets the others at the body only, so the equations of motion have the form of an arrow:
//! six rows of the body, and for each leg a block of its joints, which it shares with the body
//! alone. Each leg is eliminated by itself (Schur's complement), and nothing larger than 6 × 6 is
//! ever solved for the robot as a whole.

use super::Vector;
use super::contact::{Bristle, FootContact};
use super::servo::{Control, Drives, Saturation, Servo};
use super::spatial::{
    CholeskyFactor, Contribution, Inertia, MovingFrame, Spatial, dot, placed, point_mass, tensor,
};
use super::terrain::StepContext;
use crate::hardware::JointCommand;
use crate::kinematics::Chain;
use crate::model::{Joint, Leg};
use crate::plant::self_collision::Capsules;
use crate::plant::walker::events::Path;
use crate::plant::{Effort, GRAVITY};
use nalgebra::{Rotation3, Unit};

/// The motion of a joint and the momentum of all that it carries: a column of the mass matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Column {
    /// The joint's axis, in the world.
    axis: Vector,
    /// Position of the joint from the body's origin, m.
    place: Vector,
    /// Momentum of all that the joint carries in that motion.
    momentum: Spatial,
}

impl Column {
    /// Returns the motion at 1 rad/s.
    #[inline]
    fn motion(&self) -> Spatial {
        Spatial::turning(self.axis, self.place)
    }
}

/// One leg in motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegBody<const J: usize> {
    pub(super) model: Leg<J>,
    pub(super) servos: [Servo; J],
    columns: [Column; J],
    /// Generalised forces of gravity, velocities and contacts on the joints, N·m.
    bias: [f64; J],
    /// Bristles of the end of each link; the last one is the foot's.
    bristles: [Bristle; J],
    pub(super) foot: FootContact,
    /// The motors at their greatest and at their least torque: bit j of joint j.
    saturated: [u16; 2],
    /// The joints that are commanded torques: bit j of joint j.
    by_torque: u16,
    path: Path,
    pub(super) capsules: Capsules<J>,
}

impl<const J: usize> LegBody<J> {
    /// Returns the leg at rest in its initial posture.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn new(model: &Leg<J>) -> Self {
        LegBody {
            model: *model,
            servos: model.initial.map(Servo::at),
            columns: [Column {
                axis: Vector::zeros(),
                place: Vector::zeros(),
                momentum: Spatial::ZERO,
            }; J],
            bias: [0.0; J],
            bristles: [Bristle::FREE; J],
            foot: FootContact::NONE,
            saturated: [0; 2],
            by_torque: 0,
            path: Path::NONE,
            capsules: Capsules::NONE,
        }
    }

    /// Returns the distance of the foot from its commanded path, mm.
    pub(super) fn stray(&mut self, commands: &[JointCommand; J]) -> f64 {
        let angles = self.servos.map(|servo| servo.angle.to_degrees());
        let foot = Chain::new(&self.model, &angles).foot();
        self.path.stray(&self.model, commands, foot.into())
    }

    pub(super) fn command(&mut self, commands: &[JointCommand; J], unit: f64) {
        let before: [Control; J] = self.controls();
        let servos = self.servos.iter_mut().zip(before);
        for (j, ((servo, before), command)) in servos.zip(commands).enumerate() {
            match servo.command(before, *command, unit) {
                Control::Torque => self.by_torque |= bit(j),
                Control::Angle => self.by_torque &= !bit(j),
            }
        }
    }

    /// Clears the contacts.
    pub(super) const fn clear_contacts(&mut self) {
        self.bristles = [Bristle::FREE; J];
        self.foot = FootContact::NONE;
    }

    /// Holds every joint.
    pub(super) fn hold(&mut self) {
        self.by_torque = 0;
        self.servos.iter_mut().for_each(Servo::hold);
    }

    /// Returns the control mode of each joint.
    fn controls(&self) -> [Control; J] {
        core::array::from_fn(|j| self.control(j))
    }

    /// Returns the control mode of joint `j`.
    fn control(&self, j: usize) -> Control {
        match self.by_torque & bit(j) {
            0 => Control::Angle,
            _ => Control::Torque,
        }
    }

    /// Updates the positions, contacts, masses and forces of the links; returns the leg's
    /// contribution to the body.
    pub(super) fn place(&mut self, context: &StepContext<'_>) -> Contribution {
        let mut links = [Contribution::NONE; J];
        let mut walk = LinkWalk::from(context.frame, &self.model);
        let blocks = context.terrain.filter(|terrain| terrain.has_blocks());
        let places = links.iter_mut().zip(&mut self.columns);
        let joints = self.model.joints.iter().zip(&self.servos);
        for (((link, column), (joint, servo)), (j, bristle)) in
            places.zip(joints).zip((1..).zip(&mut self.bristles))
        {
            (column.axis, column.place) = walk.turn(joint, servo);
            *link = walk.link(joint);
            let (end, velocity) = walk.end(joint);
            let place = context.frame.position + end;
            let touch = context.terrain.and_then(|terrain| terrain.touch(place));
            let bars = blocks.iter();
            let bars = bars.flat_map(|terrain| terrain.bars(walk.rod(joint, context.frame)));
            let mut bars = bars.map(|(at, touch)| (at - context.frame.position, touch));
            // The bristle is the end's or, while that is free, of the first block that the link lies on.
            let lying = touch.is_none().then(|| bars.next()).flatten();
            let (at, velocity, pressed) = match lying {
                Some((at, touch)) => (at, walk.velocity(at), Some(touch)),
                None => (end, velocity, touch),
            };
            let force = bristle.force(pressed, velocity, context.law, context.step.dt);
            link.force = link.force - Spatial::pushing(force, at);
            for (at, touch) in bars {
                let force = touch.rub(walk.velocity(at), context.law, context.step.dt);
                link.force = link.force - Spatial::pushing(force, at);
            }
            if j == J {
                // A link that lies on a block pushes elsewhere than with its foot.
                let none = (Vector::zeros(), Vector::zeros());
                let (force, normal) = touch.map_or(none, |touch| (force, touch.normal));
                self.foot.at(place, force, normal, context.step.dt);
            }
        }
        let mut carried = Contribution::NONE;
        // By number: a reversed zip has a path that panics.
        for j in (0..J).rev() {
            let places = self.columns.get_mut(j).zip(self.bias.get_mut(j));
            if let Some(((column, bias), link)) = places.zip(links.get(j)) {
                carried.add(*link);
                column.momentum = carried.inertia.momentum(&column.motion());
                *bias = column.motion().dot(&carried.force);
            }
        }
        carried
    }

    /// Updates the torque of every motor; `left` steps of the cycle are left.
    pub(super) fn aim(
        &mut self,
        context: &StepContext<'_>,
        commands: Option<&[JointCommand; J]>,
        left: f64,
    ) {
        let controls = self.controls();
        let joints = self.servos.iter_mut().zip(&self.model.joints);
        for (j, ((servo, joint), control)) in joints.zip(controls).enumerate() {
            let command = commands.and_then(|commands| commands.get(j)).copied();
            servo.aim(control, command, joint, context.drives, context.step, left);
        }
    }

    /// Returns the effort that the position loop of joint `j` demands.
    #[inline]
    fn demand(&self, j: usize, servo: &Servo, joint: &Joint, context: &StepContext<'_>) -> Effort {
        servo.demand(self.control(j), joint, context.drives, context.step.dt)
    }

    /// Returns the effort of the motor of joint `j`.
    #[inline]
    fn motor(&self, j: usize, servo: &Servo, joint: &Joint, context: &StepContext<'_>) -> Effort {
        let [above, below] = self.saturated.map(|motors| motors & bit(j) != 0);
        let saturation = match (above, below) {
            (true, _) => Saturation::Above,
            (_, true) => Saturation::Below,
            _ => Saturation::None,
        };
        saturation.limit(self.demand(j, servo, joint, context), joint)
    }

    /// Returns the joints' block of the equations of motion, factorised, and the torques on its
    /// right side, N·m.
    fn block(&self, context: &StepContext<'_>) -> (Option<CholeskyFactor<J>>, [f64; J]) {
        let mut matrix = [[0.0; J]; J];
        let mut torques = [0.0; J];
        let motions = self.columns.each_ref().map(Column::motion);
        let rows = matrix.iter_mut().zip(&mut torques);
        let joints = self.columns.iter().zip(&self.bias);
        let drives = self.servos.iter().zip(&self.model.joints);
        for (j, ((row, torque), ((column, bias), (servo, joint)))) in
            rows.zip(joints.zip(drives)).enumerate()
        {
            let passive = servo.passive(joint, context.drives, context.step.dt);
            let all = self.motor(j, servo, joint, context).plus(passive);
            *torque = all.torque - bias;
            for (entry, motion) in row.iter_mut().zip(&motions).take(j + 1) {
                *entry = motion.dot(&column.momentum);
            }
            if let Some(entry) = row.get_mut(j) {
                *entry += all.inertia;
            }
        }
        (CholeskyFactor::of(matrix), torques)
    }

    /// Returns the joints' momentum for each motion of the body.
    fn coupling(&self) -> [[f64; J]; 6] {
        let mut coupling = [[0.0; J]; 6];
        for (j, column) in self.columns.iter().enumerate() {
            for (row, value) in coupling.iter_mut().zip(column.momentum.entries()) {
                if let Some(entry) = row.get_mut(j) {
                    *entry = value;
                }
            }
        }
        coupling
    }

    /// Eliminates the joints from the body's equations of motion, of which the lower triangle
    /// counts.
    pub(super) fn eliminate(
        &self,
        context: &StepContext<'_>,
        matrix: &mut [[f64; 6]; 6],
        forces: &mut [f64; 6],
    ) {
        let (Some(factor), torques) = self.block(context) else {
            return;
        };
        let halves = self
            .coupling()
            .map(|motion| factor.forward_substitute(motion));
        let torques = factor.forward_substitute(torques);
        let rows = matrix.iter_mut().zip(forces).zip(&halves).enumerate();
        for (i, ((row, force), half)) in rows {
            *force -= dot(half, &torques, J);
            for (entry, other) in row.iter_mut().zip(&halves).take(i + 1) {
                *entry -= dot(half, other, J);
            }
        }
    }

    /// Returns the accelerations of the joints (rad/s²) for an acceleration of the body.
    fn accelerations(&self, context: &StepContext<'_>, body: &[f64; 6]) -> [f64; J] {
        let (factor, mut torques) = self.block(context);
        for (torque, column) in torques.iter_mut().zip(&self.columns) {
            for (momentum, acceleration) in column.momentum.entries().iter().zip(body) {
                *torque -= momentum * acceleration;
            }
        }
        factor.map_or([0.0; J], |factor| factor.solve(torques))
    }

    /// Calculates the accelerations of the joints, and marks the motors as saturated of which they
    /// demand more than their torque, and no others; returns true if that changes any of them.
    ///
    /// The demand falls as a joint accelerates, so that a motor at its limit is released once the
    /// joint moves its way. Limit and demand are compared at the end of the step.
    pub(super) fn saturate(
        &mut self,
        context: &StepContext<'_>,
        body: &[f64; 6],
        accelerations: &mut [f64; J],
    ) -> bool {
        *accelerations = self.accelerations(context, body);
        let before = self.saturated;
        self.saturated = [0; 2];
        let joints = self.servos.iter().zip(&self.model.joints);
        for (j, ((servo, joint), acceleration)) in joints.zip(accelerations).enumerate() {
            let demand = self.demand(j, servo, joint, context).at(*acceleration);
            let [above, below] = &mut self.saturated;
            match Saturation::of(demand, joint) {
                Saturation::Above => *above |= bit(j),
                Saturation::Below => *below |= bit(j),
                Saturation::None => {}
            }
        }
        self.saturated != before
    }

    /// Integrates the accelerations of the joints.
    pub(super) fn advance(&mut self, context: &StepContext<'_>, accelerations: &[f64; J]) {
        for (j, acceleration) in accelerations.iter().enumerate() {
            let (Some(servo), Some(joint)) = (self.servos.get(j), self.model.joints.get(j)) else {
                break;
            };
            let own = self.motor(j, servo, joint, context);
            if let Some(servo) = self.servos.get_mut(j) {
                servo.advance(joint, own, *acceleration, context.step.dt);
            }
        }
    }

    /// Returns both ends of the link after joint `j`, from the body's origin, m.
    pub(super) fn link(&self, j: usize, frame: &MovingFrame) -> Option<[Vector; 2]> {
        let start = self.columns.get(j)?.place;
        let next = self.columns.get(j + 1).map(|next| next.place);
        Some([start, next.unwrap_or(self.foot.place - frame.position)])
    }

    /// Returns the velocity of a point of the link after joint `j`, m/s.
    pub(super) fn velocity(&self, j: usize, at: Vector, frame: &MovingFrame) -> Vector {
        let own = frame.velocity + frame.rate.cross(&at);
        let joints = self.columns.iter().zip(&self.servos).take(j + 1);
        joints.fold(own, |velocity, (column, servo)| {
            velocity + column.axis.cross(&(at - column.place)) * servo.rate
        })
    }

    /// Applies a force at a point of the link after joint `j` to the joints; its effect on the body
    /// is handled elsewhere.
    pub(super) fn push(&mut self, j: usize, at: Vector, force: Vector) {
        let joints = self.bias.iter_mut().zip(&self.columns);
        for (bias, column) in joints.take(j + 1) {
            *bias -= column.axis.dot(&(at - column.place).cross(&force));
        }
    }

    /// Returns twice the kinetic energy of the rotors, and of the links beyond that of the body's
    /// motion, J.
    pub(super) fn double_kinetic_energy(&self, body: &Spatial, drives: &Drives) -> f64 {
        let mut double_kinetic_energy = 0.0;
        for (j, (column, servo)) in self.columns.iter().zip(&self.servos).enumerate() {
            let rotor = (self.model.joints.get(j)).map_or(0.0, |joint| drives.rotor * joint.torque);
            double_kinetic_energy +=
                (rotor * servo.rate + 2.0 * column.momentum.dot(body)) * servo.rate;
            for (i, (other, turned)) in self
                .columns
                .iter()
                .zip(&self.servos)
                .enumerate()
                .take(j + 1)
            {
                let both = if i == j { 1.0 } else { 2.0 };
                double_kinetic_energy +=
                    both * other.motion().dot(&column.momentum) * turned.rate * servo.rate;
            }
        }
        double_kinetic_energy
    }

    /// Returns the momentum of the joints' rates.
    pub(super) fn momentum(&self) -> Spatial {
        let mut momentum = Spatial::ZERO;
        for (column, servo) in self.columns.iter().zip(&self.servos) {
            momentum += Spatial {
                angular: column.momentum.angular * servo.rate,
                linear: column.momentum.linear * servo.rate,
            };
        }
        momentum
    }

    /// Returns the least effective mass of the foot, kg.
    pub(super) fn foot_mass(&self, drives: &Drives) -> f64 {
        self.model.joints.last().map_or(0.0, |joint| {
            let square = length(joint).norm_squared();
            if square > 0.0 {
                end_mass(joint) + drives.rotor * joint.torque / square
            } else {
                joint.mass
            }
        })
    }

    /// Returns the mass, kg.
    pub(super) fn mass(&self) -> f64 {
        self.model.joints.iter().map(|joint| joint.mass).sum()
    }
}

/// Returns the least effective mass of the end of a floating link, kg: a quarter of a uniform rod's
/// mass.
fn end_mass(joint: &Joint) -> f64 {
    let Some(inertial) = &joint.inertial else {
        return joint.mass / 4.0;
    };
    let Some(turns) = tensor(inertial).try_inverse() else {
        return joint.mass / 4.0;
    };
    // A push at the end moves the centre, and turns the link about it.
    let arm = length(joint) - Vector::from(inertial.centre) / 1000.0;
    let give = |push: Vector| {
        let moment = arm.cross(&push);
        moment.dot(&(turns * moment))
    };
    // No direction gives more than all three together.
    let most = give(Vector::x()) + give(Vector::y()) + give(Vector::z());
    joint.mass / (1.0 + joint.mass * most)
}

/// Returns the bit of joint `j`; 0 for more joints than robots have.
#[inline]
fn bit(j: usize) -> u16 {
    u32::try_from(j)
        .ok()
        .and_then(|j| 1_u16.checked_shl(j))
        .unwrap_or(0)
}

/// Copies the load, N, and the contact force of each foot.
#[inline(never)]
pub(super) fn fill_feet<const J: usize>(
    legs: &[LegBody<J>],
    loads: &mut [f64],
    forces: &mut [[f64; 3]],
) {
    for ((leg, load), force) in legs.iter().zip(loads).zip(forces) {
        *load = leg.foot.load;
        *force = leg.foot.force.into();
    }
}

/// Returns a link from its joint to the next one, at angle 0, m.
#[inline]
pub(super) fn length(joint: &Joint) -> Vector {
    Vector::from(joint.link) / 1000.0
}

/// A walk along a leg from its base to its foot. Positions are from the body's origin.
struct LinkWalk {
    /// Position of the joint or of the link's end, m.
    at: Vector,
    /// m/s.
    velocity: Vector,
    /// Acceleration at constant rates, m/s².
    acceleration: Vector,
    rotation: Rotation3<f64>,
    /// rad/s.
    rate: Vector,
    /// Angular acceleration at constant rates, rad/s².
    turning: Vector,
    /// Acceleration of gravity, m/s².
    gravity: Vector,
}

impl LinkWalk {
    pub(super) fn from<const J: usize>(frame: &MovingFrame, leg: &Leg<J>) -> Self {
        let mut walk = LinkWalk {
            at: Vector::zeros(),
            velocity: frame.velocity,
            acceleration: Vector::zeros(),
            rotation: frame.rotation,
            rate: frame.rate,
            turning: Vector::zeros(),
            gravity: Vector::new(0.0, 0.0, -GRAVITY),
        };
        walk.step(frame.rotation * (Vector::from(leg.base) / 1000.0));
        walk
    }

    /// Moves to another point of the same rigid body.
    #[inline]
    fn step(&mut self, by: Vector) {
        self.acceleration = self.acceleration_at(by);
        self.velocity += self.rate.cross(&by);
        self.at += by;
    }

    #[inline]
    fn acceleration_at(&self, by: Vector) -> Vector {
        self.acceleration + self.turning.cross(&by) + self.rate.cross(&self.rate.cross(&by))
    }

    /// Turns with the joint; returns its axis and position.
    #[inline]
    pub(super) fn turn(&mut self, joint: &Joint, servo: &Servo) -> (Vector, Vector) {
        let own = Unit::new_unchecked(Vector::from(joint.axis));
        let axis = self.rotation * own.into_inner();
        self.turning += self.rate.cross(&axis) * servo.rate;
        self.rate += axis * servo.rate;
        self.rotation *= Rotation3::from_axis_angle(&own, servo.angle);
        (axis, self.at)
    }

    /// Returns the contribution of the link after the joint: a uniform rod unless the model gives
    /// its inertia.
    #[inline]
    pub(super) fn link(&self, joint: &Joint) -> Contribution {
        let (arm, own) = match &joint.inertial {
            None => {
                let link = self.rotation * length(joint);
                (link / 2.0, point_mass(link) * (joint.mass / 12.0))
            }
            Some(inertial) => placed(inertial, self.rotation),
        };
        let centre = self.at + arm;
        let force = (self.acceleration_at(arm) - self.gravity) * joint.mass;
        let moment = own * self.turning + self.rate.cross(&(own * self.rate));
        Contribution {
            inertia: Inertia::new(joint.mass, centre, own),
            force: Spatial {
                angular: moment + centre.cross(&force),
                linear: force,
            },
        }
    }

    /// Returns the link whose end has been reached, in the world, m.
    #[inline]
    pub(super) fn rod(&self, joint: &Joint, frame: &MovingFrame) -> [Vector; 2] {
        let end = frame.position + self.at;
        [end - self.rotation * length(joint), end]
    }

    /// Returns the velocity of a point of that link, m/s.
    #[inline]
    pub(super) fn velocity(&self, at: Vector) -> Vector {
        self.velocity + self.rate.cross(&(at - self.at))
    }

    /// Moves to the link's end; returns its position and velocity.
    #[inline]
    pub(super) fn end(&mut self, joint: &Joint) -> (Vector, Vector) {
        self.step(self.rotation * length(joint));
        (self.at, self.velocity)
    }
}
