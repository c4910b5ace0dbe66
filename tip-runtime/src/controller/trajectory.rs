//! Set points that move under limits of speed and acceleration.
//!
//! One law serves joints (`N` = 1) and feet (`N` = 3). A set point has a position and a velocity;
//! whatever its goal becomes, both go on from where they are.

mod approach;
mod course;
#[cfg(test)]
mod tests;
mod vector;

use core::f64::consts::SQRT_2;
use course::Course;

/// Remaining time up to which it is rounding, s.
const INSTANT: f64 = 1e-9;

/// Limits above this one are as good as none; its square is still finite.
const UNBOUNDED: f64 = 1e100;

/// The most that a set point may do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    /// Speed, while it heads for a point.
    pub(crate) speed: f64,
    /// Acceleration; infinite for a move without acceleration limit.
    pub(crate) acceleration: f64,
}

/// The goal of a set point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Goal<const N: usize> {
    /// Comes to rest and stays.
    Rest,
    /// Comes to rest at a point.
    Point {
        /// The point.
        target: [f64; N],
        /// True if no acceleration limit holds during the move.
        hs: bool,
    },
    /// Comes to rest at a point, to which a spring pulls what is guided.
    Spring {
        /// The point.
        target: [f64; N],
        /// True if no acceleration limit holds during the move.
        hs: bool,
    },
    /// Keeps a velocity.
    Speed([f64; N]),
    /// Pushes with a torque or force, wherever that leads; the set point is where it led.
    Effort([f64; N]),
}

impl<const N: usize> Goal<N> {
    /// Returns the point that it heads for.
    pub(crate) const fn target(&self) -> Option<[f64; N]> {
        match self {
            Goal::Point { target, .. } | Goal::Spring { target, .. } => Some(*target),
            Goal::Rest | Goal::Speed(_) | Goal::Effort(_) => None,
        }
    }

    /// Returns true if torques follow from it, not positions.
    pub(crate) const fn is_soft(&self) -> bool {
        matches!(self, Goal::Spring { .. } | Goal::Effort(_))
    }

    /// Returns true if no acceleration limit holds.
    pub(crate) const fn is_hs(&self) -> bool {
        matches!(
            self,
            Goal::Point { hs: true, .. } | Goal::Spring { hs: true, .. }
        )
    }
}

/// A moving set point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Track<const N: usize> {
    position: [f64; N],
    velocity: [f64; N],
    goal: Goal<N>,
    course: Option<Course<N>>,
    /// DIRECT: the set point is at its target from the next motion on, without limits.
    jumps: bool,
}

impl<const N: usize> Track<N> {
    /// Returns a set point in motion, without a goal.
    pub(crate) const fn moving(position: [f64; N], velocity: [f64; N]) -> Self {
        Track {
            position,
            velocity,
            goal: Goal::Rest,
            course: None,
            jumps: false,
        }
    }

    /// Returns a set point at rest.
    pub(crate) const fn resting(position: [f64; N]) -> Self {
        Self::moving(position, [0.0; N])
    }

    /// Returns this motion with another goal.
    pub(crate) const fn towards(self, goal: Goal<N>) -> Self {
        Track {
            goal,
            course: None,
            jumps: false,
            ..self
        }
    }

    /// Returns this motion, which is at its target at once if `jumps`.
    pub(crate) const fn jumping(self, jumps: bool) -> Self {
        Track { jumps, ..self }
    }

    /// Returns true if the set point is at its target at once.
    pub(crate) const fn jumps(&self) -> bool {
        self.jumps
    }

    /// Returns this goal, started from rest at `position`.
    pub(crate) const fn stopped_at(self, position: [f64; N]) -> Self {
        Track::resting(position).towards(self.goal)
    }

    pub(crate) const fn position(&self) -> [f64; N] {
        self.position
    }

    pub(crate) const fn velocity(&self) -> [f64; N] {
        self.velocity
    }

    pub(crate) const fn goal(&self) -> Goal<N> {
        self.goal
    }

    pub(crate) fn is_at_rest(&self) -> bool {
        self.velocity.iter().all(|speed| *speed == 0.0)
    }

