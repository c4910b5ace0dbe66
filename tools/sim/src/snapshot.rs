//! Marks in a run, to which it can be taken back.

use crate::dyn_machine::DynMachine;
use crate::motion::Fall;
use crate::run::Run;
use crate::trace;
use std::fmt;
use tip_runtime::console::Transcript;
use tip_runtime::record::Ending;

/// A run at some cycle: its program, controller, plant, special commands, waiting keys, how many events have happened,
/// and how long its trace and its console's transcript were.
pub struct Snapshot {
    machine: Box<dyn DynMachine>,
    happened: usize,
    ending: Option<Ending>,
    fall: Option<Fall>,
    trace: Option<trace::TraceMark>,
    shown: Option<Lengths>,
}

impl fmt::Debug for Snapshot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Snapshot")
            .field("cycles", &self.machine.cycles())
            .finish_non_exhaustive()
    }
}

impl Run {
    /// Marks where the run is.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            machine: self.machine.boxed(),
            happened: self.happened,
            ending: self.ending,
            fall: self.fall,
            trace: self.trace.as_ref().map(trace::Trace::mark),
            shown: self.console().map(Lengths::of),
        }
    }

    /// Takes the run back to where a mark of it was made; from there on it does the same to the bit, as long as the same
    /// happens to it. Its console stays; of a [`Transcript`](tip_runtime::console::Transcript) and of the trace only
    /// what was there at the mark is left.
    pub fn restore(&mut self, mark: &Snapshot) {
        let listener = self.machine.console_mut().replace(None);
        self.machine = mark.machine.boxed();
        self.machine.console_mut().replace(listener);
        self.happened = mark.happened;
        self.ending = mark.ending;
        self.fall = mark.fall;
        if let (Some(trace), Some(mark)) = (&mut self.trace, &mark.trace) {
            trace.restore(mark);
        }
        if let (Some(shown), Some(lengths)) = (self.console_mut(), mark.shown) {
            lengths.restore(shown);
        }
    }
}

/// The lengths of what only grows in a transcript.
#[derive(Clone, Copy, Debug)]
struct Lengths {
    messages: usize,
    appended: usize,
    silent: usize,
    log: usize,
    variables: usize,
    stopped: bool,
    ended: u32,
}

impl Lengths {
    fn of(shown: &Transcript) -> Self {
        Lengths {
            messages: shown.messages.len(),
            appended: shown.appended.len(),
            silent: shown.silent.len(),
            log: shown.log.len(),
            variables: shown.variables.len(),
            stopped: shown.emergency.is_some(),
            ended: shown.ended,
        }
    }

    /// Takes away what came later.
    fn restore(self, shown: &mut Transcript) {
        shown.messages.truncate(self.messages);
        shown.appended.truncate(self.appended);
        shown.silent.truncate(self.silent);
        shown.log.truncate(self.log);
        shown.variables.truncate(self.variables);
        shown.emergency.take_if(|_| !self.stopped);
        shown.ended = self.ended;
    }
}
