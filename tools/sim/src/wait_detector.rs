//! Waits of a program while its robot rests.

use crate::interp::Interpreter;
use crate::message::Awaited;
use crate::program_runner::StepTaken;
use crate::run::Run;
use tip_runtime::command::{Flag, Op};
use tip_runtime::hardware::JointCommand;
use tipc::program::{Action, Condition, Operand, Program, Step};

/// Time between two checks of joints that move slowly, and of variables, ms.
const OFTEN: f64 = 1000.0;
/// Change of an angle that counts as a motion, deg. Fingers that press on something tremble by a few tenths.
const MOVED: f64 = 1.0;

/// A wait.
#[derive(Clone, Debug, PartialEq)]
pub struct Wait {
    /// The lines that run meanwhile: the first and the last one of a loop, or twice the same.
    pub lines: [u32; 2],
    /// The condition that ends it; none for a loop without conditions.
    pub on: Option<Awaited>,
    /// Time at which it began, ms.
    pub since: f64,
    /// Present length, ms.
    pub time: f64,
}

/// Finds waits of a run. A wait begins when neither the robot nor the program does anything any more. The robot moves
/// if commanded angles change. The program acts if it changes variables, switches lamps, or reaches a step for the
/// first time since such an action.
#[derive(Clone, Debug, Default)]
pub struct WaitDetector {
    /// The last cycle in which each step was the next one.
    visited: Vec<u64>,
    /// The next step; `entered` is the time since which it is.
    step: u32,
    entered: f64,
    /// True if the step had not been reached since the last action.
    is_first: bool,
    /// The cycle of the last action: steps that were reached only before it count as new.
    effect: u64,
    /// The cycle that ended the last activity; `rests_since` is its time.
    done: u64,
    rests_since: f64,
    commands: Vec<JointCommand>,
    /// Time of the last check of joints and variables.
    looked: f64,
    angles: Vec<f64>,
    values: Vec<Option<u64>>,
}

impl WaitDetector {
    /// Takes the state of a [followed](Run::followed) run after each of its cycles.
    pub fn after(&mut self, run: &Run) {
        let (cycle, now, step) = (run.cycles(), run.time(), run.program().at());
        let Some(program) = run.engine::<Interpreter>().map(Interpreter::program) else {
            return;
        };
        self.visited.resize(program.steps().len(), 0);
        let action = |step: u32| program.steps().get(step as usize).map(|step| &step.action);
        let is_other = step != self.step;
        // Threads, and earlier steps of the same cycle, count as well as the next step.
        let taken = run.steps().iter();
        let came =
            taken.filter_map(|StepTaken { from, to }| to.map(|to| (to.step, to.step != from.step)));
        let came: Vec<(u32, bool)> = [(step, is_other)].into_iter().chain(came).collect();
        let mut next = came.iter().filter_map(|(step, _)| action(*step));
        if self.moves(run, now) || next.any(switches) {
            (self.effect, self.is_first) = (cycle, true);
            self.does(cycle, now);
        }
        let mut is_new = None;
        let mut does = false;
        for (step, is_other) in came {
            if let Some(visited) = self.visited.get_mut(step as usize) {
                let is_first = *visited < self.effect;
                *visited = cycle;
                is_new.get_or_insert(is_first);
                does |= is_first && is_other;
            }
        }
        if is_other {
            (self.step, self.entered, self.is_first) = (step, now, is_new.unwrap_or_default());
        }
        // A SLEEP that is reached for the first time is no wait.
        let sleeps =
            self.is_first && matches!(action(step), Some(Action::Command { op: Op::Sleep, .. }));
        if does || sleeps {
            self.does(cycle, now);
        }
    }

    fn does(&mut self, cycle: u64, now: f64) {
        (self.done, self.rests_since) = (cycle, now);
    }

    /// Returns true if the robot has moved or variables have changed.
    fn moves(&mut self, run: &Run, now: f64) -> bool {
        let is_first = self.commands.is_empty();
        let mut moves = self.commands != run.commands();
        if moves {
            self.commands = run.commands().to_vec();
        }
        if is_first || now - self.looked >= OFTEN {
            self.looked = now;
            let angles = run.angles();
            let pairs = self.angles.iter().zip(angles);
            let differ = |(before, now): (&f64, &f64)| (before - now).abs() > MOVED;
            if self.angles.len() != angles.len() || pairs.into_iter().any(differ) {
                self.angles = angles.to_vec();
                moves = true;
            }
            let program = run.program();
            let values = (0..).map_while(|index| program.scalar(index));
            let values: Vec<_> = values.map(|(_, value)| value.map(f64::to_bits)).collect();
            moves |= values != self.values;
            self.values = values;
        }
        moves
    }

    /// Returns the time for which nothing has moved and nothing was done, ms.
    pub fn rest(&self, run: &Run) -> f64 {
        run.time() - self.rests_since
    }

    /// Returns the present wait of the run, if it waits.
    pub fn now(&self, run: &Run) -> Option<Wait> {
        let program = run.engine::<Interpreter>()?.program();
        let step = program.steps().get(run.program().at() as usize)?;
        let now = run.time();
        let of = |lines, on, since| Wait {
            lines,
            on,
            since,
            time: now - since,
        };
        let is_stay = now > self.entered && run.program().at() == self.step;
        if let Some(on) = awaited(program, &step.action).filter(|_| is_stay) {
            let on = each_other(run, program, &step.action).unwrap_or(on);
            return Some(of([step.line; 2], Some(on), self.entered));
        }
        if self.rest(run) < OFTEN {
            return None;
        }
        let visited = self.visited.iter().zip(program.steps());
        let again = visited.filter(|(visited, _)| **visited > self.done);
        let again: Vec<&Step> = again.map(|(_, step)| step).collect();
        let lines = again.iter().map(|step| step.line);
        let lines = [lines.clone().min()?, lines.max()?];
        Some(of(lines, conditions(program, &again), self.rests_since))
    }
}

