//! Recordings of runs: a recorder, which can be taken back and can forget.

use crate::recording::{
    Assigned, At, Fallen, Frame, FrameRate, ObjectPose, Outcome, Recording, Script, Skeleton, Slip,
    Stop, Tick, Timer, robot_frame,
};
use std::collections::HashSet;
use std::fmt;
use std::hash::Hash;
use tip_runtime::command::{Flag, TIMERS, Target};
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::Mismatch;
use tip_runtime::model::Point;
use tip_runtime::program::{End, THREADS};
use tip_runtime::record::Ending;
use tip_sim::{
    Cycle, Events, FallKind, Interpreter, Refused, Robot, Run, Summary, SummaryBuilder, Wait,
    WaitDetector,
};
use tipc::Loaded;
use tipc::language::Keyword;
use tipc::source::Source;

/// Time between two frames, at least, ms.
const APART: f64 = 20.0;

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
    /// Runs a program by the reference interpreter to its end, or to that of the extent, as long as `goes_on` agrees.
    ///
    /// # Errors
    /// There is no program, or it cannot run on that robot, or one of the events cannot happen to it.
    pub fn of(
        loaded: &Loaded,
        robot: &Robot,
        events: &Events,
        extent: DurationLimit,
        goes_on: impl FnMut() -> bool,
    ) -> Result<Self, RecordError> {
        Self::paced(loaded, robot, events, extent, FrameRate::Smooth, goes_on)
    }

    /// Records a program, with the motion kept as often as asked.
    ///
    /// # Errors
    /// There is no program, or it cannot run on that robot, or one of the events cannot happen to it.
    pub fn paced(
        loaded: &Loaded,
        robot: &Robot,
        events: &Events,
        extent: DurationLimit,
        pace: FrameRate,
        goes_on: impl FnMut() -> bool,
    ) -> Result<Self, RecordError> {
        let program = loaded.program.as_ref().ok_or(RecordError::NoProgram)?;
        let interpreter = Interpreter::new(program.clone());
        let run = Run::new(interpreter, robot.clone())
            .map_err(RecordError::Mismatch)?
            .with_events(events)
            .map_err(RecordError::Refused)?;
        Self::of_run(run, loaded, robot, extent, pace, goes_on)
    }

    /// Records a run of a program that has not begun.
    ///
    /// # Errors
    /// There is no program.
    pub fn of_run(
        run: Run,
        loaded: &Loaded,
        robot: &Robot,
        extent: DurationLimit,
        pace: FrameRate,
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<Self, RecordError> {
        let program = loaded.program.as_ref().ok_or(RecordError::NoProgram)?;
        let mut recorder = Recorder::new(robot, Script::of(&loaded.source, program));
        recorder.recording.events = run.all_events().all().to_vec();
        recorder.pace = pace;
        let mut run = run.followed();
        let mut waits = WaitDetector::default();
        let outcome = loop {
            if let Some(ending) = run.ending() {
                break Outcome::from(ending);
            }
            if extent.is_over(&run, &waits) {
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
    /// The last step of each thread, and its cycle; none of the main program, which has number 0.
    threads: [Option<(u32, u64)>; THREADS + 1],
    /// The time of each timer, ms, and whether it runs.
    timers: [(f64, bool); TIMERS as usize],
}

/// A recording that grows cycle by cycle.
pub(crate) struct Recorder {
    pub(crate) recording: Recording,
    pub(crate) summary: SummaryBuilder,
    slips: SlipDetector,
    falls: u32,
    upright_falls: u32,
    tasks: Tasks,
    pub(crate) pace: FrameRate,
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
                steps: Vec::new(),
                threads: Vec::new(),
                timers: Vec::new(),
                locks: Vec::new(),
                messages: Vec::new(),
                sets: Vec::new(),
                lamps: Vec::new(),
                commands: Vec::new(),
                contacts: Vec::new(),
                flags: Vec::new(),
                modes: Vec::new(),
                falls: Vec::new(),
                slips: Vec::new(),
                events: Vec::new(),
                outcome: Outcome::Limit,
                summary: Summary::default(),
                wait: None,
            },
            summary: SummaryBuilder::new(robot),
            slips: SlipDetector::default(),
            falls: 0,
            upright_falls: 0,
            tasks: Tasks::default(),
            pace: FrameRate::Smooth,
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
        self.end_threads(cycle, cycle);
        self.note_timers(cycle, run);
        let locked = run.locked();
        if !(locked.is_empty() && self.recording.locks.is_empty()) {
            note_change(&mut self.recording.locks, cycle, &locked);
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
        note_change(&mut self.recording.flags, cycle, &frame.flags);
        let modes: Vec<_> = run
            .setpoints()
            .iter()
            .map(|aim| (aim.of, aim.mode))
            .collect();
        note_change(&mut self.recording.modes, cycle, &modes);
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

    /// Adds the effects of the program in a cycle.
    pub(crate) fn note(&mut self, happened: Cycle) {
        let Cycle {
            number: cycle,
            step,
            set,
            messages,
            lamps,
            commands,
            threads,
            ..
        } = happened;
        self.note_threads(cycle, &threads);
        let recording = &mut self.recording;
        if step.is_none() && threads.is_empty() {
            return;
        }
        recording.cycles = cycle + 1;
        if let Some(step) = step
            && recording.steps.last().is_none_or(|last| last.what != step)
        {
            recording.steps.push(At { cycle, what: step });
        }
        let at = |what| At { cycle, what };
        recording.messages.extend(messages.into_iter().map(at));
        let at = |what| At { cycle, what };
        recording.lamps.extend(lamps.into_iter().map(at));
        let at = |what| At { cycle, what };
        recording.commands.extend(commands.into_iter().map(at));
        for (name, value) in set {
            let scalar = recording.script.scalar(&name);
            let assigned = scalar.map(|scalar| Assigned { scalar, value });
            recording
                .sets
                .extend(assigned.map(|what| At { cycle, what }));
        }
    }

    /// Adds the steps of threads in a cycle.
    pub(crate) fn note_threads(&mut self, cycle: u64, threads: &[(u8, u32)]) {
        for (thread, step) in threads {
            let Some(task) = self.tasks.threads.get_mut(usize::from(*thread)) else {
                continue;
            };
            if task.is_none_or(|(last, _)| last != *step) {
                let what = (*thread, Some(*step));
                self.recording.threads.push(At { cycle, what });
            }
            *task = Some((*step, cycle));
        }
    }

    /// Notes in a cycle the end of threads that had no turn since another one.
    pub(crate) fn end_threads(&mut self, cycle: u64, since: u64) {
        for (thread, task) in (0..).zip(&mut self.tasks.threads) {
            if task.is_some_and(|(_, last)| last < since) {
                *task = None;
                let what = (thread, None);
                self.recording.threads.push(At { cycle, what });
            }
        }
    }

    /// Adds the timers that did not go on as before.
    fn note_timers(&mut self, cycle: u64, run: &Run) {
        for (number, (before, runs)) in (0..).zip(&mut self.tasks.timers) {
            let (now, period) = (run.timer(number), run.period());
            let expected = if *runs { *before + period } else { *before };
            if now != expected {
                *runs = now != *before && now > 0.0;
                let time = if *runs { run.time() - now } else { now };
                let what = Timer {
                    number,
                    runs: *runs,
                    time,
                };
                self.recording.timers.push(At { cycle, what });
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
            let what = Fallen { margin, kind };
            self.recording.falls.push(At { cycle, what });
        }
    }

    /// Adds the motion of the robot in a cycle.
    pub(crate) fn keep(&mut self, mut frame: Frame) {
        let recording = &mut self.recording;
        let cycle = frame.cycle;
        if frame.slips.is_empty() {
            frame.slips = self.slips.measure(&recording.robot, &frame);
        }
        let touch: Vec<bool> = frame.loads.iter().map(|load| *load > 0.0).collect();
        note_change(&mut recording.contacts, cycle, &touch);
        self.slips.note(&mut recording.slips, cycle, &frame.slips);
        let is_due = |last: &Frame| match self.pace {
            FrameRate::Smooth => frame.time - last.time > APART - ROUNDING,
            FrameRate::Every(cycles) => frame.cycle - last.cycle >= cycles,
        };
        self.pending = match recording.frames.last().is_none_or(is_due) {
            true => {
                recording.frames.push(frame);
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

/// Keeps what something is from a cycle on, if it was not that before.
fn note_change<T: Clone + PartialEq>(list: &mut Vec<At<Vec<T>>>, cycle: u64, now: &[T]) {
    if list.last().is_none_or(|last| last.what != now) {
        let what = now.to_vec();
        list.push(At { cycle, what });
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

/// One foot.
#[derive(Clone, Copy, Debug, Default)]
struct Stance {
    /// Place of the touchdown; none in the air.
    touchdown: Option<Point>,
    /// Largest slip of this stance, once it is listed, mm.
    listed: Option<f64>,
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

    /// Lists the slips of a cycle; each stance has one at most, with its largest distance so far.
    fn note(&mut self, list: &mut Vec<At<Slip>>, cycle: u64, slips: &[f64]) {
        self.0.resize(slips.len(), Stance::default());
        for (leg, (stance, distance)) in self.0.iter_mut().zip(slips.iter().copied()).enumerate() {
            match stance.listed {
                _ if distance <= 0.0 => stance.listed = None,
                None if distance > SLIPPED => {
                    stance.listed = Some(distance);
                    let what = Slip { leg, distance };
                    list.push(At { cycle, what });
                }
                Some(largest) if distance > largest => {
                    stance.listed = Some(distance);
                    set_last(list, leg, distance);
                }
                _ => {}
            }
        }
    }

    /// Takes back the distances of slips that go on.
    fn restore(&self, list: &mut [At<Slip>]) {
        for (leg, stance) in self.0.iter().enumerate() {
            if let Some(distance) = stance.listed {
                set_last(list, leg, distance);
            }
        }
    }
}

/// Sets the distance of the last slip of a leg.
fn set_last(list: &mut [At<Slip>], leg: usize, distance: f64) {
    let mut latest = list.iter_mut().rev();
    if let Some(slip) = latest.find(|slip| slip.what.leg == leg) {
        slip.what.distance = distance;
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
        }
    }

    /// Returns to a checkpoint.
    pub(crate) fn take_back(&mut self, checkpoint: &Checkpoint) {
        self.summary = checkpoint.summary.clone();
        self.slips = checkpoint.slips.clone();
        self.falls = checkpoint.falls;
        self.upright_falls = checkpoint.upright_falls;
        self.tasks = checkpoint.tasks;
        self.pending = None;
        self.recording.cut(checkpoint.cycle);
        self.slips.restore(&mut self.recording.slips);
    }
}

impl Recording {
    /// Takes away what happened from a cycle on; events stay, since they are going to happen again.
    fn cut(&mut self, from: u64) {
        let count = self.frames.partition_point(|frame| frame.cycle < from);
        self.frames.truncate(count);
        let ticks = self.clock.partition_point(|tick| tick.cycle < from);
        self.clock.truncate(ticks);
        cut(&mut self.steps, from);
        cut(&mut self.threads, from);
        cut(&mut self.timers, from);
        cut(&mut self.locks, from);
        cut(&mut self.messages, from);
        cut(&mut self.sets, from);
        cut(&mut self.lamps, from);
        cut(&mut self.commands, from);
        cut(&mut self.contacts, from);
        cut(&mut self.flags, from);
        cut(&mut self.modes, from);
        cut(&mut self.falls, from);
        cut(&mut self.slips, from);
        self.cycles = from;
    }

    /// Forgets what happened before a cycle, but for what still holds in it, and for falls, which are counted.
    pub(crate) fn forget(&mut self, before: u64) {
        self.frames.retain(|frame| frame.cycle >= before);
        let later = self.clock.partition_point(|tick| tick.cycle <= before);
        if let Some(Tick {
            cycle,
            time,
            period,
        }) = self.clock.get(later.wrapping_sub(1)).copied()
        {
            let passed = before.saturating_sub(cycle) as f64 * period;
            self.clock.drain(..later - 1);
            self.clock[0] = Tick {
                cycle: before,
                time: time + passed,
                period,
            };
        }
        keep_last(&mut self.steps, before, |_| ());
        keep_last(&mut self.threads, before, |thread| thread.0);
        keep_last(&mut self.timers, before, |timer| timer.number);
        keep_last(&mut self.locks, before, |_| ());
        keep_last(&mut self.contacts, before, |_| ());
        keep_last(&mut self.flags, before, |_| ());
        keep_last(&mut self.modes, before, |_| ());
        keep_last(&mut self.messages, before, |_| ());
        keep_last(&mut self.sets, before, |set| set.scalar);
        keep_last(&mut self.lamps, before, |lamp| lamp.0);
        keep_last(&mut self.commands, before, |asked| asked.target.to_string());
        self.slips.retain(|slip| slip.cycle >= before);
        self.events.retain(|event| event.cycle >= before);
    }
}

fn cut<T>(list: &mut Vec<At<T>>, from: u64) {
    list.truncate(list.partition_point(|at| at.cycle < from));
}

/// Keeps the last value of each key of everything that happened before a cycle.
fn keep_last<T, K: Eq + Hash>(list: &mut Vec<At<T>>, before: u64, key: impl Fn(&T) -> K) {
    let mut seen = HashSet::new();
    let later = list.partition_point(|at| at.cycle < before);
    let mut kept: Vec<bool> = list[..later]
        .iter()
        .rev()
        .map(|at| seen.insert(key(&at.what)))
        .collect();
    // Those that are left are asked for from the front on.
    list.retain(|_| kept.pop().unwrap_or(true));
}
