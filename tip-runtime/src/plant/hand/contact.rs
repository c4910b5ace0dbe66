//! What two things do to each other where they overlap.
//!
//! Normal to their surfaces: a spring and a damper that push and never pull. Along them: Coulomb
//! friction by a spring that is stretched as they move past each other, and slides where it would
//! pull more than friction holds (Cundall and Strack, *A discrete numerical model for granular
//! assemblies*, Géotechnique 29, 1979). A stuck contact therefore does not creep.

use super::Vector;

/// What two things are made of where they touch, along and across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Law {
    /// N/m.
    stiffness: f64,
    /// N·s/m.
    damping: f64,
}

/// What counts as heavy, and a finger as no heavier: kg.
pub(super) const HEAVY: f64 = 0.2;

/// By how much what is heavier makes contacts stiffer at most, so that no force leaves the numbers.
const HEAVIEST: f64 = 1e9;

/// Of what is not heavier than `HEAVY`: N/m. What is heavier is as much stiffer, so that it rests as deep.
const STIFFNESS: f64 = 5000.0;

/// Of what is just as heavy: N·s/m.
const DAMPING: f64 = 15.0;

impl Law {
    /// Of fingers with the floor, and with what is heavy.
    pub(super) const FINGER: Self = Law {
        stiffness: STIFFNESS,
        damping: DAMPING,
    };

    /// Of the lighter one's mass (kg). Every mass swings in the same way, since its damping ratio on
    /// one contact is the same: 0.24.
    pub(super) fn of(mass: f64) -> Self {
        let share = (mass / HEAVY).min(HEAVIEST);
        Law {
            stiffness: STIFFNESS * share.max(1.0),
            damping: DAMPING * share.max(libm::sqrt(share)),
        }
    }

    /// How fast it swings what has that mass: rad/s.
    pub(super) fn frequency(self, mass: f64) -> f64 {
        libm::sqrt(self.stiffness / mass)
    }
}

/// Where and how far two things overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Overlap {
    /// m.
    pub(super) at: Vector,
    /// Unit vector, from the second thing to the first.
    pub(super) normal: Vector,
    /// m.
    pub(super) depth: f64,
}

/// The spring of friction of one contact: how far it is stretched, in m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bristle(f64);

impl Bristle {
    /// Of what does not touch.
    pub(super) const NONE: Self = Bristle(0.0);

    /// The force on the first thing in the middle of a step of `dt` s, where it moves at `velocity`
    /// (m/s) past the second: N. Without overlap there is none, and friction forgets.
    #[inline]
    pub(super) fn press(
        &mut self,
        overlap: Option<Overlap>,
        velocity: impl FnOnce(Vector) -> Vector,
        Law { stiffness, damping }: Law,
        friction: f64,
        dt: f64,
    ) -> Option<Push> {
        let Some(Overlap { at, normal, depth }) = overlap else {
            self.0 = 0.0;
            return None;
        };
        let velocity = velocity(at);
        let push = (stiffness * depth - damping * velocity.dot(&normal)).max(0.0);
        let tangent = Vector::new(-normal.y, normal.x);
        let slip = velocity.dot(&tangent);
        let most = friction * push;
        let middle = self.0 + slip * dt / 2.0;
        self.0 = within(self.0 + slip * dt, most / stiffness);
        let drag = within(-stiffness * middle - damping * slip, most);
        Some(Push {
            at,
            force: normal * push + tangent * drag,
        })
    }
}

/// A force at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Push {
    /// m.
    pub(super) at: Vector,
    /// N.
    pub(super) force: Vector,
}

#[inline]
fn within(value: f64, most: f64) -> f64 {
    value.max(-most).min(most)
}
