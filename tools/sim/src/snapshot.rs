//! Marks in a run, to which it can be taken back.

use crate::motion::Fall;
use crate::run::Run;
use crate::shell::Shell;
use crate::trace;
use std::fmt;
use tip_runtime::record::Ending;

/// A run at some cycle: its program, controller, plant, special commands, waiting keys, how many events have happened,
/// and how long its trace and its console's transcript were.
pub struct Snapshot {
    shell: Box<dyn Shell>,
    happened: usize,
    ending: Option<Ending>,
    fall: Option<Fall>,
    trace: Option<trace::Mark>,
    shown: Option<crate::transcript::Lengths>,
}

impl fmt::Debug for Snapshot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Snapshot")
            .field("cycles", &self.shell.seen().cycles)
            .finish_non_exhaustive()
    }
}

impl Run {
    /// Marks where the run is.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            shell: self.shell.boxed(),
            happened: self.happened,
            ending: self.ending,
            fall: self.fall,
            trace: self.trace.as_ref().map(trace::Trace::mark),
            shown: self.console().map(crate::transcript::Lengths::of),
        }
    }

    /// Takes the run back to where a mark of it was made; from there on it does the same to the bit, as long as the same
    /// happens to it. Its console stays; of a [`Transcript`](tip_runtime::console::Transcript) and of the trace only
    /// what was there at the mark is left.
    pub fn restore(&mut self, mark: &Snapshot) {
        let listener = self.shell.desk_mut().replace(None);
        self.shell = mark.shell.boxed();
        self.shell.desk_mut().replace(listener);
        self.happened = mark.happened;
        self.ending = mark.ending;
        self.fall = mark.fall;
        {
            if let (Some(trace), Some(mark)) = (&mut self.trace, &mark.trace) {
                trace.restore(mark);
            }
            if let (Some(shown), Some(lengths)) = (self.console_mut(), mark.shown) {
                lengths.restore(shown);
            }
        }
    }
}
