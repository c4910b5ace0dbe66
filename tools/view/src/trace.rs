//! Recordings of traces, as `tip run --trace-motion` writes them.

use crate::recorder::Recorder;
use crate::recording::{Frame, Outcome, Recording, Script, Stop};
use serde::Deserialize;
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::fmt;
use tip_runtime::command::{FAST, Op, RELATIVE, Target, Value};
use tip_runtime::machine::Status;
use tip_runtime::plant::{Gap, Pose, Travel};
use tip_sim::{Cycle, IssuedCommand, Moment, Robot, Sample};
use tipc::Loaded;
use tipc::language::Keyword;

/// The reason why a text is not the trace of a program's motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TraceError {
    /// This line, counted from 1, is not a record.
    Line(usize, String),
    /// This line, counted from 1, has another cycle than the one that follows.
    Cycle {
        /// The line.
        line: usize,
        /// The cycle of its record.
        found: u64,
        /// The cycle that the record before it asks for.
        expected: u64,
    },
    /// The last record, in this line, counts other cycles than there are.
    Count {
        /// The line.
        line: usize,
        /// The number in the record.
        said: u64,
        /// The number of cycles before it.
        found: u64,
    },
    /// This line comes after the last record.
    AfterEnd(usize),
    /// No record has the motion of the robot.
    NoMotion,
    /// A record names a step that the program does not have.
    Step(u32),
    /// This line, counted from 1, has other limbs than the robot.
    Robot {
        /// The line.
        line: usize,
        /// The number of joints of each limb in the record.
        found: Vec<usize>,
        /// The number of joints of each limb of the robot.
        expected: Vec<usize>,
    },
    /// There is no program.
    NoProgram,
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TraceError::Line(line, why) => {
                write!(f, "line {line} is not a record of a trace: {why}")
            }
            TraceError::Cycle {
                line,
                found,
                expected,
            } => write!(
                f,
                "line {line} is of cycle {found} where cycle {expected} follows: lines are missing, doubled or out of order; {RETAKE}"
            ),
            TraceError::Count { line, said, found } => write!(
                f,
                "line {line} ends a trace of {said} cycles, and {found} are before it: lines are missing or added; {RETAKE}"
            ),
            TraceError::AfterEnd(line) => write!(
                f,
                "line {line} comes after the end of the trace: keep one run per file"
            ),
            TraceError::NoMotion => {
                f.write_str("it does not say how the robot moved: write it with --trace-motion")
            }
            TraceError::Step(step) => {
                write!(f, "it is of another program: this one has no step {step}")
            }
            TraceError::Robot {
                line,
                found,
                expected,
            } => write!(
                f,
                "it is of another robot: line {line} has the angles of {}, and this robot has {}; name the robot of the trace with --robot",
                joints(found),
                joints(expected)
            ),
            TraceError::NoProgram => f.write_str("the text is not a program"),
        }
    }
}

impl std::error::Error for TraceError {}

/// Returns numbers of joints in words, such as `4 limbs of 3 joints`.
fn joints(limbs: &[usize]) -> String {
    let count = limbs.len();
    match limbs {
        [first, rest @ ..] if rest.iter().all(|joints| joints == first) => {
            format!("{count} limbs of {first} joints")
        }
        _ => {
            let each: Vec<String> = limbs.iter().map(usize::to_string).collect();
            format!("{count} limbs of {} joints", each.join(", "))
        }
    }
}

/// The way out of a damaged trace.
const RETAKE: &str = "copy the file again, or run the program again with --trace";

/// A line of a trace: a cycle, or the end.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Record {
    cycle: u64,
    sub: u32,
    thread: Option<String>,
    step: u32,
    next: Option<u32>,
    set: BTreeMap<String, f64>,
    say: Option<String>,
    out: Option<String>,
    lamp: BTreeMap<String, bool>,
    cmd: Vec<Json>,
    pose: Option<[f64; 6]>,
    angles: Vec<Vec<f64>>,
    loads: Vec<f64>,
    clearance: Option<f64>,
    nearest: Option<[String; 2]>,
    collisions: u32,
    margin: Option<f64>,
    falls: u32,
    end: Option<String>,
    cycles: u64,
    error: String,
    kind: String,
}

