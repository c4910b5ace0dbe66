//! Recordings of runs: a recorder, which can be taken back and can forget.

use crate::recording::{
    Frame, FrameRate, LogEntry, ObjectPose, Occurrence, Outcome, Recording, Script, Skeleton, Stop,
    Tick, robot_frame,
};
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::fmt;
use tip_runtime::command::{Flag, TIMERS, Target};
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::Mismatch;
use tip_runtime::model::Point;
use tip_runtime::program::{End, THREADS};
use tip_runtime::record::Ending;
use tip_sim::{
    Cycle, Event, Events, FallKind, Interpreter, Refused, Robot, Run, Summary, SummaryBuilder,
    Wait, WaitDetector,
};
use tipc::Loaded;
use tipc::analysis::access;
use tipc::language::Keyword;
use tipc::program::Action;
use tipc::source::Source;

/// Time between two frames, at least, ms.
const APART: f64 = 20.0;

/// Length of the past of a run that goes on, and the excess at which it is cut, ms.
const PAST: f64 = 300_000.0;
const SLACK: f64 = 60_000.0;

/// Rounding error of sums of times, ms.
const ROUNDING: f64 = 1e-6;

/// Maximum length of a recording.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DurationLimit {
    /// A number of cycles.
    Cycles(u64),
    /// Limit in time of the robot, and in time that it waits without a motion, ms.
    Time {
        /// Limit of the whole run.
        most: f64,
        /// Limit of one wait.
        wait: f64,
    },
}

impl DurationLimit {
    /// Limits a recording to a number of cycles.
    pub const fn cycles(cycles: u64) -> Self {
        DurationLimit::Cycles(cycles)
    }

    /// Limits a recording to minutes of the robot's time; a minute without a motion ends it too.
    pub const fn minutes(minutes: f64) -> Self {
        DurationLimit::Time {
            most: minutes * 60_000.0,
            wait: 60_000.0,
        }
    }

    fn is_over(self, run: &Run, waits: &WaitDetector) -> bool {
        match self {
            DurationLimit::Cycles(cycles) => run.cycles() >= cycles,
            DurationLimit::Time { most, wait } => run.time() >= most || waits.rest(run) >= wait,
        }
    }
}

/// The reason why nothing can be recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RecordError {
    /// The text is not a program.
    NoProgram,
    /// The program is for another robot.
    Mismatch(Mismatch),
    /// One of the events cannot happen.
    Refused(Refused),
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RecordError::NoProgram => f.write_str("the text is not a program"),
            RecordError::Mismatch(mismatch) => mismatch.fmt(f),
            RecordError::Refused(refused) => refused.fmt(f),
        }
    }
}

impl std::error::Error for RecordError {}

impl Recording {
    /// Runs a program by the reference interpreter to its end or to the limit, as long as `goes_on` agrees.
    ///
    /// # Errors
    /// There is no program, or it cannot run on that robot, or one of the events cannot happen to it.
    pub fn of(
        loaded: &Loaded,
        robot: &Robot,
        events: &Events,
        limit: DurationLimit,
        goes_on: impl FnMut() -> bool,
    ) -> Result<Self, RecordError> {
        Self::paced(loaded, robot, events, limit, FrameRate::Smooth, goes_on)
    }

    /// Records a program, with the motion kept as often as asked.
    ///
    /// # Errors
    /// There is no program, or it cannot run on that robot, or one of the events cannot happen to it.
    pub fn paced(
        loaded: &Loaded,
        robot: &Robot,
        events: &Events,
        limit: DurationLimit,
        frame_rate: FrameRate,
        goes_on: impl FnMut() -> bool,
    ) -> Result<Self, RecordError> {
        let program = loaded.program.as_ref().ok_or(RecordError::NoProgram)?;
        let interpreter = Interpreter::new(program.clone());
        let run = Run::new(interpreter, robot.clone())
            .map_err(RecordError::Mismatch)?
            .with_events(events)
            .map_err(RecordError::Refused)?;
        Self::of_run(run, loaded, robot, limit, frame_rate, goes_on)
    }

