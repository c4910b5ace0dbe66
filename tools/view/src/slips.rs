//! Feet that slip.

use crate::recording::{Frame, Slip};
use crate::skeleton::{Skeleton, robot_frame};
use tip_runtime::model::Point;

/// A foot that has come so far from where it touched down has slipped: mm.
const SLIPPED: f64 = 5.0;

/// Watches where each foot touched down.
#[derive(Clone, Debug, Default)]
pub(crate) struct Slips(Vec<Stance>);

/// One foot; in the air it has touched down nowhere.
#[derive(Clone, Copy, Debug, Default)]
struct Stance {
    touchdown: Option<Point>,
    reported: bool,
}

impl Slips {
    /// Looks at a robot in another cycle; each stance has one slip at most.
    pub(crate) fn watch(&mut self, robot: &Skeleton, frame: &Frame) -> Vec<Slip> {
        let Some(pose) = &frame.pose else {
            return Vec::new();
        };
        self.0.resize(frame.loads.len(), Stance::default());
        let body = robot_frame(pose);
        let feet = self.0.iter_mut().zip(&frame.loads).zip(&frame.angles);
        let slipped = feet
            .enumerate()
            .filter_map(|(leg, ((stance, load), angles))| {
                if *load <= 0.0 {
                    *stance = Stance::default();
                    return None;
                }
                let foot = body.point(robot.legs.get(leg)?.foot(angles));
                let from = *stance.touchdown.get_or_insert(foot);
                let distance = libm::hypot(foot[0] - from[0], foot[1] - from[1]);
                let slips = distance > SLIPPED && !stance.reported;
                stance.reported |= slips;
                slips.then_some(Slip { leg, distance })
            });
        slipped.collect()
    }
}
