//! The result for a run.

use std::fmt;
use tip_runtime::record::Ending;

/// Height that the object must reach, mm.
pub const LIFT: f64 = 30.0;

/// For how long it must stay that high: s.
pub const HOLD: f64 = 2.0;

/// The result for a run. Shown, it is a report of a few lines.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// End of the run.
    pub ending: Ending,
    /// Duration on the robot, s.
    pub seconds: f64,
    /// The highest that the object was above the floor: mm.
    pub lift: f64,
    /// The longest that it stayed above [`LIFT`]: s.
    pub held: f64,
    /// The trace, with a hash of commands and measurements in each record.
    pub trace: String,
}

impl Outcome {
    /// The program ended itself, and the object was high enough for long enough.
    pub fn is_good(&self) -> bool {
        matches!(self.ending, Ending::Program(_)) && self.held >= HOLD
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "lift   {:.1} mm at most; {LIFT} mm or more for {:.1} s, at least {HOLD} s asked",
            self.lift, self.held
        )?;
        match self.ending {
            Ending::Program(_) => writeln!(f, "end    by the program after {:.1} s", self.seconds),
            Ending::Emergency(emergency) => {
                writeln!(f, "end    {emergency} after {:.1} s", self.seconds)
            }
            Ending::Limit | Ending::Interrupted => {
                writeln!(f, "end    cut off after {:.1} s", self.seconds)
            }
        }
    }
}
