//! Distribution of the mass of a link or a body.

use super::{Point, Range};

/// Centre of mass and inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Centre of mass, mm: of a link from its joint on, of a body in the robot frame.
    pub centre: Point,
    /// The elements xx, yy, zz, xy, xz and yz of the tensor of inertia about that centre: kg·m². Its axes are those of the link's
    /// frame, which is parallel to the robot frame while all joints are at 0.
    pub inertia: [f64; 6],
}

/// Relative rounding error of a tensor.
const SLIGHT: f64 = 1e-9;

impl Spread {
    /// Spreads a mass evenly along a rod from the joint to the end of `link` (mm).
    #[must_use]
    pub const fn rod(link: [f64; 3], mass: f64) -> Self {
        let [x, y, z] = link;
        let share = mass / 12.0 * 1e-6;
        Spread {
            centre: [x / 2.0, y / 2.0, z / 2.0],
            inertia: [
                share * (y * y + z * z),
                share * (x * x + z * z),
                share * (x * x + y * y),
                -share * x * y,
                -share * x * z,
                -share * y * z,
            ],
        }
    }

    /// Spreads a mass evenly in a box with these extents (mm), its centre taken to be in the
    /// origin.
    #[must_use]
    pub const fn block([x, y, z]: [Range; 3], mass: f64) -> Self {
        let (x, y, z) = (x.max - x.min, y.max - y.min, z.max - z.min);
        let share = mass / 12.0 * 1e-6;
        Spread {
            centre: [0.0; 3],
            inertia: [
                share * (y * y + z * z),
                share * (x * x + z * z),
                share * (x * x + y * y),
                0.0,
                0.0,
                0.0,
            ],
        }
    }

    /// Returns true if all its numbers are finite, and some rigid body has such an inertia.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let numbers = self.centre.iter().chain(&self.inertia);
        numbers.into_iter().all(|number| number.is_finite()) && is_of_a_body(self.inertia)
    }
}

/// Returns true if the second moments of mass that such a tensor comes from are not negative in any
/// direction. Its principal moments are not negative then, and none is greater than the other two
/// together.
fn is_of_a_body([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> bool {
    let half = (xx + yy + zz) / 2.0;
    let (x, y, z) = (half - xx, half - yy, half - zz);
    let (a, b, c) = (-xy, -xz, -yz);
    let pairs = [x * y - a * a, x * z - b * b, y * z - c * c];
    let all = x * y * z + 2.0 * a * b * c - x * c * c - y * b * b - z * a * a;
    let slight = SLIGHT * half;
    [x, y, z].into_iter().all(|moment| moment >= -slight)
        && pairs.into_iter().all(|pair| pair >= -slight * half)
        && all >= -slight * half * half
}