impl Recording {
    /// Reads a trace that was written with the robot's motion. Only of a trace's own cycles is anything known: what
    /// happened from outside, torques and objects are not in it. A trace without its last record, of a run that was killed or
    /// of a copy that was cut short, has the outcome [`Outcome::Unknown`].
    ///
    /// # Errors
    /// It is not the trace of such a program, it holds no motion, or its cycles are not 0, 1, 2 … up to its last record.
    pub fn from_trace(trace: &str, loaded: &Loaded, robot: &Robot) -> Result<Self, TraceError> {
        let program = loaded.program.as_ref().ok_or(TraceError::NoProgram)?;
        let script = Script::of(&loaded.source, program);
        let mut period = robot.description().standards.period;
        let mut time = 0.0;
        let mut outcome = Outcome::Unknown;
        let mut records: Vec<(Option<IssuedCommand>, Record)> = Vec::new();
        let parts = robot.description();
        let joints: Vec<usize> = parts.legs.iter().map(|leg| leg.joints.len()).collect();
        let mut cycles = 0;
        for (line, text) in (1..).zip(trace.split_inclusive('\n')) {
            if outcome != Outcome::Unknown {
                return Err(TraceError::AfterEnd(line));
            }
            let record: Record = match serde_json::from_str(text) {
                Ok(record) => record,
                // The line that was being written as the trace was cut short.
                Err(error) if error.is_eof() && !text.ends_with('\n') => break,
                Err(error) => return Err(TraceError::Line(line, error.to_string())),
            };
            if let Some(end) = &record.end {
                outcome = ending(end, &record);
                // In the cycle of an emergency, steps may have run before the one that failed.
                let is_counted = record.cycles == cycles
                    || outcome.is_emergency() && cycles.checked_sub(1) == Some(record.cycles);
                if !is_counted {
                    return Err(TraceError::Count {
                        line,
                        said: record.cycles,
                        found: cycles,
                    });
                }
                continue;
            }
            // Only records after the first one of their cycle have a number.
            let (expected, sub) = match records.last() {
                Some((_, last)) if record.sub > 0 => (last.cycle, last.sub + 1),
                _ => (cycles, 0),
            };
            if (record.cycle, record.sub) != (expected, sub) {
                return Err(TraceError::Cycle {
                    line,
                    found: record.cycle,
                    expected,
                });
            }
            cycles = expected + 1;
            if record.step as usize >= program.steps().len() {
                return Err(TraceError::Step(record.step));
            }
            let found: Vec<usize> = record.angles.iter().map(Vec::len).collect();
            if !found.is_empty() && found != joints {
                let expected = joints;
                return Err(TraceError::Robot {
                    line,
                    found,
                    expected,
                });
            }
            records.push((asked(&record.cmd), record));
        }
        let mut recorder = Recorder::new(robot, script);
        for cycle in records.chunk_by(|(_, one), (_, next)| one.cycle == next.cycle) {
            let latest = cycle.iter().rev();
            let mut periods = latest.filter_map(|(command, _)| new_period(command.as_ref()?));
            period = periods.next().unwrap_or(period);
            if let Some((_, first)) = cycle.first() {
                recorder.keep_time(first.cycle, time, period);
                time += period;
            }
            for (command, record) in cycle {
                recorder.take_record(record, command.clone(), time);
            }
        }
        let recording = recorder.finish(outcome);
        match recording.frames.is_empty() {
            true => Err(TraceError::NoMotion),
            false => Ok(recording),
        }
    }
}

impl Record {
    /// Returns the least distance of two parts, if the record has it.
    fn gap(&self) -> Option<Gap> {
        let [one, other] = self.nearest.as_ref()?;
        let parts = [one.parse().ok()?, other.parse().ok()?];
        Some(Gap::new(self.clearance?, parts))
    }
}

