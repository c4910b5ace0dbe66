//! A run: a program on a simulated robot, with events from outside.

use crate::cycle::{Collector, Cycle};
use crate::dyn_machine::DynMachine;
use crate::event::{Event, Events, Refused, Timed};
use crate::event_console::Listener;
use crate::motion::{Approach, Fall, Grasp, Incidents, Limbs};
use crate::program_runner::{ProgramRunner, StepTaken};
use crate::robot::Robot;
use crate::trace::{self, Trace, tee};
use std::fmt;
use std::time::Duration;
use tip_runtime::command::{Flag, Target};
use tip_runtime::console::{Console, Transcript};
use tip_runtime::controller::Setpoint;
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::{Emergency, Mismatch, Status};
use tip_runtime::model::Range;
use tip_runtime::plant::{Clearance, Motion, Pose, Travel};
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, Sink, state_hash};

/// The byte of the ESC key: a halt request.
const ESCAPE: u8 = 0x1B;

/// Time between two calls of an observer while a robot outside of this process is awaited.
const POLL_INTERVAL: Duration = Duration::from_millis(50);

/// Maximum length of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Limit(Option<u64>);

impl Limit {
    /// Until the program ends.
    pub const NONE: Self = Limit(None);

    /// Limits a run to a number of cycles since its start.
    pub const fn cycles(cycles: u64) -> Self {
        Limit(Some(cycles))
    }
}

impl From<Option<u64>> for Limit {
    fn from(cycles: Option<u64>) -> Self {
        Limit(cycles)
    }
}

/// Observes a run and can interrupt it.
pub trait Observer {
    /// Called before each cycle, and now and then while a robot outside of this process is awaited;
    /// `false` interrupts the run.
    fn goes_on(&mut self) -> bool {
        true
    }

    /// Returns the sink that records the cycle, if there is one. Each cycle that runs goes there
    /// once.
    fn sink(&mut self) -> Option<&mut dyn Sink> {
        None
    }

    /// Called after each cycle; the program may have ended in it.
    fn after(&mut self, run: &mut Run) {
        let _ = run;
    }
}

impl Observer for () {}

/// A program on a simulated robot, cycle by cycle.
///
/// A run is a value: it is copied with [`Clone`], saved with [`snapshot`](Self::snapshot) and set back with
/// [`restore`](Self::restore). Its listener is not copied.
pub struct Run {
    pub(crate) machine: Box<dyn DynMachine>,
    pub(crate) events: Events,
    /// Number of events that have happened.
    pub(crate) happened: usize,
    pub(crate) ending: Option<Ending>,
    pub(crate) incidents: Incidents,
    pub(crate) trace: Option<Trace>,
}

impl Run {
    /// Creates a run before its first cycle. The program is compiled code, or an interpreter from
    /// [`load`](crate::load).
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn new(
        program: impl Program + Clone + Send + 'static,
        robot: Robot,
    ) -> Result<Self, Mismatch> {
        Self::of(ProgramRunner::new(program), &robot)
    }

