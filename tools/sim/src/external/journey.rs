//! How far the body of a robot comes, as another process says.

use tip_runtime::plant::{Pose, Travel};

/// From where to where the body has come.
#[derive(Clone, Copy, Debug)]
pub(super) struct Journey {
    start: Pose,
    now: Pose,
    /// Whole turns: deg.
    turned: f64,
}

impl Journey {
    /// Goes on from what was before.
    pub(super) fn on(before: Option<Self>, now: Pose) -> Self {
        let Some(before) = before else {
            return Journey {
                start: now,
                now,
                turned: 0.0,
            };
        };
        // Headings are kept within half a turn.
        let turn = now.yaw - before.now.yaw;
        let whole = if turn > 180.0 {
            -360.0
        } else if turn < -180.0 {
            360.0
        } else {
            0.0
        };
        Journey {
            now,
            turned: before.turned + whole,
            ..before
        }
    }

    /// Where it is.
    pub(super) fn now(&self) -> Pose {
        self.now
    }

    /// How far it has come.
    pub(super) fn travel(&self) -> Travel {
        let ([x, y, z], [x0, y0, z0]) = (self.now.position, self.start.position);
        let turn = self.now.yaw - self.start.yaw + self.turned;
        Travel::new([x - x0, y - y0, z - z0], turn)
    }
}
