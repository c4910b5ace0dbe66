//! The shared state of a time step.

use super::contact::Law;
use super::frame::Frame;
use super::servo::{Drives, Stride};
use super::spatial::{Inertia, Spatial};
use super::terrain::Terrain;

/// Standard gravity: m/s² (3rd CGPM, 1901).
pub(super) const GRAVITY: f64 = 9.80665;

/// The frame of the body, its surroundings, the motors, and the time step.
#[derive(Clone, Copy, Debug)]
pub(super) struct World<'a> {
    pub(super) frame: &'a Frame,
    pub(super) drives: &'a Drives,
    pub(super) law: &'a Law,
    /// The terrain; `None` around a robot that is bolted down.
    pub(super) terrain: Option<&'a Terrain>,
    pub(super) stride: &'a Stride,
}

/// The contribution of a leg or the body to the robot: its inertia, and the force that sustains its
/// motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Share {
    pub(super) inertia: Inertia,
    pub(super) force: Spatial,
}

impl Share {
    pub(super) const NONE: Self = Share {
        inertia: Inertia::NONE,
        force: Spatial::ZERO,
    };

    #[inline]
    pub(super) fn add(&mut self, other: Share) {
        self.inertia += other.inertia;
        self.force += other.force;
    }
}
