//! What a robot without mass does not know of itself: counted, so that it can be said.

use super::Vector;
use super::fall::{Polygon, TIPPING};
use super::links::GRAVITY;
use super::path::Following;

/// Over how much time accelerations are taken at least: s. Over less, feet that come to carry would look like blows.
const SPAN: f64 = 0.02;

/// A share of gravity: a robot that presses down by less flies.
const FLYING: f64 = 0.05;

/// What a quasi-static robot leaves out. Where a count is above 0 or a margin below, its mass would have mattered: see
/// the simulation with [dynamics](crate::plant). Counts are of control cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Unmodelled {
    /// How far inside the support polygon the zero moment point is: mm; negative outside. It follows from the second
    /// differences of the centre of mass over 20 ms or the sampling time, whichever is longer.
    pub zmp_margin: f64,
    /// The least that this margin has been so far: mm.
    pub least_zmp_margin: f64,
    /// In how many cycles the zero moment point was outside although the centre of mass was inside.
    pub tips: u32,
    /// In how many cycles the friction of the floor would not have held the feet.
    pub slides: u32,
    /// In how many cycles a joint was below the floor, a leg or the body in a block, or a leg in another one.
    pub crossings: u32,
}

impl Unmodelled {
    /// Whether nothing was left out that would have mattered.
    pub const fn is_empty(&self) -> bool {
        self.tips == 0 && self.slides == 0 && self.crossings == 0
    }
}

/// Events of a cycle that are counted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Oddities {
    pub(super) crosses: bool,
    pub(super) hurries: bool,
    /// The farthest that a foot is beside its path: mm.
    pub(super) stray: f64,
}

impl Oddities {
    /// What either leg does.
    pub(super) fn and(self, other: Self) -> Self {
        Oddities {
            crosses: self.crosses || other.crosses,
            hurries: self.hurries || other.hurries,
            stray: self.stray.max(other.stray),
        }
    }
}

/// Counts what is left out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doubts {
    /// Of the floor.
    pub(super) friction: f64,
    pub(super) counted: Unmodelled,
    pub(super) following: Following,
    /// The last two places of the centre of mass in the floor's frame (mm), the later one first.
    places: [Option<Vector>; 2],
    /// How long ago the later one was: s.
    since: f64,
    /// Its acceleration: mm/s².
    acceleration: Vector,
    tips: bool,
    slides: bool,
}

impl Doubts {
    pub(super) const fn new(friction: f64) -> Self {
        Doubts {
            friction,
            counted: Unmodelled {
                zmp_margin: 0.0,
                least_zmp_margin: f64::INFINITY,
                tips: 0,
                slides: 0,
                crossings: 0,
            },
            following: Following::NONE,
            places: [None; 2],
            since: 0.0,
            acceleration: Vector::new(0.0, 0.0, 0.0),
            tips: false,
            slides: false,
        }
    }

    /// The centre of mass is at `centre` (mm, in the floor's frame) after another `dt` s.
    pub(super) fn moved(&mut self, centre: Vector, dt: f64) {
        self.since += dt;
        // Rounding aside.
        if self.since < SPAN * (1.0 - 1e-9) {
            return;
        }
        if let [Some(last), Some(before)] = self.places {
            self.acceleration = (centre - last * 2.0 + before) / (self.since * self.since);
        }
        self.places = [Some(centre), self.places[0]];
        self.since = 0.0;
    }

    /// Judges one instant. All vectors are in the robot's frame but `gravity`, the direction of gravity in the
    /// floor's, where z is along the floor's normal; `to_robot` leads from one to the other.
    pub(super) fn judge<const L: usize>(
        &mut self,
        polygon: &Polygon<L>,
        centre: Vector,
        (gravity, is_carried): (Vector, bool),
        to_robot: impl Fn(Vector) -> Vector,
        margin: f64,
    ) {
        let pull = gravity * (GRAVITY * 1000.0) - self.acceleration;
        if !is_carried || -pull.z <= FLYING * GRAVITY * 1000.0 {
            return;
        }
        let along = libm::hypot(pull.x, pull.y);
        self.slides |= along > self.friction * -pull.z;
        let zmp = polygon.margin(polygon.under(centre, to_robot(pull)));
        self.counted.zmp_margin = zmp;
        self.counted.least_zmp_margin = self.counted.least_zmp_margin.min(zmp);
        self.tips |= zmp < -TIPPING && margin >= 0.0;
    }

    /// What has been counted so far was before the beginning.
    pub(super) fn begin(&mut self) {
        *self = Doubts::new(self.friction);
    }

    /// A cycle is over.
    pub(super) fn close(&mut self, oddities: &Oddities) {
        let counted = &mut self.counted;
        counted.tips += u32::from(self.tips);
        counted.slides += u32::from(self.slides);
        counted.crossings += u32::from(oddities.crosses);
        self.following.count(oddities.hurries, oddities.stray);
        (self.tips, self.slides) = (false, false);
    }
}
