//! The contact law of the simulated hand.
//!
//! Normal to their surfaces: a spring and a damper that push and never pull. Along them: Coulomb
//! friction by a spring that is stretched as they move past each other, and slides where it would
//! pull more than friction holds (Cundall and Strack, *A discrete numerical model for granular
//! assemblies*, Géotechnique 29, 1979). A stuck contact therefore does not creep.

use super::Vector;

/// Stiffness and damping of a contact, along its normal and across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ContactLaw {
    /// N/m.
    stiffness: f64,
    /// N·s/m.
    damping: f64,
}

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
    pub(super) fn of(mass: f64) -> Self {
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
        ContactLaw { stiffness, damping }: ContactLaw,
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
    /// Position, m.
    pub(super) at: Vector,
    /// Force, N.
    pub(super) force: Vector,
}

#[inline]
fn within(value: f64, most: f64) -> f64 {
    value.max(-most).min(most)
}