    /// Creates a run of a program with any engine.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn of(program: ProgramRunner, robot: &Robot) -> Result<Self, Mismatch> {
        Ok(Self::on(robot.start(program)?))
    }

    pub(crate) fn on(machine: Box<dyn DynMachine>) -> Self {
        let clearance = machine.hardware().gap().map(Clearance::new);
        Run {
            machine,
            events: Events::NONE,
            happened: 0,
            ending: None,
            incidents: Incidents {
                clearance,
                ..Incidents::default()
            },
            trace: None,
        }
    }

    /// Adds events, given as text.
    ///
    /// # Errors
    /// The text is not a list of events, or the robot lacks an input.
    pub fn events(self, text: &str) -> Result<Self, Refused> {
        let events = text.parse::<Events>().map_err(Refused::Text)?;
        self.with_events(&events)
    }

    /// Adds events.
    ///
    /// # Errors
    /// The robot lacks an input.
    pub fn with_events(mut self, events: &Events) -> Result<Self, Refused> {
        for event in events.all() {
            self.add(event.clone())?;
        }
        Ok(self)
    }

    /// Checks that an event can happen to this run.
    ///
    /// # Errors
    /// The robot lacks the input or has no mass, or the program has no such variable, or it cannot have the value.
    pub fn accepts(&self, event: &Event) -> Result<(), Refused> {
        let can = match event {
            Event::Sensor(port, _) if !self.machine.hardware().has_input(*port) => {
                return Err(Refused::NoInput(*port));
            }
            Event::Set(name, value) => {
                let refused = |error| Refused::Variable(name.clone(), error);
                return self.program().accepts(name, *value).map_err(refused);
            }
            Event::Push(..) => self.machine.hardware().can_be_pushed(),
            Event::Noise(_) => self.machine.hardware().can_have_noise(),
            _ => true,
        };
        match (can, self.machine.hardware().is_bolted_down()) {
            (true, _) => Ok(()),
            (false, true) => Err(Refused::BoltedDown(event.to_string())),
            (false, false) => Err(Refused::Massless(event.to_string())),
        }
    }

    /// Adds an event. If its cycle is over, it happens in the next one.
    ///
    /// # Errors
    /// The errors of [`accepts`](Self::accepts).
    pub fn add(&mut self, event: Timed) -> Result<(), Refused> {
        self.accepts(&event.event)?;
        self.events.insert(self.happened, event);
        Ok(())
    }

    /// Returns all events, past and to come.
    pub fn all_events(&self) -> &Events {
        &self.events
    }

    /// Removes all future events. Past ones stay.
    pub fn forget_events(&mut self) {
        self.events.truncate(self.happened);
    }

    /// Assigns a variable before the next step, as an event that is replayed after [`restore`](Self::restore).
    ///
    /// # Errors
    /// The program has no such variable, or it is a constant, or the value is not finite.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), Refused> {
        self.add(Event::Set(name.to_owned(), value).at(self.cycles()))
    }

    /// Sets the console, which gets the output of the program from now on and gives keys after those of events. It
    /// replaces the previous one.
    #[must_use]
    pub fn with_console(mut self, console: impl Console + Send + 'static) -> Self {
        let listener: Box<dyn Listener> = Box::new(console);
        self.machine.console_mut().replace(Some(listener));
        self
    }

    /// Returns the console, if it is one of type `C`.
    pub fn console<C: Console + 'static>(&self) -> Option<&C> {
        self.machine.console().listener()?.downcast_ref()
    }

    /// Returns the console, if it is one of type `C`.
    pub fn console_mut<C: Console + 'static>(&mut self) -> Option<&mut C> {
        self.machine.console_mut().listener_mut()?.downcast_mut()
    }

    /// Follows the steps from now on, for [`steps`](Self::steps) and a [`WaitDetector`](crate::WaitDetector).
    #[must_use]
    pub fn followed(mut self) -> Self {
        self.machine.program_mut().follow();
        self
    }

    /// Returns the steps that ran to their end in the last cycle, those of threads included; none unless they are
    /// [followed](Self::followed).
    pub fn steps(&self) -> &[StepTaken] {
        self.machine.program().trail()
    }

    /// Keeps a trace from now on; `with_state` ends each record with a hash of joint commands and measurements.
    #[must_use]
    pub fn with_trace(mut self, with_state: bool) -> Self {
        self.trace = Some(Trace::new(with_state));
        self
    }

    /// Returns the trace so far, with its last record if the run has ended; empty if none is kept.
    pub fn trace(&self) -> String {
        let trace = self.trace.as_ref();
        trace.map_or(String::new(), |trace| {
            trace.text(self.ending, self.cycles())
        })
    }

    /// Runs until the program ends or the cycles are used up.
    pub fn to_end(&mut self, limit: Limit) -> Ending {
        self.observed(limit, &mut ())
    }

    /// Runs until the program ends, the cycles are used up, or the observer interrupts.
    pub fn observed(&mut self, limit: Limit, observer: &mut (impl Observer + ?Sized)) -> Ending {
        loop {
            if let Some(ending @ (Ending::Program(_) | Ending::Emergency(_))) = self.ending {
                return ending;
            }
            if limit.0.is_some_and(|limit| self.cycles() >= limit) {
                return self.end(Ending::Limit);
            }
            if !self.is_awaited(observer) || !observer.goes_on() {
                return self.end(Ending::Interrupted);
            }
            self.advance(observer.sink());
            // Waits for the result of this cycle. An observer that interrupts need not wait.
            self.is_awaited(observer);
            observer.after(self);
        }
    }

    /// Waits for a robot outside of this process. Returns false if the observer interrupts the wait.
    fn is_awaited(&mut self, observer: &mut (impl Observer + ?Sized)) -> bool {
        while !self.machine.hardware_mut().is_ready(POLL_INTERVAL) {
            if !observer.goes_on() {
                return false;
            }
        }
        true
    }

    fn end(&mut self, ending: Ending) -> Ending {
        *self.ending.insert(ending)
    }

    /// Runs one cycle, and returns what happened in it. After the program's end the robot is still held.
    pub fn cycle(&mut self) -> Cycle {
        self.reported(None)
    }

    /// Runs one cycle as [`cycle`](Self::cycle) does, and reports it to a sink, too.
    pub fn reported(&mut self, sink: Option<&mut dyn Sink>) -> Cycle {
        let mut collector = Collector::new(self.cycles(), self.time());
        let status = tee(Some(&mut collector), sink, |sink| self.advance(sink));
        collector.finish(self.machine.as_ref(), status)
    }

    /// Runs one cycle, and reports it to a sink and the trace.
    pub fn advance(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        self.happen();
        self.machine.program_mut().begin_trail();
        let (cycle, time, step) = (self.cycles(), self.time(), self.program().at());
        let own = self.trace.as_mut().map(Trace::sink);
        let status = tee(own, sink, |sink| self.machine.cycle(sink));
        self.trace.iter_mut().for_each(Trace::keep);
        self.note_incidents(cycle, time, step);
        self.ending = match status {
            Status::Running => None,
            Status::Finished(end) => Some(Ending::Program(end)),
            Status::Emergency => self.emergency().map(Ending::Emergency),
        };
        status
    }

    /// Applies all events that are due.
    pub(crate) fn happen(&mut self) {
        let cycle = self.cycles();
        while let Some(due) = self.events.all().get(self.happened) {
            if due.cycle > cycle {
                break;
            }
            match &due.event {
                Event::Key(byte) => self.machine.console_mut().press(*byte),
                Event::Halt => self.machine.console_mut().press(ESCAPE),
                // `accepts` has checked that the robot has the input.
                Event::Sensor(port, volts) => {
                    self.machine.hardware_mut().set_sensor(*port, *volts);
                }
                // `accepts` has checked the assignment.
                Event::Set(name, value) => drop(self.machine.program_mut().set(name, *value)),
                Event::Touch(on) => self.machine.hardware_mut().touch(*on),
                // `accepts` has checked that the simulation of the robot supports both.
                Event::Push(force, cycles) => {
                    self.machine.hardware_mut().push(*force, *cycles);
                }
                Event::Noise(noise) => {
                    self.machine.hardware_mut().set_noise(*noise);
                }
                Event::ReadFails => self.machine.hardware_mut().read_fails = true,
                Event::WriteFails => self.machine.hardware_mut().write_fails = true,
            }
            self.happened += 1;
        }
    }

    /// Pauses or continues the program. During a pause the robot is held, no steps run and cycles do not count.
    pub fn pause(&mut self, on: bool) {
        self.machine.pause(on);
    }

    /// Returns the ending, if the run has ended. A run that ended at its limit can be continued.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// Returns the cause and the place of an emergency stop.
    pub fn emergency(&self) -> Option<Emergency> {
        self.machine.emergency().copied()
    }

    /// Returns the number of cycles whose step ran without a fault.
    pub fn cycles(&self) -> u64 {
        self.machine.cycles()
    }

    /// Returns the time on the robot, ms.
    pub fn time(&self) -> f64 {
        self.machine.time()
    }

    /// Returns the sampling time, ms.
    pub fn period(&self) -> f64 {
        self.machine.period()
    }

    /// Returns the program in its present state.
    pub fn program(&self) -> &dyn Program {
        self.machine.program()
    }

    /// Returns the program, if it is one of type `P`, such as [`Interpreter`](crate::Interpreter).
    pub fn engine<P: Program + 'static>(&self) -> Option<&P> {
        self.machine.program().get()
    }

    /// Returns the simulated plant, if it is of type `H`, such as [`SimulatedPlant<4,
    /// 3>`](tip_runtime::plant::SimulatedPlant).
    pub fn plant<H: 'static>(&self) -> Option<&H> {
        self.machine.hardware().plant().downcast_ref()
    }

    /// Returns the value of an event flag, as the step of the next cycle reads it unless sensors or keys change it.
    pub fn flag(&self, flag: Flag) -> bool {
        self.machine.flag(flag)
    }

    /// Returns true if a thread (from 1, in the order of the text) runs.
    pub fn thread_runs(&self, thread: u8) -> bool {
        self.machine.thread_runs(thread)
    }

    /// Returns the step that the main program (0) or a thread takes next.
    pub fn step_of(&self, thread: u8) -> u32 {
        let program = self.program();
        program
            .thread(thread)
            .map_or(program.at(), |(_, step)| step)
    }

    /// Returns the time of timer `n`, ms.
    pub fn timer(&self, n: u8) -> f64 {
        self.machine.timer(n)
    }

    /// Returns the joints that the program locked.
    pub fn locked(&self) -> Vec<Target> {
        self.machine.locked()
    }

    /// Returns the working limits in force of each joint, leg by leg, deg.
    pub fn limits(&self) -> Vec<Range> {
        self.machine.limits()
    }

    /// Returns the command of each joint in the last cycle, leg by leg.
    pub fn commands(&self) -> &[JointCommand] {
        self.machine.commands()
    }

    /// Returns the joint angles measured in the last cycle, leg by leg, deg.
    pub fn angles(&self) -> &[f64] {
        self.machine.angles()
    }

    /// Returns true if a lamp or relay is on.
    pub fn lamp(&self, device: u8) -> bool {
        let word = self.machine.lamps().get(usize::from(device / 32));
        word.is_some_and(|word| word >> (device % 32) & 1 == 1)
    }

    /// Returns a hash of the commands to each joint and its readings in the last cycle.
    pub fn state_hash(&self) -> u64 {
        state_hash(self.commands(), self.angles())
    }
}

