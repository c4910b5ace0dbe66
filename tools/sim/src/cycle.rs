//! Everything that happened in a cycle, as a value.

use crate::dyn_machine::DynMachine;
use std::fmt::{self, Display};
use tip_runtime::command::{Command, FAST, Op, Target, Value};
use tip_runtime::machine::Status;
use tip_runtime::plant::Pose;
use tip_runtime::program::{Program, THREADS};
use tip_runtime::record::{self, Sink, state_hash};

/// One control cycle. If several steps ran in it, `step` is the last one of the main program, and the effects are those
/// of all steps. If neither the main program nor a thread ran a step to its end, the fields of effects are empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycle {
    /// Its number, from 0.
    pub number: u64,
    /// Time on the robot when it began, ms.
    pub time: f64,
    /// The step that ran; none in the cycle of an emergency stop, after the program's end, and in a pause.
    pub step: Option<u32>,
    /// The step of the next cycle; none after END and EXIT.
    pub next: Option<u32>,
    /// Scalars by name whose bits changed or that became assigned, with their values, in order of declaration.
    pub set: Vec<(String, f64)>,
    /// The text of each MESSAGE; an empty one cleared the line.
    pub messages: Vec<String>,
    /// Text that F_MESSAGE appended to FOUT.LOG.
    pub out: Option<String>,
    /// Each lamp that was switched, and true if it is on.
    pub lamps: Vec<(u8, bool)>,
    /// Each thread that had a turn, with its last step.
    pub threads: Vec<(u8, u32)>,
    /// The commands that were accepted, each in its first cycle.
    pub commands: Vec<IssuedCommand>,
    /// Pose of the body after the cycle; none for a robot that stays where it is. A robot outside
    /// of this process gives the pose at the beginning of the cycle.
    pub pose: Option<Pose>,
    /// A hash of what each joint was sent and measured, as in a trace with state.
    pub state: u64,
    /// Status of the program.
    pub status: Status,
}

/// A command as a step asked for it.
#[derive(Clone, Debug, PartialEq)]
pub struct IssuedCommand {
    /// The command.
    pub op: Op,
    /// True with HS, which hands over to the next command immediately.
    pub hs: bool,
    /// The foot, joint or device that it is for.
    pub target: Target,
    /// Its numbers, before relative ones are resolved.
    pub values: Vec<Value>,
}

impl Display for IssuedCommand {
    /// Writes it as in a statement, such as `PTP HS F1 300.0 R10.0 -200.0`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.op.fmt(f)?;
        if self.hs {
            write!(f, " {FAST}")?;
        }
        if self.target != Target::None {
            write!(f, " {}", self.target)?;
        }
        self.values
            .iter()
            .try_for_each(|value| write!(f, " {value}"))
    }
}

/// Collects the effects of a cycle.
pub(crate) struct Collector {
    cycle: Cycle,
    /// The variables before the first step.
    before: Option<Vec<Option<u64>>>,
}

impl Collector {
    /// Begins a cycle with its number and time.
    pub(crate) fn new(number: u64, time: f64) -> Self {
        Collector {
            cycle: Cycle {
                number,
                time,
                step: None,
                next: None,
                set: Vec::new(),
                messages: Vec::new(),
                out: None,
                lamps: Vec::new(),
                threads: Vec::new(),
                commands: Vec::new(),
                pose: None,
                state: 0,
                status: Status::Running,
            },
            before: None,
        }
    }

    /// Finishes the cycle that a robot is in now.
    pub(crate) fn finish(self, machine: &dyn DynMachine, status: Status) -> Cycle {
        Cycle {
            pose: machine.hardware().pose(),
            state: state_hash(machine.commands(), machine.angles()),
            status,
            ..self.cycle
        }
    }
}

fn scalars(program: &dyn Program) -> impl Iterator<Item = (&str, Option<f64>)> {
    (0..).map_while(|index| program.scalar(index))
}

impl Sink for Collector {
    fn begin(&mut self, program: &dyn Program) {
        if self.before.is_none() {
            let bits = scalars(program).map(|(_, value)| value.map(f64::to_bits));
            self.before = Some(bits.collect());
        }
    }

    fn command(&mut self, command: &Command<'_>) {
        self.cycle.commands.push(IssuedCommand {
            op: command.op,
            hs: command.hs,
            target: command.target,
            values: command.values.to_vec(),
        });
    }

    fn say(&mut self, text: &dyn Display) {
        self.cycle.messages.push(text.to_string());
    }

    fn out(&mut self, text: &dyn Display) {
        self.cycle
            .out
            .get_or_insert_default()
            .push_str(&text.to_string());
    }

    fn lamp(&mut self, device: u8, on: bool) {
        self.cycle.lamps.push((device, on));
    }

    fn cycle(&mut self, cycle: &record::Cycle<'_>) {
        match cycle.thread {
            None => (self.cycle.step, self.cycle.next) = (Some(cycle.step), cycle.next),
            Some(name) => {
                let numbers = 1..=THREADS as u8;
                let named = |n: &u8| cycle.program.thread(*n).is_some_and(|it| it.0 == name);
                let thread = numbers.into_iter().find(named).unwrap_or(0);
                self.cycle.threads.retain(|(other, _)| *other != thread);
                self.cycle.threads.push((thread, cycle.step));
            }
        }
        let now = scalars(cycle.program).zip(self.before.iter().flatten());
        let changed = now.filter_map(|((name, value), before)| {
            let value = value?;
            (Some(value.to_bits()) != *before).then(|| (name.to_owned(), value))
        });
        self.cycle.set = changed.collect();
    }
}