    /// Records a run of a program that has not begun.
    ///
    /// # Errors
    /// There is no program.
    pub fn of_run(
        run: Run,
        loaded: &Loaded,
        robot: &Robot,
        limit: DurationLimit,
        frame_rate: FrameRate,
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<Self, RecordError> {
        let program = loaded.program.as_ref().ok_or(RecordError::NoProgram)?;
        let mut recorder = Recorder::new(robot, Script::of(&loaded.source, program));
        recorder.recording.events = run.all_events().all().to_vec();
        recorder.frame_rate = frame_rate;
        let mut run = run.followed();
        let mut waits = WaitDetector::default();
        let outcome = loop {
            if let Some(ending) = run.ending() {
                break Outcome::from(ending);
            }
            if limit.is_over(&run, &waits) {
                break Outcome::Limit;
            }
            if !goes_on() {
                break Outcome::Interrupted;
            }
            let cycle = run.cycle();
            waits.after(&run);
            let wait = waits.now(&run).filter(|_| run.ending().is_none());
            recorder.take(cycle, &run, wait);
        };
        if let Outcome::Limit | Outcome::Interrupted = outcome {
            recorder.recording.wait = waits.now(&run);
        }
        Ok(recorder.finish(outcome))
    }
}

impl Script {
    /// Returns the script of a program.
    pub(crate) fn of(source: &Source, program: &tipc::program::Program) -> Self {
        Script {
            name: program.source_name().to_owned(),
            title: program.title().to_owned(),
            text: source.text().to_owned(),
            lines: program.steps().iter().map(|step| step.line).collect(),
            scalars: program.scalar_names().collect(),
            threads: (program.threads().iter())
                .map(|thread| thread.name.clone())
                .collect(),
        }
    }

    pub(crate) fn scalar(&self, name: &str) -> Option<usize> {
        self.scalars.iter().position(|scalar| scalar == name)
    }
}

impl From<Ending> for Outcome {
    fn from(ending: Ending) -> Self {
        match ending {
            Ending::Program(End::End) => Outcome::Program(Keyword::End.word().to_owned()),
            Ending::Program(End::Exit) => Outcome::Program(Keyword::Exit.word().to_owned()),
            Ending::Interrupted => Outcome::Interrupted,
            Ending::Limit => Outcome::Limit,
            Ending::Emergency(emergency) => Outcome::Emergency(Stop {
                error: emergency.fault.to_string(),
                kind: emergency.fault.kind().to_string(),
                step: emergency.step,
            }),
        }
    }
}

/// The threads and timers of a program after a cycle.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tasks {
    /// The cycle of the last turn of each thread that runs; none of the main program, which has number 0.
    threads: [Option<u64>; THREADS + 1],
    /// The time of each timer, ms, and whether it runs.
    timers: [(f64, bool); TIMERS as usize],
}

/// A recording that grows cycle by cycle.
pub(crate) struct Recorder {
    pub(crate) recording: Recording,
    /// The last state under each key.
    states: HashMap<Cow<'static, str>, Occurrence>,
    pub(crate) summary: SummaryBuilder,
    slips: SlipDetector,
    falls: u32,
    upright_falls: u32,
    tasks: Tasks,
    /// Scalars that an event set and no step has read since.
    unread: Vec<usize>,
    pub(crate) frame_rate: FrameRate,
    /// The last frame, if it is not among those of the recording.
    pub(crate) pending: Option<Frame>,
}

impl Recorder {
    /// Creates a recorder with nothing recorded.
    pub(crate) fn new(robot: &Robot, script: Script) -> Self {
        Recorder {
            recording: Recording {
                robot: Skeleton::of(robot),
                scene: *robot.scene(),
                script,
                cycles: 0,
                clock: Vec::new(),
                frames: Vec::new(),
                log: Vec::new(),
                events: Vec::new(),
                outcome: Outcome::Limit,
                summary: Summary::default(),
                wait: None,
            },
            states: HashMap::new(),
            summary: SummaryBuilder::new(robot),
            slips: SlipDetector::default(),
            falls: 0,
            upright_falls: 0,
            tasks: Tasks::default(),
            unread: Vec::new(),
            frame_rate: FrameRate::Smooth,
            pending: None,
        }
    }

