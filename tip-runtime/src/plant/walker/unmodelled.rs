//! Counts of the effects that a robot without mass leaves out.

use super::Vector;
use super::fall::{Polygon, TIPPING};
use super::links::GRAVITY;
use super::tracking::TrackingErrors;

/// The shortest time over which accelerations are taken, s. Over a shorter one, feet that come to
/// carry load would look like impacts.
const SPAN: f64 = 0.02;

/// Share of gravity below which a robot that presses down is in flight.
const FLYING: f64 = 0.05;

/// The effects that a quasi-static robot leaves out. Where a count is above 0 or a margin below,
/// its mass would have mattered: see the simulation with [dynamics](crate::plant). Counts are of
/// control cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Unmodelled {
    /// Distance of the zero moment point from the edge of the support polygon, mm; negative
    /// outside. It follows from the second differences of the centre of mass over 20 ms or the
    /// sampling time, whichever is longer.
    pub zmp_margin: f64,
    /// The least distance so far, mm.
    pub least_zmp_margin: f64,
    /// Number of cycles in which the zero moment point was outside although the centre of mass was
    /// inside.
    pub tips: u32,
    /// Number of cycles in which the friction of the floor would not have held the feet.
    pub slides: u32,
    /// Number of cycles in which a joint was below the floor, a leg or the body in a block, or a
    /// leg in another one.
    pub crossings: u32,
}

impl Unmodelled {
    /// Returns true if no unmodelled effect would have mattered.
    pub const fn is_empty(&self) -> bool {
        self.tips == 0 && self.slides == 0 && self.crossings == 0
    }
}

/// The counted events of a cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct CycleEvents {
    pub(super) crosses: bool,
    pub(super) hurries: bool,
    /// The greatest distance of a foot from its path, mm.
    pub(super) stray: f64,
}

impl CycleEvents {
    /// Merges the events of two legs.
    pub(super) fn and(self, other: Self) -> Self {
        CycleEvents {
            crosses: self.crosses || other.crosses,
            hurries: self.hurries || other.hurries,
            stray: self.stray.max(other.stray),
        }
    }
}

/// A counter of unmodelled effects.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnmodelledCounter {
    /// The coefficient of Coulomb friction of the floor.
    pub(super) friction: f64,
    pub(super) counted: Unmodelled,
    pub(super) tracking_errors: TrackingErrors,
    /// The last two positions of the centre of mass in the floor's frame (mm), the later one first.
    places: [Option<Vector>; 2],
    /// Time since the later position, s.
    since: f64,
    /// Acceleration of the centre of mass, mm/s².
    acceleration: Vector,
    tips: bool,
    slides: bool,
}

impl UnmodelledCounter {
    pub(super) const fn new(friction: f64) -> Self {
        UnmodelledCounter {
            friction,
            counted: Unmodelled {
                zmp_margin: 0.0,
                least_zmp_margin: f64::INFINITY,
                tips: 0,
                slides: 0,
                crossings: 0,
            },
            tracking_errors: TrackingErrors::NONE,
            places: [None; 2],
            since: 0.0,
            acceleration: Vector::new(0.0, 0.0, 0.0),
            tips: false,
            slides: false,
        }
    }

    /// Records the centre of mass at `centre` (mm, in the floor's frame) after another `dt` s.
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

    /// Judges one instant. All vectors are in the robot's frame except `gravity`, the direction of
    /// gravity in the floor's frame, where z is along the floor's normal; `to_robot` transforms
    /// from one to the other.
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

    /// Resets the counts.
    pub(super) fn begin(&mut self) {
        *self = UnmodelledCounter::new(self.friction);
    }

    /// Ends a cycle with these events.
    pub(super) fn close(&mut self, events: &CycleEvents) {
        let counted = &mut self.counted;
        counted.tips += u32::from(self.tips);
        counted.slides += u32::from(self.slides);
        counted.crossings += u32::from(events.crosses);
        self.tracking_errors.count(events.hurries, events.stray);
        (self.tips, self.slides) = (false, false);
    }
}
