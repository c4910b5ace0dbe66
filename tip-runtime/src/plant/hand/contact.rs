//! Contacts of the simulated hand: their law, and the history of a link and a body that are near each other.
//!
//! Normal to their surfaces: a spring and a damper that push and never pull. Along them: Coulomb
//! friction by a spring that is stretched as they move past each other, and slides where it would
//! pull more than friction holds (Cundall and Strack, *A discrete numerical model for granular
//! assemblies*, Géotechnique 29, 1979). A stuck contact therefore does not creep.
//!
//! By its history neither leaves through the other: not when they are pressed deeper into each other than half of the
//! thinner one, and not when they pass each other within one step.

use super::Vector;
use crate::plant::ContactLaw;

/// Mass from which a body counts as heavy; fingers count as no heavier, kg.
pub(super) const HEAVY: f64 = 0.2;

/// Greatest factor by which heavier bodies make contacts stiffer, so that no force overflows.
const HEAVIEST: f64 = 1e9;

/// Stiffness for masses up to `HEAVY`, N/m. It grows in proportion to heavier masses, so that they
/// rest as deep.
const STIFFNESS: f64 = 5000.0;

/// Damping for a mass of `HEAVY`, N·s/m.
const DAMPING: f64 = 15.0;

impl ContactLaw {
    /// The law of fingers on the floor, and on heavy bodies.
    pub(super) const FINGER: Self = ContactLaw {
        stiffness: STIFFNESS,
        damping: DAMPING,
    };

    /// Returns the law for the lighter body's mass (kg). Every mass oscillates alike, since its
    /// damping ratio on one contact is the same: 0.24.
    pub(super) fn of_body(mass: f64) -> Self {
        let share = (mass / HEAVY).min(HEAVIEST);
        ContactLaw {
            stiffness: STIFFNESS * share.max(1.0),
            damping: DAMPING * share.max(libm::sqrt(share)),
        }
    }

    /// Returns the frequency of oscillation of a mass, rad/s.
    pub(super) fn frequency(self, mass: f64) -> f64 {
        libm::sqrt(self.stiffness / mass)
    }
}

/// The overlap of two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Overlap {
    /// Position, m.
    pub(super) at: Vector,
    /// Unit vector, from the second body to the first.
    pub(super) normal: Vector,
    /// Depth, m.
    pub(super) depth: f64,
}

/// The stretch of a contact's friction spring, m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bristle(f64);

impl Bristle {
    /// The bristle of a free point.
    pub(super) const NONE: Self = Bristle(0.0);

    /// Returns the force on the first body in the middle of a step of `dt` s, where it moves at
    /// `velocity` (m/s) past the second. Without overlap there is no force, and the bristle is
    /// reset.
    #[inline]
    pub(super) fn press(
        &mut self,
        overlap: Option<Overlap>,
        velocity: impl FnOnce(Vector) -> Vector,
        law: ContactLaw,
        friction: f64,
        dt: f64,
    ) -> Option<Push> {
        let Some(Overlap { at, normal, depth }) = overlap else {
            self.0 = 0.0;
            return None;
        };
        let velocity = velocity(at);
        let push = law.push(depth, velocity.dot(&normal));
        let tangent = Vector::new(-normal.y, normal.x);
        let slip = velocity.dot(&tangent);
        let most = friction * push;
        let ContactLaw { stiffness, damping } = law;
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
    /// Position, m.
    pub(super) at: Vector,
    /// Force, N.
    pub(super) force: Vector,
}

/// Limits a value to ±`most`.
#[inline]
pub(super) fn within(value: f64, most: f64) -> f64 {
    value.max(-most).min(most)
}

/// One of the four faces of a box, by the sign of the direction out of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Face {
    /// Along the width.
    Side(f64),
    /// Along the height.
    End(f64),
}

impl Face {
    pub(super) const fn opposite(self) -> Self {
        match self {
            Face::Side(sign) => Face::Side(-sign),
            Face::End(sign) => Face::End(-sign),
        }
    }
}

/// The contact history of a link and a body that are near each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ContactHistory {
    /// The side of the link on which the body is, or was before it came through: +1 where a quarter
    /// turn from the link points, −1 on the other side, 0 if unknown.
    pub(super) side: f64,
    /// The face of a box through which the link's end came, or would come, if known.
    pub(super) face: Option<Face>,
}

impl ContactHistory {
    /// The history of a pair that has not been near each other.
    pub(super) const UNKNOWN: Self = ContactHistory {
        side: 0.0,
        face: None,
    };

    /// Returns true if the body is known from the other side.
    #[inline]
    pub(super) fn is_other(&self, side: f64) -> bool {
        self.side == -side
    }

    /// Returns true if a body, whose centre is on `side` now, has come through the link. It can
    /// only do so while it is `is_beside` the link; elsewhere it goes round the link's ends.
    #[inline]
    pub(super) fn is_through(&mut self, side: f64, is_beside: bool) -> bool {
        if !is_beside || self.side == 0.0 {
            self.side = side;
        }
        self.is_other(side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_comes_through_a_link_but_not_round_its_end() {
        let mut history = ContactHistory::UNKNOWN;
        assert!(!history.is_through(1.0, true));
        assert!(history.is_through(-1.0, true) && history.is_through(-1.0, true));
        assert!(!history.is_through(1.0, true), "it is back");
        assert!(!history.is_through(-1.0, false), "it went round");
        assert!(!history.is_through(-1.0, true));
    }
}