    /// Records a cycle of a run, which is in the state after it, and its present wait.
    pub(crate) fn take(&mut self, happened: Cycle, run: &Run, wait: Option<Wait>) {
        self.summary.after(run, wait);
        let cycle = happened.number;
        // The clock stands still in the cycle of a fault; who looks at it sees a cycle like others.
        let period = match run.time() - happened.time {
            passed if passed > 0.0 => passed,
            _ => run.period(),
        };
        self.keep_time(cycle, happened.time, period);
        self.note(happened);
        self.note_changes(cycle, run);
        self.end_threads(cycle, cycle);
        self.note_timers(cycle, run);
        let locks = Occurrence::Locks(run.locked());
        // A program that locks nothing has no locks.
        if locks != Occurrence::Locks(Vec::new()) || self.states.contains_key(&locks.key()) {
            self.note_state(cycle, locks);
        }
        let motion = run.motion();
        if let Some(motion) = &motion {
            let is_upright = motion.upright_falls > self.upright_falls;
            self.upright_falls = motion.upright_falls;
            let kind = FallKind::of(motion, is_upright);
            self.note_falls(cycle, motion.falls, motion.margin, Some(kind));
        }
        let mut frame = Frame {
            cycle,
            time: run.time(),
            pose: motion.map(|motion| motion.pose),
            margin: motion.map(|motion| motion.margin),
            gap: run.clearance().map(|clearance| clearance.now),
            ..Frame::default()
        };
        if let Some(limbs) = run.limbs() {
            frame.setpoints = setpoints(run, &limbs.angles);
            frame.angles = limbs.angles;
            frame.loads = limbs.loads;
            frame.forces = limbs.forces;
            frame.slips = limbs.slips;
            frame.torques = limbs.torques;
        }
        if let Some(grasp) = run.grasp() {
            let sum = |tip: &tip_runtime::plant::Fingertip| {
                [0, 1, 2].map(|axis| tip.on_floor[axis] + tip.on_objects[axis])
            };
            frame.pushes = grasp.fingertips.iter().map(sum).collect();
            frame.slider = Some(grasp.slider);
            let things = grasp.objects.iter().map(|object| ObjectPose {
                position: object.position,
                angle: object.angle,
            });
            frame.objects = things.collect();
        }
        frame.flags = raised(run, frame.angles.len());
        self.note_state(cycle, Occurrence::Flags(frame.flags.clone()));
        let modes = run.setpoints().into_iter().map(|aim| (aim.of, aim.mode));
        self.note_state(cycle, Occurrence::Modes(modes.collect()));
        frame.torque_joints = torque_joints(run, &frame.angles);
        self.keep(frame);
    }

    /// Notes that a cycle which began at `time` took `period` ms, as later ones do unless they change it.
    pub(crate) fn keep_time(&mut self, cycle: u64, time: f64, period: f64) {
        let is_same = |last: &Tick| (last.period - period).abs() < ROUNDING;
        if !self.recording.clock.last().is_some_and(is_same) {
            self.recording.clock.push(Tick {
                cycle,
                time,
                period,
            });
        }
    }

    /// Adds an occurrence.
    fn log(&mut self, cycle: u64, what: Occurrence) {
        self.recording.log.push(LogEntry { cycle, what });
    }

    /// Adds a state that was another one before.
    fn note_state(&mut self, cycle: u64, state: Occurrence) {
        let key = state.key();
        if self.states.get(&key) != Some(&state) {
            self.states.insert(key, state.clone());
            self.log(cycle, state);
        }
    }

    /// Returns the source line of the last step of the main program, from 1.
    pub(crate) fn line(&self) -> Option<u32> {
        match self.states.get("step") {
            Some(Occurrence::Step(step)) => {
                self.recording.script.lines.get(*step as usize).copied()
            }
            _ => None,
        }
    }