impl Recorder {
    /// Takes the record of a cycle that ended at `time` (ms).
    fn take_record(&mut self, record: &Record, command: Option<IssuedCommand>, time: f64) {
        let cycle = record.cycle;
        let lamps = record.lamp.iter();
        if let (0, Some(before)) = (record.sub, cycle.checked_sub(1)) {
            self.end_threads(before, before);
        }
        let names = (1..).zip(&self.recording.script.threads);
        let mut named = names.filter(|(_, name)| record.thread.as_ref() == Some(name));
        let thread = named.next().map(|(thread, _)| thread);
        self.note(Cycle {
            number: cycle,
            time,
            step: thread.is_none().then_some(record.step),
            threads: Vec::from_iter(thread.map(|thread| (thread, record.step))),
            next: record.next,
            set: record.set.clone().into_iter().collect(),
            messages: Vec::from_iter(record.say.clone()),
            out: record.out.clone(),
            lamps: lamps
                .filter_map(|(device, on)| Some((device.parse().ok()?, *on)))
                .collect(),
            commands: Vec::from_iter(command),
            pose: None,
            state: 0,
            status: Status::Running,
        });
        if let Some(margin) = record.margin {
            self.note_falls(cycle, record.falls, margin, None);
        }
        if record.angles.is_empty() {
            return;
        }
        let pose = record.pose.map(|[x, y, z, roll, pitch, yaw]| Pose {
            position: [x, y, z],
            roll,
            pitch,
            yaw,
        });
        self.keep(Frame {
            cycle,
            time,
            pose,
            angles: record.angles.clone(),
            loads: record.loads.clone(),
            margin: record.margin,
            gap: record.gap(),
            ..Frame::default()
        });
        self.summarise(record, pose, time);
    }

    /// Adds a cycle that ended at `time` (ms) to the summary. The travel of a trace begins at the end of its first cycle.
    fn summarise(&mut self, record: &Record, pose: Option<Pose>, time: f64) {
        let recording = &self.recording;
        let Some(frame) = self.pending.as_ref().or(recording.frames.last()) else {
            return;
        };
        let start = recording.frames.first().and_then(|first| first.pose);
        let travel = pose.zip(start).map(|(pose, start)| {
            let come = [0, 1, 2].map(|axis| pose.position[axis] - start.position[axis]);
            let before = self.summary.summary().travel;
            let before = before.map_or(0.0, |travel| travel.turn_deg);
            // The least turn from the one before: whole turns count.
            let turn = pose.yaw - start.yaw;
            Travel::new(come, turn + 360.0 * ((before - turn) / 360.0).round())
        });
        let so_far = self
            .summary
            .summary()
            .margin
            .as_ref()
            .map(|peak| peak.value);
        let least_margin = (record.margin.into_iter().chain(so_far)).reduce(f64::min);
        let at = Moment {
            cycle: record.cycle,
            time_s: recording.time(record.cycle) / 1000.0,
            line: self.line().unwrap_or_default(),
        };
        self.summary.add(&Sample {
            at,
            ended: time,
            travel,
            least_margin,
            gap: frame.gap,
            collisions: record.collisions,
            slips: &frame.slips,
            angles: &frame.angles,
            ..Sample::default()
        });
        if record.margin.is_some() {
            self.summary.count_falls(record.falls, at);
        }
    }
}

/// Returns the sampling time (ms) that a command sets.
fn new_period(command: &IssuedCommand) -> Option<f64> {
    let value = command.values.first()?.number();
    match command.op {
        Op::SetSamplingTime => Some(value),
        Op::SetSamplingFreq => Some(1000.0 / value),
        _ => None,
    }
}

/// Reads `[NAME, TARGET, value, …]`, with HS before the target if it was there.
fn asked(cmd: &[Json]) -> Option<IssuedCommand> {
    let (name, mut rest) = cmd.split_first()?;
    let hs = rest.first().and_then(Json::as_str) == Some(FAST);
    if hs {
        rest = rest.get(1..)?;
    }
    let (target, values) = rest.split_first()?;
    Some(IssuedCommand {
        op: name.as_str()?.parse().ok()?,
        hs,
        target: target
            .as_str()
            .map_or(Some(Target::None), |word| word.parse().ok())?,
        values: values.iter().filter_map(value).collect(),
    })
}

fn value(json: &Json) -> Option<Value> {
    match json {
        Json::String(text) => {
            let number = text.strip_prefix(RELATIVE)?;
            number.parse().ok().map(Value::Relative)
        }
        number => number.as_f64().map(Value::Absolute),
    }
}

fn ending(end: &str, record: &Record) -> Outcome {
    let own = [Keyword::End.word(), Keyword::Exit.word()];
    match end {
        _ if own.contains(&end) => Outcome::Program(end.to_owned()),
        "LIMIT" => Outcome::Limit,
        "EMERGENCY" => Outcome::Emergency(Stop {
            error: record.error.clone(),
            kind: record.kind.clone(),
            step: record.step,
        }),
        _ => Outcome::Interrupted,
    }
}