impl Run {
    /// Returns the motion of the body; none for a robot that stays where it is, or that another
    /// process simulates.
    pub fn motion(&self) -> Option<Motion> {
        self.machine.hardware().motion()
    }

    /// Returns the pose of the body; none for a robot that stays where it is, or that another
    /// process simulates without giving it.
    pub fn pose(&self) -> Option<Pose> {
        self.machine.hardware().pose()
    }

    /// Returns the travel of the body; `None` for a robot that stays where it is, or that another process simulates
    /// without giving the pose.
    pub fn travel(&self) -> Option<Travel> {
        self.machine.hardware().travel()
    }

    /// Returns time and place of the robot's first fall, if it fell.
    pub fn first_fall(&self) -> Option<Fall> {
        self.incidents.fall
    }

    /// Returns the distances between the links and the body; none if the simulation does not measure them.
    pub fn clearance(&self) -> Option<Clearance> {
        self.incidents.clearance
    }

    /// Returns the least distance of two parts after a cycle so far, and its place; none before the first cycle, or if
    /// the simulation does not measure it.
    pub fn nearest_approach(&self) -> Option<Approach> {
        self.incidents.nearest
    }

    /// Returns the first collision of two parts.
    pub fn first_collision(&self) -> Option<Approach> {
        self.incidents.collision
    }