    /// Adds the effects of the program in a cycle.
    pub(crate) fn note(&mut self, happened: Cycle) {
        let cycle = happened.number;
        self.note_threads(cycle, &happened.threads);
        if happened.step.is_none() && happened.threads.is_empty() {
            return;
        }
        self.recording.cycles = cycle + 1;
        if let Some(step) = happened.step {
            self.note_state(cycle, Occurrence::Step(step));
        }
        let script = &self.recording.script;
        let assigned = |(name, value): (String, f64)| {
            let scalar = script.scalar(&name)?;
            Some(Occurrence::Assigned { scalar, value })
        };
        let messages = happened.messages.into_iter().map(Occurrence::Message);
        let lamps = happened.lamps.into_iter();
        let lamps = lamps.map(|(device, on)| Occurrence::Lamp(device, on));
        let commands = happened.commands.into_iter().map(Occurrence::Command);
        let sets = happened.set.into_iter().filter_map(assigned);
        let all = messages.chain(lamps).chain(commands).chain(sets);
        let entries = all.map(|what| LogEntry { cycle, what });
        self.recording.log.extend(entries);
    }

    /// Adds the values that events set before a cycle, and the first steps that read them. A value that the program has replaced in
    /// the same cycle is not added. A message that shows a value does not count as a read.
    fn note_changes(&mut self, cycle: u64, run: &Run) {
        let Recording {
            events,
            script,
            log,
            ..
        } = &mut self.recording;
        let later = &events[events.partition_point(|event| event.cycle < cycle)..];
        for event in later.iter().take_while(|event| event.cycle == cycle) {
            let Event::Set(name, value) = &event.event else {
                continue;
            };
            let Some(scalar) = script.scalar(name) else {
                continue;
            };
            let what = Occurrence::Assigned {
                scalar,
                value: *value,
            };
            let mut own = log.iter().rev().take_while(|entry| entry.cycle == cycle);
            if own.all(|entry| entry.what.key() != what.key()) {
                log.push(LogEntry { cycle, what });
            }
            if !self.unread.contains(&scalar) {
                self.unread.push(scalar);
            }
        }
        let program = run.engine::<Interpreter>().map(Interpreter::program);
        let Some(program) = program.filter(|_| !self.unread.is_empty()) else {
            return;
        };
        for step in run.steps() {
            let Some(step) = program.steps().get(step.from.step as usize) else {
                continue;
            };
            if let Action::Message { .. } | Action::FileMessage { .. } = step.action {
                continue;
            }
            access::reads(program, &step.action, |scalar| {
                let Some(at) = self.unread.iter().position(|unread| *unread == scalar) else {
                    return;
                };
                self.unread.remove(at);
                let what = Occurrence::Read {
                    scalar,
                    line: step.line,
                };
                self.recording.log.push(LogEntry { cycle, what });
            });
        }
    }

    /// Adds the steps of threads in a cycle.
    fn note_threads(&mut self, cycle: u64, threads: &[(u8, u32)]) {
        for (thread, step) in threads {
            if let Some(turn) = self.tasks.threads.get_mut(usize::from(*thread)) {
                *turn = Some(cycle);
                self.note_state(cycle, Occurrence::Thread(*thread, Some(*step)));
            }
        }
    }

    /// Notes in a cycle the end of threads that had no turn since another one.
    pub(crate) fn end_threads(&mut self, cycle: u64, since: u64) {
        for (thread, turn) in (0..).zip(self.tasks.threads) {
            if turn.is_some_and(|turn| turn < since) {
                self.tasks.threads[usize::from(thread)] = None;
                self.note_state(cycle, Occurrence::Thread(thread, None));
            }
        }
    }

    /// Adds the timers that did not go on as before.
    fn note_timers(&mut self, cycle: u64, run: &Run) {
        let log = &mut self.recording.log;
        for (number, (before, runs)) in (0..).zip(&mut self.tasks.timers) {
            let (now, period) = (run.timer(number), run.period());
            let expected = if *runs { *before + period } else { *before };
            if now != expected {
                *runs = now != *before && now > 0.0;
                let time = if *runs { run.time() - now } else { now };
                let what = Occurrence::Timer {
                    number,
                    runs: *runs,
                    time,
                };
                log.push(LogEntry { cycle, what });
            }
            *before = now;
        }
    }