/// Returns the condition that ends the wait of a step that may take any time.
fn awaited(program: &Program, action: &Action) -> Option<Awaited> {
    let flag = |flag: Flag| Awaited::Flags {
        names: flag.to_string().into(),
    };
    match action {
        Action::KeyIn { .. } => Some(Awaited::Key),
        Action::WaitThread { thread } => Some(Awaited::Thread {
            name: program.threads().get(*thread)?.name.clone().into(),
        }),
        Action::Command { op, target, .. } => match op {
            Op::WaitInpos => Some(flag(Flag::Inpos(*target))),
            Op::WaitNear => Some(flag(Flag::Near(*target))),
            Op::StandUp | Op::SitDown | Op::InitialPosture => Some(Awaited::Motion),
            Op::DetectFloor | Op::DetectObject => Some(Awaited::Touch),
            Op::Special => Some(Awaited::Native),
            _ => None,
        },
        _ => None,
    }
}

/// Threads that wait for each other. Only a STOP_THREAD ends that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WaitCircle {
    /// Name of each thread and line of its WAIT_THREAD, in the order of waiting. The first one in the text comes first.
    pub threads: Vec<(String, u32)>,
    /// The WAIT_THREAD of the first one.
    pub step: u32,
}

impl WaitCircle {
    /// Returns all circles of waiting threads in a run of the interpreter, also those for which the main program does
    /// not wait.
    pub fn all(run: &Run) -> Vec<Self> {
        let Some(program) = run.engine::<Interpreter>().map(Interpreter::program) else {
            return Vec::new();
        };
        let threads = 0..program.threads().len();
        let circles = threads.filter_map(|first| {
            let circle = circle(run, program, first)?;
            let is_first = circle[0] == first && circle.iter().min() == Some(&first);
            if !is_first || circle.len() < 2 {
                return None;
            }
            let waits = circle.iter().filter_map(|thread| {
                let (_, step) = waits_for(run, program, *thread)?;
                let line = program.steps().get(step as usize)?.line;
                Some((program.threads().get(*thread)?.name.to_string(), line))
            });
            Some(WaitCircle {
                threads: waits.collect(),
                step: waits_for(run, program, first)?.1,
            })
        });
        circles.collect()
    }
}

/// Returns the thread for whose end a running thread waits, and the step of its WAIT_THREAD. Threads count from 0.
fn waits_for(run: &Run, program: &Program, thread: usize) -> Option<(usize, u32)> {
    let number = u8::try_from(thread + 1).ok()?;
    let step = Some(run.step_of(number)).filter(|_| run.thread_runs(number))?;
    match program.steps().get(step as usize)?.action {
        Action::WaitThread { thread } => Some((thread, step)),
        _ => None,
    }
}

/// Returns the threads that wait for each other, if a thread is one of them or waits for one.
fn circle(run: &Run, program: &Program, mut thread: usize) -> Option<Vec<usize>> {
    let mut waiting = Vec::new();
    loop {
        if let Some(first) = waiting.iter().position(|it| *it == thread) {
            return Some(waiting.split_off(first));
        }
        waiting.push(thread);
        thread = waits_for(run, program, thread)?.0;
    }
}

/// Returns the wait of the main program for threads that wait for each other.
fn each_other(run: &Run, program: &Program, action: &Action) -> Option<Awaited> {
    let Action::WaitThread { thread } = action else {
        return None;
    };
    let threads = circle(run, program, *thread)?;
    let names = threads
        .iter()
        .filter_map(|it| Some(program.threads().get(*it)?.name.as_str()));
    let names = names.collect::<Vec<_>>().join(", ").into();
    Some(Awaited::EachOther { names })
}

/// Returns true if a step has a visible effect other than a motion.
fn switches(action: &Action) -> bool {
    matches!(
        action,
        Action::Command {
            op: Op::LampOn | Op::LampOff,
            ..
        }
    )
}

/// Returns the flags, inputs and variables that the steps of a loop read.
fn conditions(program: &Program, steps: &[&Step]) -> Option<Awaited> {
    let mut names: Vec<String> = Vec::new();
    let mut add = |name: String| {
        if !names.contains(&name) {
            names.push(name);
        }
    };
    let scalars: Vec<String> = program.scalar_names().collect();
    let read = |step: &&Step| match step.action {
        Action::AdIn { port, into } => Some((program.scalar_index(into), port)),
        _ => None,
    };
    let inputs: Vec<_> = steps.iter().filter_map(read).collect();
    for step in steps {
        if let Some(awaited) = awaited(program, &step.action) {
            return Some(awaited);
        }
        match step.action.condition() {
            Some(Condition::Flag { flag, .. }) => add(flag.to_string()),
            Some(Condition::Compare { left, right, .. }) => {
                for operand in [left, right] {
                    let Operand::Scalar { scalar, .. } = operand else {
                        continue;
                    };
                    let index = program.scalar_index(*scalar);
                    let input = inputs.iter().find(|(into, _)| *into == index);
                    let name = input.map(|(_, port)| port.to_string());
                    let name = name.or_else(|| scalars.get(index).cloned());
                    name.into_iter().for_each(&mut add);
                }
            }
            None => {}
        }
    }
    (!names.is_empty()).then(|| Awaited::Flags {
        names: names.join(", ").into(),
    })
}
