//! Set points that move under limits of speed and acceleration.
//!
//! One law serves joints (`N` = 1) and feet (`N` = 3). A set point has a position and a velocity. Both are continuous
//! when its goal changes.

#[cfg(test)]
mod tests;

use core::f64::consts::SQRT_2;

/// Remaining time below which a motion has ended; it comes from rounding, s.
const INSTANT: f64 = 1e-9;

/// Value above which a limit has no effect. Its square is still finite.
const UNBOUNDED: f64 = 1e100;

/// Limits of the motion of a set point.
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
    /// Comes to rest at a point, to which a spring pulls the joint or foot.
    Spring {
        /// The point.
        target: [f64; N],
        /// True if no acceleration limit holds during the move.
        hs: bool,
    },
    /// Keeps a velocity.
    Speed([f64; N]),
    /// Pushes with a torque or force. The set point follows the measured place.
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
pub(crate) struct SetPoint<const N: usize> {
    position: [f64; N],
    velocity: [f64; N],
    goal: Goal<N>,
    course: Option<LinePath<N>>,
    /// True under DIRECT: the set point is at its target from the next advance on, without limits.
    jumps: bool,
}

impl<const N: usize> SetPoint<N> {
    /// Returns a set point in motion, without a goal.
    pub(crate) const fn moving(position: [f64; N], velocity: [f64; N]) -> Self {
        SetPoint {
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
        SetPoint {
            goal,
            course: None,
            jumps: false,
            ..self
        }
    }

    /// Returns this motion with `jumps`: if true, the set point is at its target immediately.
    pub(crate) const fn jumping(self, jumps: bool) -> Self {
        SetPoint { jumps, ..self }
    }

    /// Returns true if the set point goes to its target immediately.
    pub(crate) const fn jumps(&self) -> bool {
        self.jumps
    }

    /// Returns this set point with its goal, at rest at `position`.
    pub(crate) const fn stopped_at(self, position: [f64; N]) -> Self {
        SetPoint::resting(position).towards(self.goal)
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

    /// Returns the place at which the set point comes to rest if it brakes as hard as it may. If it may hardly brake,
    /// that is a finite place beyond the reach of any robot.
    pub(crate) fn rest_point(&self, limits: Limits) -> [f64; N] {
        let acceleration = self.in_force(limits).acceleration;
        let speed = norm(self.velocity);
        let per_speed = if acceleration > 0.0 {
            (speed / (2.0 * acceleration)).min(UNBOUNDED)
        } else {
            0.0
        };
        add_scaled(self.position, self.velocity, per_speed)
    }

    /// Returns the place at which the set point is farthest from the straight line to its target. It joins that line
    /// without a jump in velocity.
    pub(crate) fn swing(&self, limits: Limits) -> [f64; N] {
        self.goal.target().map_or(self.position, |target| {
            LinePath::new(self.position, self.velocity, target).swing(self.in_force(limits))
        })
    }

    /// Returns the place of the set point after a share of the time in which it joins the straight
    /// line to its target, at most, if it moves away from it at first.
    pub(crate) fn ahead(mut self, limits: Limits, share: f64) -> [f64; N] {
        let acceleration = self.in_force(limits).acceleration;
        if acceleration > 0.0 {
            let braking = SQRT_2 * norm(self.velocity) / acceleration;
            self.advance(limits, (share * braking).min(UNBOUNDED), false);
        }
        self.position
    }

    /// Advances by `dt` seconds. A held set point brakes and stays, with any goal.
    pub(crate) fn advance(&mut self, limits: Limits, dt: f64, held: bool) {
        if self.jumps {
            self.jump(limits, dt, held);
        } else {
            self.move_on(limits, dt, held);
        }
    }

    /// Moves the set point to its target. Without a target, or under a hold, advances it.
    #[cold]
    fn jump(&mut self, limits: Limits, dt: f64, held: bool) {
        self.jumps = false;
        match self.goal.target() {
            Some(target) if !held => *self = SetPoint::resting(target).towards(self.goal),
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
            None => LinePath::new(self.position, self.velocity, target),
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
        let change = add_scaled(velocity, self.velocity, -1.0);
        let (direction, size) = split(change);
        let ramp = size / acceleration;
        if dt < ramp - INSTANT {
            self.position = add_scaled(self.position, self.velocity, dt);
            self.position = add_scaled(self.position, direction, 0.5 * acceleration * dt * dt);
            self.velocity = add_scaled(self.velocity, direction, acceleration * dt);
        } else {
            self.position = add_scaled(self.position, self.velocity, 0.5 * ramp);
            self.position = add_scaled(self.position, velocity, dt - 0.5 * ramp);
            self.velocity = velocity;
        }
    }
}

/// Share of the speed below which a part across the line comes from rounding.
const STRAIGHT: f64 = 1e-9;

/// The largest share of the acceleration that the part across takes.
const MOST_ACROSS: f64 = core::f64::consts::FRAC_1_SQRT_2;
/// The path of a set point to a target: a straight line, joined without a jump in velocity.
///
/// The velocity at the start is split into a part along the line and one across it. Each is
/// brought to rest by its own [`Approach`]; being at right angles they share speed and
/// acceleration as the sides of a right triangle share its hypotenuse, so that neither limit is
/// exceeded. From rest, and for a target straight ahead, there is no part across.
#[derive(Clone, Copy, Debug, PartialEq)]
struct LinePath<const N: usize> {
    target: [f64; N],
    line: [f64; N],
    side: [f64; N],
    along: Approach,
    across: Approach,
    /// The speed across at the start, which it never exceeds.
    across_top: f64,
    /// The share of the acceleration that the part across takes.
    across_share: f64,
}

impl<const N: usize> LinePath<N> {
    fn new(position: [f64; N], velocity: [f64; N], target: [f64; N]) -> Self {
        let (heading, speed) = split(velocity);
        let (mut line, gap) = split(add_scaled(target, position, -1.0));
        if gap == 0.0 {
            line = heading;
        }
        let ahead = dot(heading, line);
        let (side, sine) = split(add_scaled(heading, line, -ahead));
        let straight = sine <= STRAIGHT;
        LinePath {
            target,
            line,
            side,
            along: Approach {
                gap,
                speed: ahead * speed,
            },
            across: if straight {
                Approach::ARRIVED
            } else {
                // A motion to one side widens the gap on the other side.
                Approach {
                    gap: 0.0,
                    speed: sine * speed,
                }
            },
            across_top: sine * speed,
            across_share: sine.min(MOST_ACROSS),
        }
    }

    fn position(&self) -> [f64; N] {
        let on_line = add_scaled(self.target, self.line, -self.along.gap);
        add_scaled(on_line, self.side, -self.across.gap)
    }

    fn velocity(&self) -> [f64; N] {
        let mut velocity = [0.0; N];
        velocity = add_scaled(velocity, self.line, self.along.speed);
        add_scaled(velocity, self.side, self.across.speed)
    }

    /// Returns the place at which it is farthest from its line.
    fn swing(mut self, limits: Limits) -> [f64; N] {
        let braking = limits.acceleration * self.across_share;
        if braking > 0.0 {
            self.advance(limits, (self.across.speed / braking).min(UNBOUNDED));
        }
        self.position()
    }

    /// Moves on by `dt` seconds.
    fn advance(&mut self, limits: Limits, dt: f64) {
        if self.across == Approach::ARRIVED {
            self.along.advance(limits, dt);
            return;
        }
        let (share, top) = (self.across_share, self.across_top.min(limits.speed));
        self.along.advance(
            Limits {
                speed: leg_of_triangle(limits.speed, top),
                acceleration: limits.acceleration * leg_of_triangle(1.0, share),
            },
            dt,
        );
        self.across.advance(
            Limits {
                speed: top,
                acceleration: limits.acceleration * share,
            },
            dt,
        );
    }
}

/// Returns the other leg of a right triangle.
fn leg_of_triangle(hypotenuse: f64, leg: f64) -> f64 {
    libm::sqrt(((hypotenuse - leg) * (hypotenuse + leg)).max(0.0))
}

/// Distance of the point from its goal, and the speed at which it shrinks: the time-optimal move to a point on a line,
/// at rest there (the "trapezoidal" profile; Biagiotti and Melchiorri, *Trajectory Planning for Automatic Machines and
/// Robots*, ch. 3), planned again from the present state in each cycle, so that limits may change during the move.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Approach {
    gap: f64,
    speed: f64,
}

impl Approach {
    const ARRIVED: Self = Approach {
        gap: 0.0,
        speed: 0.0,
    };

    /// Moves on by `dt` seconds.
    fn advance(&mut self, limits: Limits, dt: f64) {
        let acceleration = limits.acceleration;
        if acceleration <= 0.0 {
            self.speed = 0.0;
        } else if *self != Self::ARRIVED {
            let stopping = self.speed * libm::fabs(self.speed) / (2.0 * acceleration);
            // The sign of the speed change: immediate braking would end on this side of the point.
            let side = if self.gap < stopping { -1.0 } else { 1.0 };
            let plan = Plan::new(side * self.gap, side * self.speed, limits);
            let (gap, speed) = plan.after(dt);
            self.gap = side * gap;
            self.speed = side * speed;
        }
    }
}

/// Three phases: change the speed to a peak, keep it, brake to rest.
struct Plan {
    gap: f64,
    speed: f64,
    acceleration: f64,
    /// Acceleration of the first phase.
    push: f64,
    peak: f64,
    pushing: f64,
    cruising: f64,
    braking: f64,
}

impl Plan {
    fn new(gap: f64, speed: f64, limits: Limits) -> Self {
        let Limits {
            speed: top,
            acceleration,
        } = limits;
        let fastest = libm::sqrt((acceleration * gap + 0.5 * speed * speed).max(0.0));
        let peak = fastest.min(top);
        let push = if speed > peak {
            -acceleration
        } else {
            acceleration
        };
        let pushing = (peak - speed) / push;
        let pushed = (peak * peak - speed * speed) / (2.0 * push);
        let brake_way = peak * peak / (2.0 * acceleration);
        let cruising = if peak < top {
            0.0
        } else if top > 0.0 {
            (gap - pushed - brake_way).max(0.0) / top
        } else {
            f64::INFINITY
        };
        Plan {
            gap,
            speed,
            acceleration,
            push,
            peak,
            pushing,
            cruising,
            braking: peak / acceleration,
        }
    }

    /// Returns gap and speed `t` seconds from now. The last two phases count back from the arrival,
    /// so that rounding does not add up.
    fn after(&self, t: f64) -> (f64, f64) {
        if t < self.pushing {
            let way = self.speed * t + 0.5 * self.push * t * t;
            return (self.gap - way, self.speed + self.push * t);
        }
        if self.peak == 0.0 && self.cruising > 0.0 {
            let pushed = 0.5 * self.speed * self.pushing;
            return (self.gap - pushed, 0.0);
        }
        let left = self.cruising + self.braking - (t - self.pushing);
        if left > self.braking {
            let way = self.peak * (left - self.braking) + 0.5 * self.peak * self.braking;
            (way, self.peak)
        } else if left > INSTANT {
            (
                0.5 * self.acceleration * left * left,
                self.acceleration * left,
            )
        } else {
            (0.0, 0.0)
        }
    }
}

// Arithmetic of small vectors that neither overflows nor makes NaN of finite members.

/// Returns `a + k b`.
fn add_scaled<const N: usize>(mut a: [f64; N], b: [f64; N], k: f64) -> [f64; N] {
    for (a, b) in a.iter_mut().zip(b) {
        *a += k * b;
    }
    a
}

/// Returns the scalar product.
fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// Returns the length.
fn norm<const N: usize>(a: [f64; N]) -> f64 {
    split(a).1
}

/// Returns direction and length; a vector without length points along the first axis.
fn split<const N: usize>(a: [f64; N]) -> ([f64; N], f64) {
    let largest = a.iter().fold(0.0_f64, |most, a| most.max(libm::fabs(*a)));
    let mut direction = [0.0; N];
    if largest == 0.0 {
        if let Some(first) = direction.first_mut() {
            *first = 1.0;
        }
        return (direction, 0.0);
    }
    for (direction, a) in direction.iter_mut().zip(a) {
        *direction = a / largest;
    }
    let length = libm::sqrt(dot(direction, direction));
    for direction in &mut direction {
        *direction /= length;
    }
    (direction, (largest * length).min(f64::MAX))
}