    /// Adds the falls of the robot until the end of a cycle.
    pub(crate) fn note_falls(
        &mut self,
        cycle: u64,
        falls: u32,
        margin: f64,
        kind: Option<FallKind>,
    ) {
        if falls > self.falls {
            self.falls = falls;
            let fall = Occurrence::Fall {
                count: falls,
                margin,
                kind,
            };
            self.log(cycle, fall);
        }
    }

    /// Adds the motion of the robot in a cycle.
    pub(crate) fn keep(&mut self, mut frame: Frame) {
        let cycle = frame.cycle;
        if frame.slips.is_empty() {
            frame.slips = self.slips.measure(&self.recording.robot, &frame);
        }
        let touch = frame.loads.iter().map(|load| *load > 0.0);
        self.note_state(cycle, Occurrence::Contacts(touch.collect()));
        for slip in self.slips.begun(&frame.slips) {
            self.log(cycle, slip);
        }
        let collides = frame.gap.filter(|gap| gap.distance < 0.0);
        let collision = Occurrence::Collision(collides.map(|gap| gap.parts));
        // The end of a collision is noted only after its beginning.
        if collides.is_some() || self.states.contains_key(&collision.key()) {
            self.note_state(cycle, collision);
        }
        let is_due = |last: &Frame| match self.frame_rate {
            FrameRate::Smooth => frame.time - last.time > APART - ROUNDING,
            FrameRate::Every(cycles) => frame.cycle - last.cycle >= cycles,
        };
        let frames = &mut self.recording.frames;
        self.pending = match frames.last().is_none_or(is_due) {
            true => {
                frames.push(frame);
                None
            }
            false => Some(frame),
        };
    }

    /// Ends the recording.
    pub(crate) fn finish(mut self, outcome: Outcome) -> Recording {
        self.recording.frames.extend(self.pending.take());
        self.recording.outcome = outcome;
        self.recording.summary = self.summary.summary().clone();
        self.recording
    }
}

/// Returns the flags that are up, for a robot with so many legs.
fn raised(run: &Run, legs: usize) -> Vec<Flag> {
    let of = |target| [Flag::Inpos(target), Flag::Near(target)];
    let feet = (1..).take(legs).map(Target::Foot);
    let single = [Flag::HaltRequest, Flag::KbHit, Flag::Antenna];
    let flags = [Target::All].into_iter().chain(feet).flat_map(of);
    let flags = flags.chain(single).chain((0..10).map(Flag::Special));
    flags.filter(|flag| run.flag(*flag)).collect()
}

/// Returns the angle that each joint is commanded to be at; the angles are those of the joints, leg by leg.
fn setpoints(run: &Run, angles: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut commands = run.commands().iter();
    let mut of_joint = |angle: &f64| match commands.next() {
        Some(JointCommand::Angle { angle, .. }) => *angle,
        _ => *angle,
    };
    let legs = angles.iter();
    legs.map(|leg| leg.iter().map(&mut of_joint).collect())
        .collect()
}

/// Returns the joints that are driven by torque; the angles show how many each leg has.
fn torque_joints(run: &Run, angles: &[Vec<f64>]) -> Vec<Target> {
    let legs = (1..).zip(angles);
    let joints =
        legs.flat_map(|(leg, of)| (1..).zip(of).map(move |(of, _)| Target::Joint(leg, of)));
    let driven = joints.zip(run.commands());
    let by_torque = driven.filter(|(_, command)| matches!(command, JointCommand::Torque(_)));
    by_torque.map(|(joint, _)| joint).collect()
}

/// Distance from the place of touch-down at which a foot has slipped, mm.
const SLIPPED: f64 = 5.0;

/// Finds the slips of feet.
#[derive(Clone, Debug, Default)]
pub(crate) struct SlipDetector(Vec<Stance>);

/// The present stance of a foot.
#[derive(Clone, Copy, Debug, Default)]
struct Stance {
    /// Place of the touchdown; none in the air.
    touchdown: Option<Point>,
    /// The slip of this stance is in the log.
    is_logged: bool,
}

