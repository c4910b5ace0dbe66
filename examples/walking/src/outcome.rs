//! The result for a run.

use crate::gait::Gait;
use std::fmt;
use tip_runtime::record::Ending;

/// Distance that the body must travel, mm.
pub const GOAL: f64 = 1000.0;

/// Maximum slip of a foot that carries, mm.
pub const SLIP: f64 = 1.0;

/// The result for a run. Shown, it is a report of a few lines.
#[derive(Clone, Debug)]
pub struct Outcome<const L: usize> {
    /// End of the run.
    pub ending: Ending,
    /// Number of cycles.
    pub cycles: u64,
    /// Duration on the robot, s.
    pub seconds: f64,
    /// Travel of the body forward, mm.
    pub travel: f64,
    /// Travel of the body to the right, mm.
    pub drift: f64,
    /// Number of falls.
    pub falls: u32,
    /// The farthest that a foot slipped while it carried: mm.
    pub slip: f64,
    /// The least that the centre of mass was inside the support polygon: mm; negative outside.
    pub margin: f64,
    /// Which feet touched the floor.
    pub gait: Gait<L>,
}

impl<const L: usize> Outcome<L> {
    /// The program ended itself, and the robot walked.
    pub fn is_good(&self) -> bool {
        matches!(self.ending, Ending::Program(_)) && self.walked()
    }

    /// Far enough, upright, with feet that stayed where they were put.
    fn walked(&self) -> bool {
        self.travel >= GOAL && self.falls == 0 && self.slip <= SLIP
    }
}

impl<const L: usize> fmt::Display for Outcome<L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "gait (# on the floor, . in the air; a column is {:.2} s)\n{}",
            self.seconds / self.cycles.max(1) as f64 * self.gait.column() as f64,
            self.gait
        )?;
        writeln!(
            f,
            "travel {} mm forward, {} mm to the right in {:.1} s; at least {GOAL} mm asked",
            whole(self.travel),
            whole(self.drift),
            self.seconds
        )?;
        writeln!(f, "falls  {}", self.falls)?;
        writeln!(
            f,
            "slip   {:.2} mm at most of a foot that carries",
            self.slip
        )?;
        writeln!(
            f,
            "margin {} mm at least from the centre of mass to the edge of the support polygon",
            whole(self.margin)
        )?;
        match self.ending {
            Ending::Program(_) => writeln!(f, "end    by the program after {} cycles", self.cycles),
            Ending::Emergency(emergency) => {
                writeln!(f, "end    {emergency} in cycle {}", self.cycles)
            }
            Ending::Limit | Ending::Interrupted => {
                writeln!(f, "end    cut off after {} cycles", self.cycles)
            }
        }
    }
}

/// Rounded, without the sign of a negative zero.
pub fn whole(length: f64) -> f64 {
    length.round() + 0.0
}
