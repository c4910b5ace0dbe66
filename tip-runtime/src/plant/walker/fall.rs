//! Fall detection: one definition for robots without mass and with it, and the margin of a point in a convex hull.

use super::Vector;
use super::support::Contacts;

/// Distance of the centre of mass outside the polygon from which the body tips, mm.
pub(super) const TIPPING: f64 = 1.0;

/// Cosine of the greatest tilt of a body that lies flat on the ground: 2 deg.
const FLAT: f64 = 0.999_390_827_019_095_8;
/// Cosine of the tilt from which a body that touches the ground has fallen, and from which lifted
/// feet do not hold it: 5 deg.
pub(in crate::plant) const TILTED: f64 = 0.996_194_698_091_745_5;
/// Cosine of the tilt from which a body has fallen whatever it touches: 60 deg.
const LEANING: f64 = 0.5;

/// A fall: the body came down, or lost its support.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fall {
    /// The control cycle, from 0.
    pub cycle: u64,
    /// Distance of the centre of mass from the edge of the support polygon, mm; negative outside.
    pub margin: f64,
    /// True if the body was upright: it had lost its support, and a robot without mass does not
    /// come down by that.
    pub is_upright: bool,
}

/// The posture of a robot at one instant.
#[derive(Clone, Copy, Debug)]
pub(in crate::plant) struct Posture {
    /// The body touches the ground.
    pub(in crate::plant) lies: bool,
    /// Cosine of the angle from the floor's normal to the body's z axis.
    pub(in crate::plant) uprightness: f64,
    /// The feet alone hold the centre of mass.
    pub(in crate::plant) is_held: bool,
    /// The robot has lost its support.
    pub(in crate::plant) is_lost: bool,
    /// The robot stands on its feet alone, and has got up if it had fallen.
    pub(in crate::plant) is_up: bool,
    /// Distance of the centre of mass from the edge of the support polygon, mm; negative outside.
    pub(in crate::plant) margin: f64,
}

/// A counter of falls. A robot falls when
///
/// - its body leans by more than 60 deg from the floor's normal,
/// - its body comes to touch the ground tilted by more than 5 deg, or while its feet do not hold it, or
/// - its support is lost, which leaves the body upright at first.
///
/// A robot that has lain down flat may move there freely until it has got up again.
#[derive(Clone, Copy, Debug)]
pub(in crate::plant) struct FallCounter {
    pub(in crate::plant) count: u32,
    /// Number of falls that brought the body down.
    down: u32,
    pub(in crate::plant) first: Option<Fall>,
    is_falling: bool,
    /// The body has come down in the present fall.
    is_down: bool,
    /// The robot has lain flat and not got up since.
    lay: bool,
    /// The feet held the robot at the previous instant.
    was_held: bool,
}

impl FallCounter {
    pub(in crate::plant) const NONE: Self = FallCounter {
        count: 0,
        down: 0,
        first: None,
        is_falling: false,
        is_down: false,
        lay: true,
        was_held: true,
    };

    /// Returns the number of falls that left the body upright.
    pub(in crate::plant) const fn upright(&self) -> u32 {
        self.count - self.down
    }

    /// Updates the counter at the end of a cycle. A fall lasts until the robot has got up.
    pub(in crate::plant) fn update(&mut self, posture: &Posture, cycle: u64) {
        let Posture {
            lies, uprightness, ..
        } = *posture;
        let is_flat = uprightness >= FLAT;
        // Feet that lower a body to the floor leave it as it touches.
        let is_lowered = posture.is_held || (is_flat && self.was_held);
        let drops = lies && !self.lay && (!is_lowered || uprightness < TILTED);
        let comes_down = drops || uprightness < LEANING;
        self.was_held = posture.is_held;
        self.lay = (lies && is_flat) || (self.lay && !posture.is_up);
        if !comes_down && !posture.is_lost {
            self.is_falling &= !posture.is_up;
            return;
        }
        if !self.is_falling {
            (self.is_falling, self.is_down) = (true, false);
            self.count += 1;
            self.first.get_or_insert(Fall {
                cycle,
                margin: posture.margin,
                is_upright: !comes_down,
            });
        }
        if comes_down && !self.is_down {
            self.is_down = true;
            self.down += 1;
        }
    }
}

/// The support polygon, seen along the robot's z axis: the standing feet, judged in the robot
/// frame, since a body that tips follows its lifted feet, so contact with the floor proves nothing.
/// The belly belongs to the polygon as soon as it carries load.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polygon<const L: usize> {
    /// Height of the lowest foot, mm.
    lowest: f64,
    /// Positions; the first `standing` ones are those of standing feet.
    places: [[f64; 2]; L],
    standing: usize,
    belly: Option<[[f64; 2]; 4]>,
}

impl<const L: usize> Polygon<L> {
    /// Returns the polygon of feet no more than `lift` mm above the lowest one.
    pub(super) fn new(points: &Contacts<Vector, L>, loads: &Contacts<f64, L>, lift: f64) -> Self {
        let heights = points.feet.iter().map(|foot| foot.z);
        let lowest = heights.fold(f64::INFINITY, f64::min);
        let standing = (points.feet.iter()).filter(|foot| foot.z <= lowest + lift);
        let mut places = [[0.0; 2]; L];
        let standing = places
            .iter_mut()
            .zip(standing)
            .fold(0, |count, (place, foot)| {
                *place = [foot.x, foot.y];
                count + 1
            });
        let lies = loads.belly.iter().any(|load| *load > 0.0);
        Polygon {
            lowest,
            places,
            standing,
            belly: lies.then(|| points.belly.map(|point| [point.x, point.y])),
        }
    }