impl SlipDetector {
    /// Returns the slip of each foot of a trace, mm: the distance along the floor from where it began to carry load.
    fn measure(&mut self, robot: &Skeleton, frame: &Frame) -> Vec<f64> {
        let Some(pose) = &frame.pose else {
            return Vec::new();
        };
        self.0.resize(frame.loads.len(), Stance::default());
        let body = robot_frame(pose);
        let feet = robot.legs.iter().zip(&frame.angles);
        let feet = feet.map(|(leg, angles)| body.point(leg.foot(angles)));
        let stances = self.0.iter_mut().zip(&frame.loads).zip(feet);
        let slips = stances.map(|((stance, load), foot)| {
            if *load <= 0.0 {
                stance.touchdown = None;
                return 0.0;
            }
            let from = *stance.touchdown.get_or_insert(foot);
            libm::hypot(foot[0] - from[0], foot[1] - from[1])
        });
        slips.collect()
    }

    /// Returns the slips that became too large in a cycle, at most one of each stance.
    fn begun(&mut self, slips: &[f64]) -> Vec<Occurrence> {
        self.0.resize(slips.len(), Stance::default());
        let mut begun = Vec::new();
        for (leg, (stance, distance)) in self.0.iter_mut().zip(slips.iter().copied()).enumerate() {
            if distance > SLIPPED && !stance.is_logged {
                begun.push(Occurrence::Slip { leg, distance });
                stance.is_logged = true;
            }
            stance.is_logged &= distance > 0.0;
        }
        begun
    }
}

/// State of a recorder besides its recording.
#[derive(Clone, Debug)]
pub(crate) struct Checkpoint {
    cycle: u64,
    summary: SummaryBuilder,
    slips: SlipDetector,
    falls: u32,
    upright_falls: u32,
    tasks: Tasks,
    unread: Vec<usize>,
}

impl Recorder {
    /// Marks where it is.
    pub(crate) fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            cycle: self.recording.cycles,
            summary: self.summary.clone(),
            slips: self.slips.clone(),
            falls: self.falls,
            upright_falls: self.upright_falls,
            tasks: self.tasks,
            unread: self.unread.clone(),
        }
    }

    /// Returns to a checkpoint.
    pub(crate) fn take_back(&mut self, checkpoint: &Checkpoint) {
        self.summary = checkpoint.summary.clone();
        self.slips = checkpoint.slips.clone();
        self.falls = checkpoint.falls;
        self.upright_falls = checkpoint.upright_falls;
        self.tasks = checkpoint.tasks;
        self.unread.clone_from(&checkpoint.unread);
        self.pending = None;
        self.recording.cut(checkpoint.cycle);
        let entries = self.recording.log.iter().map(|entry| &entry.what);
        self.states = entries.map(|what| (what.key(), what.clone())).collect();
    }
}

impl Recording {
    /// Takes away what happened from a cycle on; events stay, since they are going to happen again.
    fn cut(&mut self, from: u64) {
        self.frames.retain(|frame| frame.cycle < from);
        self.clock.retain(|tick| tick.cycle < from);
        let kept = self.log.partition_point(|entry| entry.cycle < from);
        self.log.truncate(kept);
        self.cycles = from;
    }

    /// Returns the cycle before which a run that goes on is forgotten now, ms; `None` if it is not long enough.
    pub(crate) fn long_ago(&self, now: f64) -> Option<u64> {
        let begins = self.frames.first()?.time;
        if now - begins < PAST + SLACK {
            return None;
        }
        let kept = self.frames.partition_point(|frame| frame.time < now - PAST);
        self.frames.get(kept).map(|frame| frame.cycle)
    }

    /// Forgets what happened before a cycle, but for what still holds in it.
    pub(crate) fn forget(&mut self, before: u64) {
        self.frames.retain(|frame| frame.cycle >= before);
        self.events.retain(|event| event.cycle >= before);
        let later = self.clock.partition_point(|tick| tick.cycle <= before);
        self.clock.drain(..later.saturating_sub(1));
        let later = self.log.partition_point(|entry| entry.cycle < before);
        let mut seen = HashSet::new();
        let latest = self.log[..later].iter().rev();
        let mut kept: Vec<bool> = latest.map(|entry| seen.insert(entry.what.key())).collect();
        // Those that are left are asked for from the front on.
        self.log.retain(|_| kept.pop().unwrap_or(true));
    }
}
