//! The names and frames that exported files have, and imported ones may have.

use crate::body::Limb;
use tip_runtime::model::{Point, Range};

/// Where robots are bolted down.
pub(super) const WORLD: &str = "world";
/// The robot frame.
pub(super) const BASE: &str = "base_link";
/// What the legs of a walking robot carry.
pub(super) const BODY: &str = "body";
/// What the slider carries.
pub(super) const FLOOR: &str = "floor";

/// A place of the robot frame (mm; x to the right, y forward) in URDF's: m; x forward, y left.
pub(super) fn metres(at: Point) -> [f64; 3] {
    direction(at).map(|mm| mm / 1000.0)
}

/// A direction of the robot frame in URDF's.
pub(super) fn direction([right, forward, up]: [f64; 3]) -> [f64; 3] {
    [forward, -right, up]
}

/// What holds every first joint, and `more` (mm) on each side of them.
pub(super) fn around(legs: &[Limb], more: f64) -> [Range; 3] {
    [0, 1, 2].map(|axis| {
        let along = || legs.iter().map(|leg| leg.base[axis]);
        Range::new(
            along().fold(0.0, f64::min) - more,
            along().fold(0.0, f64::max) + more,
        )
    })
}

pub(super) fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