    /// Returns where the line from a point along `down` meets the height of the feet, mm.
    pub(super) fn under(&self, point: Vector, down: Vector) -> [f64; 2] {
        let fall = (self.lowest - point.z) / down.z;
        [point.x + fall * down.x, point.y + fall * down.y]
    }

    /// Returns the distance of a place from the edge, mm; negative outside.
    pub(super) fn margin(&self, over: [f64; 2]) -> f64 {
        match self.belly {
            Some(belly) => hull_margin(self.feet().chain(belly), over),
            None => self.margin_of_feet(over),
        }
    }

    /// Returns the margin without the belly.
    fn margin_of_feet(&self, over: [f64; 2]) -> f64 {
        hull_margin(self.feet(), over)
    }

    fn feet(&self) -> impl Iterator<Item = [f64; 2]> + Clone + '_ {
        self.places.iter().take(self.standing).copied()
    }
}

/// A monitor of the centre of mass over the support polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct SupportMonitor {
    /// Height above the lowest foot up to which feet count as standing, mm.
    pub(super) lift: f64,
    pub(super) margin: f64,
    /// The least margin so far, mm.
    pub(super) least: f64,
    pub(super) falls: FallCounter,
}

impl SupportMonitor {
    pub(super) const fn new() -> Self {
        SupportMonitor {
            lift: 20.0,
            margin: 0.0,
            least: f64::INFINITY,
            falls: FallCounter::NONE,
        }
    }

    /// Updates the monitor. `down` is the direction of gravity, `normal` that of the floor.
    pub(super) fn update<const L: usize>(
        &mut self,
        polygon: &Polygon<L>,
        centre: Vector,
        (down, normal): (Vector, Vector),
        cycle: u64,
    ) {
        let over = polygon.under(centre, down);
        let on_feet = polygon.margin_of_feet(over);
        let lies = polygon.belly.is_some();
        self.margin = if lies { polygon.margin(over) } else { on_feet };
        self.least = self.least.min(self.margin);
        let posture = Posture {
            lies,
            uprightness: normal.z,
            is_held: on_feet >= 0.0,
            is_lost: self.margin < -TIPPING,
            is_up: !lies,
            margin: on_feet,
        };
        self.falls.update(&posture, cycle);
    }
}

/// Returns the distance of `inner` from the nearest edge of the hull, negative outside. Points on
/// one line have a hull without inside.
pub(in crate::plant) fn hull_margin(
    hull: impl Iterator<Item = [f64; 2]> + Clone,
    inner: [f64; 2],
) -> f64 {
    let inside = height_over_edges(hull.clone(), inner);
    if inside.is_finite() && inside > 0.0 {
        inside
    } else {
        -distance_to_segments(hull, inner)
    }
}

/// Returns the least distance of `inner` on the inner side of every edge of the hull; infinite
/// without edges.
fn height_over_edges(hull: impl Iterator<Item = [f64; 2]> + Clone, inner: [f64; 2]) -> f64 {
    let mut least = f64::INFINITY;
    for from in hull.clone() {
        for to in hull.clone() {
            if from != to && hull.clone().all(|point| side(from, to, point) >= -1e-6) {
                let length = libm::hypot(to[0] - from[0], to[1] - from[1]);
                if length > 0.0 {
                    least = least.min(side(from, to, inner) / length);
                }
            }
        }
    }
    least
}

/// Returns the distance of `inner` from the nearest segment between any two points.
fn distance_to_segments(points: impl Iterator<Item = [f64; 2]> + Clone, inner: [f64; 2]) -> f64 {
    let mut least = f64::INFINITY;
    for from in points.clone() {
        for to in points.clone() {
            least = least.min(distance(from, to, inner));
        }
    }
    least
}

/// Returns the distance of a point from the segment between two others.
fn distance(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> f64 {
    let (way, off) = (
        [to[0] - from[0], to[1] - from[1]],
        [point[0] - from[0], point[1] - from[1]],
    );
    let square = way[0] * way[0] + way[1] * way[1];
    let share = if square > 0.0 {
        ((way[0] * off[0] + way[1] * off[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    libm::hypot(off[0] - share * way[0], off[1] - share * way[1])
}

/// Returns twice the area of a triangle; positive if `point` is on the left of the path.
fn side(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> f64 {
    (to[0] - from[0]) * (point[1] - from[1]) - (to[1] - from[1]) * (point[0] - from[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 5] = [
        [0.0, 0.0],
        [10.0, 10.0],
        [10.0, 0.0],
        [4.0, 5.0],
        [0.0, 10.0],
    ];

    fn margin_of(points: &[[f64; 2]], inner: [f64; 2]) -> f64 {
        hull_margin(points.iter().copied(), inner)
    }

    #[test]
    fn the_nearest_edge_counts_and_inner_points_do_not() {
        assert_eq!(margin_of(&SQUARE, [5.0, 5.0]), 5.0);
        assert_eq!(margin_of(&SQUARE, [9.0, 4.0]), 1.0);
        assert_eq!(margin_of(&SQUARE, [5.0, 0.0]), 0.0);
        assert_eq!(margin_of(&SQUARE, [5.0, -3.0]), -3.0);
        assert_eq!(margin_of(&SQUARE, [-3.0, -4.0]), -5.0);
    }

    #[test]
    fn lines_and_points_have_no_inside() {
        assert_eq!(margin_of(&[[0.0, 0.0], [0.0, 8.0]], [3.0, 4.0]), -3.0);
        assert_eq!(margin_of(&[[0.0, 0.0], [0.0, 8.0]], [3.0, 12.0]), -5.0);
        assert_eq!(margin_of(&[[0.0, 0.0], [0.0, 8.0]], [0.0, 20.0]), -12.0);
        assert_eq!(margin_of(&[[0.0, 0.0]], [3.0, 4.0]), -5.0);
    }
}
