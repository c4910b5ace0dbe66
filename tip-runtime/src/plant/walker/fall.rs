//! Watches the centre of mass over the support polygon.

use super::Vector;
use super::contacts::Contacts;
use super::polygon;

/// How far outside the polygon the centre of mass may be before the body tips: mm.
const TIPPING: f64 = 1.0;

/// The centre of mass left the support polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fall {
    /// The control cycle, from 0.
    pub cycle: u64,
    /// How far outside the centre of mass was: mm, negative.
    pub margin: f64,
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

    /// Looks at one instant. The polygon is that of the standing feet, judged in the robot frame:
    /// a body that tips follows the feet that were lifted, so being on the floor proves nothing.
    /// The belly belongs to it as soon as it carries; a body that comes to lie although its feet could
    /// not have held it has tipped. `down` is the direction of gravity.
    pub(super) fn watch<const L: usize>(
        &mut self,
        points: &Contacts<Vector, L>,
        loads: &Contacts<f64, L>,
        centre: Vector,
        down: Vector,
        cycle: u64,
    ) {
        let heights = points.feet.iter().map(|foot| foot.z);
        let lowest = heights.fold(f64::INFINITY, f64::min);
        let standing = (points.feet.iter()).filter(|foot| foot.z <= lowest + self.lift);
        let mut places = [[0.0; 2]; L];
        let count = places
            .iter_mut()
            .zip(standing)
            .fold(0, |count, (place, foot)| {
                *place = [foot.x, foot.y];
                count + 1
            });
        let feet = places.iter().take(count).copied();
        let fall = (lowest - centre.z) / down.z;
        let over = [centre.x + fall * down.x, centre.y + fall * down.y];
        let on_feet = polygon::margin(feet.clone(), over);
        let lies = loads.belly.iter().any(|load| *load > 0.0);
        self.margin = if lies {
            let belly = points.belly.iter().map(|point| [point.x, point.y]);
            polygon::margin(feet.chain(belly), over)
        } else {
            on_feet
        };
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
