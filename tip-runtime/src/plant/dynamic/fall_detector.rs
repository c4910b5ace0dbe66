//! The fall detector of a robot with mass; it measures travel, slip and margin as well.

use super::Vector;
use super::body_dynamics::BodyDynamics;
use super::contact::FootContact;
use super::spatial::MovingFrame;
use super::terrain::Terrain;
use crate::plant::Travel;
use crate::plant::walker::fall::{FallCounter, Posture, TILTED, hull_margin};
use core::f64::consts::{PI, TAU};

/// Time on its feet alone after which a robot has got up, ms.
const UP: f64 = 200.0;
/// Time without support, or with none near its centre of mass, after which a robot has lost its
/// support, ms.
const LOST: f64 = 200.0;
/// Distance of the centre of mass from the support polygon then, as a share of its height above the
/// feet.
const OUTSIDE: f64 = 0.25;
/// Height above the lowest foot, along the body's z axis, from which feet of a tilted body count as
/// lifted, m: the body came down on them.
const LIFTED: f64 = 0.02;

/// The measurements so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct FallDetector {
    /// Start of the body, m.
    start: Vector,
    /// Heading to the left, about the floor's normal, rad.
    heading: f64,
    /// Turn since the beginning; whole turns count, rad.
    turned: f64,
    /// The greatest slip of a foot in one stance at the end of a cycle, m.
    pub(super) slip: f64,
    /// Distance of the centre of mass from the edge of the polygon of all carrying points, mm;
    /// negative outside.
    pub(super) margin: f64,
    /// The least margin so far, mm.
    pub(super) least: f64,
    pub(super) falls: FallCounter,
    /// Time without support, ms.
    unsupported: f64,
    /// Time on its feet alone, ms.
    stood: f64,
    /// Number of cycles so far.
    pub(super) cycle: u64,
}

impl FallDetector {
    pub(super) fn new(frame: &MovingFrame, terrain: &Terrain) -> Self {
        FallDetector {
            start: frame.position,
            heading: heading(frame, terrain),
            turned: 0.0,
            slip: 0.0,
            margin: 0.0,
            least: f64::INFINITY,
            falls: FallCounter::NONE,
            unsupported: 0.0,
            stood: 0.0,
            cycle: 0,
        }
    }

    /// Restarts the measurement of the least margin.
    pub(super) const fn begin(&mut self) {
        self.least = self.margin;
    }

    /// Updates the measurements at the end of a cycle of `period` ms; `centre` is the centre of
    /// mass from the body's origin.
    pub(super) fn update<'a>(
        &mut self,
        period: f64,
        base: &BodyDynamics,
        terrain: &Terrain,
        centre: Vector,
        feet: impl Iterator<Item = &'a FootContact> + Clone,
    ) {
        self.turn(&base.frame, terrain);
        let slips = feet.clone().map(|foot| foot.slip);
        self.slip = slips.fold(self.slip, f64::max);
        let over = flat(base.frame.position + centre);
        let carrying = feet.filter(|foot| foot.load > 0.0);
        let lowest = carrying.clone().map(|foot| foot.place.z);
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        let standing = carrying.clone().map(|foot| flat(foot.place));
        let corners = base.corners().into_iter().zip(base.loads);
        let corners = corners.filter(|(_, load)| *load > 0.0);
        let corners = corners.map(|(corner, _)| flat(base.frame.point(corner)));
        let lies = base.edge_load > 0.0 || corners.clone().next().is_some();
        let on_feet = hull_margin(standing.clone(), over);
        let stands = standing.clone().next().is_some() && !lies;
        let carriers = standing.chain(corners);
        let is_carried = carriers.clone().next().is_some();
        if is_carried {
            self.margin = hull_margin(carriers, over);
            self.least = self.least.min(self.margin);
        }
        let height = (base.frame.position.z + centre.z - lowest) * 1000.0;
        let uprightness = (base.frame.rotation * Vector::z()).dot(&terrain.normal);
        let support = if uprightness < TILTED {
            hull_margin(standing_below(base, terrain, carrying), over)
        } else {
            self.margin
        };
        let is_outside = stands && support < -OUTSIDE * height;
        self.unsupported = if is_outside || !(is_carried || lies) {
            self.unsupported + period
        } else {
            0.0
        };
        self.stood = if stands && !is_outside {
            self.stood + period
        } else {
            0.0
        };
        let posture = Posture {
            lies,
            uprightness,
            is_held: on_feet >= 0.0,
            is_lost: self.unsupported >= LOST,
            is_up: self.stood >= UP,
            margin: self.margin,
        };
        self.falls.update(&posture, self.cycle);
    }

    /// Updates the heading, which is kept within half a turn.
    fn turn(&mut self, frame: &MovingFrame, terrain: &Terrain) {
        let heading = heading(frame, terrain);
        let turn = heading - self.heading;
        let turn = if turn > PI {
            turn - TAU
        } else if turn < -PI {
            turn + TAU
        } else {
            turn
        };
        self.turned += turn;
        self.heading = heading;
    }

    /// Returns the travel of the body.
    pub(super) fn travel(&self, frame: &MovingFrame) -> Travel {
        let come = (frame.position - self.start) * 1000.0;
        Travel {
            x: come.x,
            y: come.y,
            z: come.z,
            turn: self.turned.to_degrees(),
        }
    }
}

/// Returns the feet under a tilted body that its program has not lifted. The height of a foot is measured along the body's z
/// axis and from the ground under that foot, so that a body parallel to the floor stands on all its feet.
fn standing_below<'a>(
    base: &BodyDynamics,
    terrain: &Terrain,
    feet: impl Iterator<Item = &'a FootContact> + Clone,
) -> impl Iterator<Item = [f64; 2]> + Clone {
    let (up, normal) = (base.frame.rotation * Vector::z(), terrain.normal);
    let lift = move |foot: &FootContact| (up - normal).dot(&foot.place);
    let lowest = feet.clone().map(lift).fold(f64::INFINITY, f64::min);
    feet.filter(move |foot| lift(foot) <= lowest + LIFTED)
        .map(|foot| flat(foot.place))
}

/// Returns the heading of the robot's y axis along the floor, from the world's y axis, rad.
fn heading(frame: &MovingFrame, terrain: &Terrain) -> f64 {
    let forward = terrain.tilt().inverse() * (frame.rotation * Vector::y());
    libm::atan2(-forward.x, forward.y)
}

/// Projects a point onto the horizontal plane, mm.
fn flat(point: Vector) -> [f64; 2] {
    [point.x * 1000.0, point.y * 1000.0]
}
