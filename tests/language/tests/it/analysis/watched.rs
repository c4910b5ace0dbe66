//! The interpreter with its reads watched: what is called always assigned has a value whenever the run
//! comes there, what is called never assigned has none.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, Mutex};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow, Program, Signature, THREADS};
use tip_sim::Interpreter;
use tipc::analysis::assignment::{Assigned, Assignment};
use tipc::program::Action;

/// Number of reads of each kind that runs reached.
pub(crate) type Seen = BTreeMap<Assigned, u64>;

/// The interpreter, watched: each step's reads are judged before it runs.
#[derive(Clone)]
pub(crate) struct Watched {
    name: String,
    engine: Interpreter,
    assignment: Assignment,
    /// A mark for the main program and each thread: true if its step is reached "not taken"; `None` if that cannot be seen from
    /// outside.
    not_taken: [Option<bool>; 1 + THREADS],
    /// The thread that runs.
    thread: u8,
    seen: Arc<Mutex<Seen>>,
}

impl Watched {
    pub(crate) fn new(name: &str, program: tipc::program::Program, seen: Arc<Mutex<Seen>>) -> Self {
        Watched {
            name: name.to_owned(),
            assignment: Assignment::of(&program),
            engine: Interpreter::new(program),
            not_taken: [Some(false); 1 + THREADS],
            thread: 0,
            seen,
        }
    }

    /// Returns true if the step that runs next may read what it names: a passed ELSEIF does not.
    fn reads_now(&self) -> bool {
        let action = &self.engine.program().steps()[self.engine.at() as usize].action;
        !matches!(action, Action::ElseIf { .. }) || self.is_not_taken() == Some(true)
    }

    fn is_not_taken(&self) -> Option<bool> {
        self.not_taken[usize::from(self.thread)]
    }

    fn judge(&self) {
        let at = self.engine.at();
        let reads = self.assignment.reads();
        let first = reads.partition_point(|read| read.step < at);
        for read in reads[first..].iter().take_while(|read| read.step == at) {
            let has_value = self
                .engine
                .scalar(read.scalar)
                .is_some_and(|(_, value)| value.is_some());
            let fits = match read.assigned {
                Assigned::Always => has_value,
                Assigned::Sometimes => true,
                // What another thread assigns is on no path of this one.
                Assigned::Never => !has_value || self.has_threads(),
            };
            assert!(fits, "{read:?} of {}: {has_value}", self.name);
            let mut seen = self.seen.lock().expect("no read panics");
            *seen.entry(read.assigned).or_default() += 1;
        }
    }

    fn has_threads(&self) -> bool {
        !self.engine.program().threads().is_empty()
    }

    /// Returns the way from the step that ran to the next.
    fn arrival(&self, ran: u32) -> Option<bool> {
        match self.engine.program().steps()[ran as usize].action {
            Action::If { otherwise, .. } | Action::ElseIf { otherwise, .. }
                if otherwise == ran + 1 =>
            {
                None
            }
            Action::If { otherwise, .. } => Some(self.engine.at() == otherwise),
            Action::ElseIf { otherwise, .. } if self.engine.at() == otherwise => {
                self.is_not_taken()
            }
            _ => Some(false),
        }
    }
}

impl fmt::Debug for Watched {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} watched", self.name)
    }
}

impl Program for Watched {
    fn signature(&self) -> Signature {
        self.engine.signature()
    }

    fn name(&self) -> &str {
        self.engine.name()
    }

    fn title(&self) -> &str {
        self.engine.title()
    }

    fn at(&self) -> u32 {
        self.engine.at()
    }

    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let at = self.engine.at();
        if self.reads_now() {
            self.judge();
        }
        let flow = self.engine.step(cx);
        match flow {
            Ok(Flow::Next) => self.not_taken[usize::from(self.thread)] = self.arrival(at),
            Err(Fault::Unassigned(scalar)) => {
                let told = self.assignment.reads().iter().any(|read| {
                    (read.step, read.scalar) == (at, scalar as usize)
                        && read.assigned != Assigned::Always
                });
                assert!(told, "{}: step {at} fails unforeseen", self.name);
            }
            Ok(_) | Err(_) => {}
        }
        flow
    }

    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        self.engine.scalar(i)
    }

    fn set_scalar(&mut self, i: usize, value: f64) {
        self.engine.set_scalar(i, value);
    }

    fn line(&self, step: u32) -> u32 {
        self.engine.line(step)
    }

    fn reset(&mut self) {
        self.engine.reset();
    }

    fn thread(&self, n: u8) -> Option<(&str, u32)> {
        self.engine.thread(n)
    }

    fn select(&mut self, thread: u8) {
        self.thread = thread;
        self.engine.select(thread);
    }

    fn begin(&mut self, thread: u8) {
        self.not_taken[usize::from(thread)] = Some(false);
        self.engine.begin(thread);
    }

    fn specials(&self) -> usize {
        self.engine.specials()
    }
}
