//! What two things do to each other where they overlap.
//!
//! Normal to their surfaces: a spring and a damper that push and never pull. Along them: Coulomb
//! friction by a spring that is stretched as they move past each other, and slides where it would
//! pull more than friction holds (Cundall and Strack, *A discrete numerical model for granular
//! assemblies*, Géotechnique 29, 1979). A stuck contact therefore does not creep.

use super::Vector;

/// Of every contact, along and across: N/m.
pub(super) const STIFFNESS: f64 = 5000.0;

/// Of every contact, along and across: N·s/m.
const DAMPING: f64 = 15.0;

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
    /// The force on the first thing, which moves at `velocity` (m/s) past the second, for the next
    /// `dt` s: N. Without overlap there is none, and friction forgets.
    pub(super) fn press(
        &mut self,
        overlap: Option<Overlap>,
        velocity: impl FnOnce(Vector) -> Vector,
        friction: f64,
        dt: f64,
    ) -> Option<Push> {
        let Some(Overlap { at, normal, depth }) = overlap else {
            self.0 = 0.0;
            return None;
        };
        let velocity = velocity(at);
        let push = (STIFFNESS * depth - DAMPING * velocity.dot(&normal)).max(0.0);
        let tangent = Vector::new(-normal.y, normal.x);
        let slip = velocity.dot(&tangent);
        let most = friction * push;
        let stretch = self.0 + slip * dt;
        self.0 = within(stretch, most / STIFFNESS);
        let drag = within(-STIFFNESS * stretch - DAMPING * slip, most);
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
