//! Two links in a plane: the triangle of the links and the line between their ends (Craig,
//! *Introduction to Robotics*, ch. 4.4).

use super::chain::RADIANS_PER_DEGREE;
use nalgebra::Vector2;

/// Tolerance for a place that rounding puts beyond full stretch, as a cosine.
const STRETCH: f64 = 1e-12;

/// Two links at angle 0, mm.
#[derive(Clone, Copy)]
pub(super) struct TwoLinks {
    pub(super) first: Vector2<f64>,
    pub(super) second: Vector2<f64>,
}

impl TwoLinks {
    /// Returns the bend of the second link to the left of the first one at angle 0, deg.
    pub(super) fn unbent(&self) -> f64 {
        let (a, b) = (self.first, self.second);
        libm::atan2(a.perp(&b), a.dot(&b)) / RADIANS_PER_DEGREE
    }

    /// Returns the turns of the links to the left (deg) that lead to `reach` (mm), with the second
    /// one bent to the side of `side`; `None` if the links do not reach it.
    pub(super) fn turns(&self, reach: Vector2<f64>, side: f64) -> Option<[f64; 2]> {
        let (a, b) = (self.first, self.second);
        let (long, short) = (a.norm(), b.norm());
        let cosine = (reach.norm_squared() - long * long - short * short) / (2.0 * long * short);
        if !(-1.0 - STRETCH..=1.0 + STRETCH).contains(&cosine) {
            return None;
        }
        let bent = libm::copysign(libm::acos(cosine.clamp(-1.0, 1.0)), side);
        // In the frame of the first link, the second one goes on in its direction but for the bend.
        let (sin, cos) = libm::sincos(bent);
        let ahead = libm::atan2(short * sin, long + short * cos);
        let turned = libm::atan2(reach.y, reach.x) - libm::atan2(a.y, a.x) - ahead;
        Some([
            turned / RADIANS_PER_DEGREE,
            bent / RADIANS_PER_DEGREE - self.unbent(),
        ])
    }
}
