//! Counts of control cycles: commands that joints and feet could not follow, for robots without mass and with it, and
//! the effects that a robot without mass leaves out.

use super::Vector;
use super::fall::{Polygon, TIPPING};
use crate::hardware::JointCommand;
use crate::kinematics::Chain;
use crate::model::Leg;
use crate::plant::GRAVITY;

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
    /// Number of cycles in which a joint was below the floor, or a leg or the body in a block.
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

/// Factor of a servo's speed from which a joint is commanded to turn too fast, rounding aside.
const FASTER: f64 = 1.0 + 1e-9;

/// Greatest distance of a foot from its path that is not counted, mm.
const STRAY: f64 = 10.0;

/// Greatest distance of equal places, mm.
const SAME: f64 = 1e-6;

/// Commands that joints and feet could not follow, counted in control cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TrackingErrors {
    /// Number of cycles in which a joint was commanded to turn faster than its servo can.
    pub hurries: u32,
    /// Number of cycles in which a foot was more than 10 mm off its commanded path.
    pub strays: u32,
    /// The greatest distance of a foot from its path so far, mm.
    pub farthest_stray: f64,
}

impl TrackingErrors {
    pub(in crate::plant) const NONE: Self = TrackingErrors {
        hurries: 0,
        strays: 0,
        farthest_stray: 0.0,
    };

    /// Returns true if every command could be followed.
    pub const fn is_empty(&self) -> bool {
        self.hurries == 0 && self.strays == 0
    }

    /// Counts a cycle in which a foot was at most `stray` mm off its path.
    pub(in crate::plant) fn count(&mut self, hurries: bool, stray: f64) {
        self.hurries += u32::from(hurries);
        self.strays += u32::from(stray > STRAY);
        self.farthest_stray = self.farthest_stray.max(stray);
    }
}

/// Returns true if a joint is commanded to turn faster than `speed` (deg/s).
pub(in crate::plant) fn hurries(commands: &[JointCommand], speed: f64) -> bool {
    commands.iter().any(|command| match command {
        JointCommand::Angle { rate, .. } => libm::fabs(*rate) > speed * FASTER,
        JointCommand::Torque(_) => false,
    })
}

/// The commanded path of a foot.
#[derive(Clone, Copy, Debug)]
pub(in crate::plant) struct Path {
    /// The end of the path, mm; not a number before the first command.
    place: Vector,
    /// The direction of the path; zero if there is none.
    along: Vector,
}

impl Path {
    /// The path before the first command.
    pub(in crate::plant) const NONE: Self = Path {
        place: Vector::new(f64::NAN, f64::NAN, f64::NAN),
        along: Vector::new(0.0, 0.0, 0.0),
    };

    /// Returns the distance of `foot` (mm) from the line of its last path, mm. A foot that only
    /// lags is on it. Torques define no path.
    pub(in crate::plant) fn stray<const J: usize>(
        &mut self,
        leg: &Leg<J>,
        commands: &[JointCommand; J],
        foot: Vector,
    ) -> f64 {
        let Some(angles) = angles(commands) else {
            *self = Path::NONE;
            return 0.0;
        };
        let place = Vector::from(Chain::new(leg, &angles).foot());
        let step = (place - self.place).norm();
        if step > SAME {
            self.along = (place - self.place) / step;
        }
        self.place = place;
        if self.along == Vector::zeros() {
            return 0.0;
        }
        let off = foot - place;
        (off - self.along * self.along.dot(&off)).norm()
    }
}

/// Returns the angles of commands, if all are angles.
fn angles<const J: usize>(commands: &[JointCommand; J]) -> Option<[f64; J]> {
    let mut angles = [0.0; J];
    for (angle, command) in angles.iter_mut().zip(commands) {
        let JointCommand::Angle { angle: to, .. } = command else {
            return None;
        };
        *angle = *to;
    }
    Some(angles)
}
