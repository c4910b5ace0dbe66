//! What came of a run.

use crate::gait::Gait;
use tip_runtime::record::Ending;

/// How far the body must come: mm.
pub const GOAL: f64 = 1000.0;

/// How far a foot that carries may slip: mm.
pub const SLIP: f64 = 1.0;

/// What came of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub ending: Ending,
    /// How many cycles ran.
    pub cycles: u64,
    /// How long they took on the robot: s.
    pub seconds: f64,
    /// How far the body came forward: mm.
    pub travel: f64,
    /// How far the body came to the right: mm.
    pub drift: f64,
    /// How often the robot fell.
    pub falls: u32,
    /// The farthest that a foot slipped while it carried: mm.
    pub slip: f64,
    /// Which feet touched the floor.
    pub gait: Gait,
    /// Records that the two traces have in common before their first difference.
    pub same_records: u64,
    /// Whether the traces never differed.
    pub identical: bool,
}

impl Outcome {
    /// The program ended itself, the robot walked, and both engines agree.
    pub fn is_good(&self) -> bool {
        matches!(self.ending, Ending::Program(_)) && self.walked() && self.identical
    }

    /// Far enough, upright, with feet that stayed where they were put.
    fn walked(&self) -> bool {
        self.travel >= GOAL && self.falls == 0 && self.slip <= SLIP
    }
}