    /// Returns the place where the set point comes to rest when it brakes as hard as it may; a
    /// point farther than any robot reaches, but finite, if it may hardly brake.
    pub(crate) fn rest_point(&self, limits: Limits) -> [f64; N] {
        let acceleration = self.in_force(limits).acceleration;
        let speed = vector::norm(self.velocity);
        let per_speed = if acceleration > 0.0 {
            (speed / (2.0 * acceleration)).min(UNBOUNDED)
        } else {
            0.0
        };
        vector::add_scaled(self.position, self.velocity, per_speed)
    }

    /// Returns the place where the set point would be farthest to the side of the straight line to
    /// its target, which it joins without a jump in velocity.
    pub(crate) fn swing(&self, limits: Limits) -> [f64; N] {
        self.goal.target().map_or(self.position, |target| {
            Course::new(self.position, self.velocity, target).swing(self.in_force(limits))
        })
    }

    /// Returns the place of the set point after a share of the time in which it joins the straight
    /// line to its target, at most, if it moves away from it at first.
    pub(crate) fn ahead(mut self, limits: Limits, share: f64) -> [f64; N] {
        let acceleration = self.in_force(limits).acceleration;
        if acceleration > 0.0 {
            let braking = SQRT_2 * vector::norm(self.velocity) / acceleration;
            self.advance(limits, (share * braking).min(UNBOUNDED), false);
        }
        self.position
    }

    /// Moves on by `dt` seconds; a held set point brakes and stays, whatever its goal.
    pub(crate) fn advance(&mut self, limits: Limits, dt: f64, held: bool) {
        if self.jumps {
            self.jump(limits, dt, held);
        } else {
            self.move_on(limits, dt, held);
        }
    }

    /// Puts the set point at its target; without one, or held, it moves on.
    #[cold]
    fn jump(&mut self, limits: Limits, dt: f64, held: bool) {
        self.jumps = false;
        match self.goal.target() {
            Some(target) if !held => *self = Track::resting(target).towards(self.goal),
            _ => self.move_on(limits, dt, held),
        }
    }

    fn move_on(&mut self, limits: Limits, dt: f64, held: bool) {
        let limits = self.in_force(limits);
        match self.goal {
            _ if held => self.ramp([0.0; N], limits, dt),
            Goal::Rest | Goal::Effort(_) => self.ramp([0.0; N], limits, dt),
            Goal::Speed(velocity) => self.ramp(velocity, limits, dt),
            Goal::Point { target, .. } | Goal::Spring { target, .. } => {
                self.follow(target, limits, dt)
            }
        }
    }

    fn in_force(&self, limits: Limits) -> Limits {
        let limits = Limits {
            speed: limits.speed.min(UNBOUNDED),
            acceleration: limits.acceleration.min(UNBOUNDED),
        };
        if self.goal.is_hs() {
            Limits {
                acceleration: f64::INFINITY,
                ..limits
            }
        } else {
            limits
        }
    }

    fn follow(&mut self, target: [f64; N], limits: Limits, dt: f64) {
        let mut course = match self.course {
            Some(course) => course,
            None => Course::new(self.position, self.velocity, target),
        };
        course.advance(limits, dt);
        self.position = course.position();
        self.velocity = course.velocity();
        self.course = Some(course);
    }

    /// Changes the velocity along a straight line in velocity space, as fast as it may.
    fn ramp(&mut self, velocity: [f64; N], limits: Limits, dt: f64) {
        self.course = None;
        let acceleration = limits.acceleration;
        if acceleration <= 0.0 {
            self.velocity = [0.0; N];
            return;
        }
        let change = vector::add_scaled(velocity, self.velocity, -1.0);
        let (direction, size) = vector::split(change);
        let ramp = size / acceleration;
        if dt < ramp - INSTANT {
            self.position = vector::add_scaled(self.position, self.velocity, dt);
            self.position =
                vector::add_scaled(self.position, direction, 0.5 * acceleration * dt * dt);
            self.velocity = vector::add_scaled(self.velocity, direction, acceleration * dt);
        } else {
            self.position = vector::add_scaled(self.position, self.velocity, 0.5 * ramp);
            self.position = vector::add_scaled(self.position, velocity, dt - 0.5 * ramp);
            self.velocity = velocity;
        }
    }
}
