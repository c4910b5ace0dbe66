//! The path of a set point to a target: a straight line, joined without a jump in velocity.
//!
//! The velocity at the start is split into a part along the line and one across it. Each is
//! brought to rest by its own [`Approach`]; being at right angles they share speed and
//! acceleration as the sides of a right triangle share its hypotenuse, so that neither limit is
//! exceeded. From rest, and for a target straight ahead, there is no part across.

use super::approach::Approach;
use super::vector::{add_scaled, dot, split};
use super::{Limits, UNBOUNDED};

/// A part across the line below this share of the speed is rounding.
const STRAIGHT: f64 = 1e-9;

/// The largest share of the acceleration that the part across takes.
const MOST_ACROSS: f64 = core::f64::consts::FRAC_1_SQRT_2;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Course<const N: usize> {
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

impl<const N: usize> Course<N> {
    pub(super) fn new(position: [f64; N], velocity: [f64; N], target: [f64; N]) -> Self {
        let (heading, speed) = split(velocity);
        let (mut line, gap) = split(add_scaled(target, position, -1.0));
        if gap == 0.0 {
            line = heading;
        }
        let ahead = dot(heading, line);
        let (side, sine) = split(add_scaled(heading, line, -ahead));
        let straight = sine <= STRAIGHT;
        Course {
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
                // Going to the side widens the gap on the other side.
                Approach {
                    gap: 0.0,
                    speed: sine * speed,
                }
            },
            across_top: sine * speed,
            across_share: sine.min(MOST_ACROSS),
        }
    }

    pub(super) fn position(&self) -> [f64; N] {
        let on_line = add_scaled(self.target, self.line, -self.along.gap);
        add_scaled(on_line, self.side, -self.across.gap)
    }

    pub(super) fn velocity(&self) -> [f64; N] {
        let mut velocity = [0.0; N];
        velocity = add_scaled(velocity, self.line, self.along.speed);
        add_scaled(velocity, self.side, self.across.speed)
    }

    /// Returns the place where it is farthest to the side of its line.
    pub(super) fn swing(mut self, limits: Limits) -> [f64; N] {
        let braking = limits.acceleration * self.across_share;
        if braking > 0.0 {
            self.advance(limits, (self.across.speed / braking).min(UNBOUNDED));
        }
        self.position()
    }

    /// Moves on by `dt` seconds.
    pub(super) fn advance(&mut self, limits: Limits, dt: f64) {
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