    /// Returns the state of legs or fingers after the last cycle; `None` if only joints are simulated.
    pub fn limbs(&self) -> Option<Limbs> {
        self.machine.hardware().limbs()
    }

    /// Returns the set points of every leg or finger, foot by foot or joint by joint.
    pub fn setpoints(&self) -> Vec<Setpoint> {
        self.machine.setpoints()
    }

    /// Returns the robot's grasp; none if it is not a hand.
    pub fn grasp(&self) -> Option<Grasp> {
        self.machine.hardware().grasp()
    }

    /// Records the first fall, the first collision and the smallest distance of two parts, if they happened in this
    /// cycle.
    fn note_incidents(&mut self, cycle: u64, time: f64, step: u32) {
        if let Some(gap) = self.machine.hardware().gap() {
            let approach = Approach {
                gap,
                cycle,
                time,
                step,
            };
            let Incidents {
                clearance,
                nearest,
                collision,
                ..
            } = &mut self.incidents;
            let clearance = clearance.get_or_insert(Clearance::new(gap));
            clearance.update(gap, cycle);
            if nearest.is_none_or(|nearest| gap.distance < nearest.gap.distance) {
                *nearest = Some(approach);
            }
            if gap.distance < 0.0 {
                collision.get_or_insert(approach);
            }
        }
        if self.incidents.fall.is_none() {
            self.incidents.fall = self.machine.hardware().first_fall().map(|fall| Fall {
                cycle,
                time,
                step,
                margin: fall.margin,
                is_upright: fall.is_upright,
            });
        }
    }
}

