//! Watches the centre of mass over the support polygon.

use super::Vector;
use super::contacts::Contacts;
use super::polygon;

/// How far outside the polygon the centre of mass may be before the body tips: mm.
pub(super) const TIPPING: f64 = 1.0;

/// The centre of mass left the support polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fall {
    /// The control cycle, from 0.
    pub cycle: u64,
    /// How far outside the centre of mass was: mm, negative.
    pub margin: f64,
}

/// What carries the robot, seen along its z axis: the standing feet, judged in the robot frame, since a body that
/// tips follows the feet that were lifted, so being on the floor proves nothing. The belly belongs to it as soon as
/// it carries.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polygon<const L: usize> {
    /// How high the lowest foot is: mm.
    lowest: f64,
    /// The first so many are those of standing feet.
    places: [[f64; 2]; L],
    standing: usize,
    belly: Option<[[f64; 2]; 4]>,
}

impl<const L: usize> Polygon<L> {
    /// Of feet no more than `lift` mm above the lowest one.
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

    /// Where the line from a point along `down` meets the height of the feet: mm.
    pub(super) fn under(&self, point: Vector, down: Vector) -> [f64; 2] {
        let fall = (self.lowest - point.z) / down.z;
        [point.x + fall * down.x, point.y + fall * down.y]
    }

    /// How far inside a place is: mm; negative outside.
    pub(super) fn margin(&self, over: [f64; 2]) -> f64 {
        match self.belly {
            Some(belly) => polygon::margin(self.feet().chain(belly), over),
            None => self.margin_of_feet(over),
        }
    }

    /// The same without the belly.
    fn margin_of_feet(&self, over: [f64; 2]) -> f64 {
        polygon::margin(self.feet(), over)
    }

    fn feet(&self) -> impl Iterator<Item = [f64; 2]> + Clone + '_ {
        self.places.iter().take(self.standing).copied()
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct FallWatch {
    /// Feet no more than this above the lowest count as standing: mm.
    pub(super) lift: f64,
    pub(super) margin: f64,
    /// The least margin so far: mm.
    pub(super) least: f64,
    pub(super) count: u32,
    pub(super) first: Option<Fall>,
    falling: bool,
    /// Whether the belly carried at the instant before.
    lay: bool,
}

impl FallWatch {
    pub(super) const fn new() -> Self {
        FallWatch {
            lift: 20.0,
            margin: 0.0,
            least: f64::INFINITY,
            count: 0,
            first: None,
            falling: false,
            lay: true,
        }
    }

    /// Looks at one instant. A body that comes to lie although its feet could not have held it has tipped.
    /// `down` is the direction of gravity.
    pub(super) fn watch<const L: usize>(
        &mut self,
        polygon: &Polygon<L>,
        centre: Vector,
        down: Vector,
        cycle: u64,
    ) {
        let over = polygon.under(centre, down);
        let on_feet = polygon.margin_of_feet(over);
        let lies = polygon.belly.is_some();
        self.margin = if lies { polygon.margin(over) } else { on_feet };
        self.least = self.least.min(self.margin);
        let came_to_lie = lies && !self.lay;
        self.lay = lies;
        let tips = self.margin < -TIPPING || (came_to_lie && on_feet < 0.0);
        self.count_fall(cycle, tips, lies, on_feet);
    }

    /// A fall lasts until the body stands on its feet alone again.
    fn count_fall(&mut self, cycle: u64, tips: bool, lies: bool, margin: f64) {
        if !tips {
            self.falling &= lies;
        } else if !self.falling {
            self.falling = true;
            self.count += 1;
            self.first.get_or_insert(Fall { cycle, margin });
        }
    }
}
