//! The time-optimal move to a point on a line, at rest there (the "trapezoidal" profile; Biagiotti
//! and Melchiorri, *Trajectory Planning for Automatic Machines and Robots*, ch. 3), planned again
//! from the present state in each cycle, so that limits may change during the move.

use super::{INSTANT, Limits};

/// Distance of the point from its goal, and the speed at which it shrinks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Approach {
    pub(super) gap: f64,
    pub(super) speed: f64,
}

impl Approach {
    pub(super) const ARRIVED: Self = Approach {
        gap: 0.0,
        speed: 0.0,
    };

    /// Moves on by `dt` seconds.
    pub(super) fn advance(&mut self, limits: Limits, dt: f64) {
        let acceleration = limits.acceleration;
        if acceleration <= 0.0 {
            self.speed = 0.0;
        } else if *self != Self::ARRIVED {
            let stopping = self.speed * libm::fabs(self.speed) / (2.0 * acceleration);
            // Seen from the side on which braking at once would end short of the point.
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