impl Clone for Run {
    fn clone(&self) -> Self {
        Run {
            machine: self.machine.boxed(),
            events: self.events.clone(),
            happened: self.happened,
            ending: self.ending,
            incidents: self.incidents,
            trace: self.trace.clone(),
        }
    }
}

impl fmt::Debug for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Run")
            .field("program", self.machine.program())
            .field("cycles", &self.cycles())
            .field("ending", &self.ending)
            .finish_non_exhaustive()
    }
}

/// The state of a run at a cycle: program, controller, plant, special commands, waiting keys, the number of past
/// events, and the lengths of its trace and of its console's transcript.
pub struct Snapshot {
    machine: Box<dyn DynMachine>,
    happened: usize,
    ending: Option<Ending>,
    incidents: Incidents,
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
    /// Returns the present state of the run.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            machine: self.machine.boxed(),
            happened: self.happened,
            ending: self.ending,
            incidents: self.incidents,
            trace: self.trace.as_ref().map(trace::Trace::mark),
            shown: self.console().map(Lengths::of),
        }
    }

    /// Sets the run back to a snapshot of it. From there on the same events give the same run, bit for bit. The console
    /// stays, but a [`Transcript`](tip_runtime::console::Transcript) and the trace are cut to their lengths in the
    /// snapshot.
    pub fn restore(&mut self, mark: &Snapshot) {
        let listener = self.machine.console_mut().replace(None);
        self.machine = mark.machine.boxed();
        self.machine.console_mut().replace(listener);
        self.happened = mark.happened;
        self.ending = mark.ending;
        self.incidents = mark.incidents;
        if let (Some(trace), Some(mark)) = (&mut self.trace, &mark.trace) {
            trace.restore(mark);
        }
        if let (Some(shown), Some(lengths)) = (self.console_mut(), mark.shown) {
            lengths.restore(shown);
        }
    }
}

/// The lengths of the growing parts of a transcript.
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

    /// Removes everything after these lengths.
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
