//! Every way in which a run on servos can end, at every moment and for every family: the registers of the servos after the host is
//! gone, and the time until then. The first half of the tables of docs/drives.md and docs/faults.md is made of it.
//!
//! `at_end` and `in_emergency` are opposite in each run, so that the servos show which of them was obeyed.

use crate::faults::terminal::Pty;
use crate::servo_bus::ServoBus;
use crate::support::Folder;
use rustix::process::{Pid, Signal, kill_process};
use rustix::termios::{LocalModes, tcgetattr};
use std::fmt::{self, Write};
use std::io::Read;
use std::process::{Child, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};
use tip_drives::simulated::{Servo, SimulatedBus};

/// Something that ends a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Event {
    Return,
    Escape,
    CtrlC,
    TwoSigterm,
    Sighup,
    Sigquit,
    Kill,
    UsbGone,
    End,
    ProgramFault,
}

const EVENTS: [Event; 10] = [
    Event::Return,
    Event::Escape,
    Event::CtrlC,
    Event::TwoSigterm,
    Event::Sighup,
    Event::Sigquit,
    Event::Kill,
    Event::UsbGone,
    Event::End,
    Event::ProgramFault,
];

/// The moment at which it comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    BeforeTorque,
    Approach,
    Walking,
    Leaving,
}

const PHASES: [Phase; 4] = [
    Phase::BeforeTorque,
    Phase::Approach,
    Phase::Walking,
    Phase::Leaving,
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Policy {
    Hold,
    Relax,
}

/// A model of each family, its supply, and what its servos do without a host.
const FAMILIES: [(&str, &str); 4] = [
    ("AX-12", "[6, 15]"),
    ("XL430-W250", "[6, 15]"),
    ("STS3215", "[6, 15]"),
    ("moteus-mj5208", "[6, 30]"),
];

/// The state in which the servos are left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Left {
    /// Their torque was never on.
    Untouched,
    /// As `at_end` says.
    AtEnd,
    /// As `in_emergency` says.
    InEmergency,
    /// They hold their last goal.
    Stiff,
    /// Bus Watchdog error: they stand, and refuse goals.
    Watchdog,
    /// Mode 11: they brake, and refuse goals.
    Damped,
    /// The run goes on: the key starts it.
    Started,
    /// Anything else.
    Other,
}

impl fmt::Display for Left {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Left::Untouched => "no torque",
            Left::AtEnd => "`at_end`",
            Left::InEmergency => "`in_emergency`",
            Left::Stiff => "hold the last goal",
            Left::Watchdog => "stop within the time-out and keep their torque",
            Left::Damped => "brake within the time-out",
            Left::Started => "starts the robot",
            Left::Other => "unknown",
        })
    }
}

#[derive(Clone, Copy, Debug)]
struct Cell {
    event: Event,
    phase: Phase,
    /// `at_end`; `in_emergency` is the other one.
    at_end: Policy,
    family: usize,
}

/// The end of a cell.
#[derive(Clone, Debug)]
struct Found {
    left: Left,
    /// Time from the event until the process was gone, ms.
    after: u128,
    /// What the servos showed, and what the command said.
    details: String,
}

/// Returns false if the event cannot come at that moment: a program neither ends nor fails before it begins, or after.
fn is_possible(event: Event, phase: Phase) -> bool {
    !matches!(event, Event::End | Event::ProgramFault) || phase == Phase::Walking
}

/// Returns the state in which the servos must be left, reasoned from docs/drives.md.
fn expected(cell: Cell) -> Left {
    let without_host = match FAMILIES[cell.family].0 {
        "XL430-W250" => Left::Watchdog,
        "moteus-mj5208" => Left::Damped,
        _ => Left::Stiff,
    };
    match (cell.event, cell.phase) {
        (Event::Return, Phase::BeforeTorque) => Left::Started,
        (_, Phase::BeforeTorque) => Left::Untouched,
        // Nothing is sent any more.
        (Event::Kill | Event::UsbGone, _) => without_host,
        // The run was leaving in order already.
        (_, Phase::Leaving) => Left::AtEnd,
        (Event::Return | Event::ProgramFault, _) => Left::InEmergency,
        _ => Left::AtEnd,
    }
}

/// ms
const PERIOD: u64 = 40;
/// deg/s; the approach of 40 deg takes two seconds.
const START: f64 = 20.0;

fn description(model: &str, voltage: &str, at_end: Policy) -> String {
    let word = |policy| match policy {
        Policy::Hold => "hold",
        Policy::Relax => "relax",
    };
    let other = match at_end {
        Policy::Hold => Policy::Relax,
        Policy::Relax => Policy::Hold,
    };
    format!(
        "name = \"ends\"\n\
         joint = [\n\
         \x20   {{ axis = \"z\", link = [100, 0, 0], limits = [-90, 90] }},\n\
         \x20   {{ axis = \"z\", link = [100, 0, 0], limits = [-90, 90] }},\n\
         ]\n\
         leg = [{{ base = [0, 0, 0] }}]\n\
         [standards]\nperiod = {PERIOD}\n\
         [bus]\nservo = \"{model}\"\nbaud = 1000000\nlatency = 200\nsilence = 50\nlag = [90, 60]\n\
         voltage = {voltage}\nstart = {START}\nat_end = \"{}\"\nin_emergency = \"{}\"\n\
         [[drive]]\njoint = \"J11\"\nid = 1\nspeed = 90\ntorque = 0.5\n\
         [[drive]]\njoint = \"J12\"\nid = 2\nspeed = 90\ntorque = 0.5\n",
        word(at_end),
        word(other)
    )
}

/// The program waves until it is ended from outside, or ends by itself.
fn program(event: Event) -> String {
    let last = match event {
        Event::End => "END",
        // A domain error: the fault of a step.
        Event::ProgramFault => "X = SQRT X\nEND",
        _ => "GOTO L1:\nEND",
    };
    format!(
        "3.1\nwave\nDEF_VAR X\nX = -1\nL1:\nMESSAGE go\nPTP_ANGLE F1 30 -30\nWAIT_INPOS F1\n\
         PTP_ANGLE F1 -30 30\nWAIT_INPOS F1\n{last}\n"
    )
}

/// A command under way, its terminal and its servos.
struct Run {
    child: Child,
    keys: Pty,
    bus: ServoBus,
}

impl Run {
    fn begin(cell: Cell, folder: &Folder) -> Self {
        let (model, voltage) = FAMILIES[cell.family];
        let text = description(model, voltage, cell.at_end);
        let bus = ServoBus::of(&text, 40.0);
        std::fs::write(folder.path("robot.toml"), text).expect("ours");
        std::fs::write(folder.path("wave.prg"), program(cell.event)).expect("ours");
        let keys = Pty::new();
        let mut arguments = vec!["run", "wave.prg", "--hardware", "robot.toml", "--port"];
        arguments.push(bus.port());
        if cell.phase != Phase::BeforeTorque {
            arguments.push("--yes");
        }
        let mut command = folder.command(&arguments);
        command.stdin(keys.input()).stdout(Stdio::piped());
        let said = std::fs::File::create(folder.path("said")).expect("ours");
        command.stderr(said);
        let child = command.spawn().expect("tip starts");
        Run { child, keys, bus }
    }

    fn signal(&self, signal: Signal) {
        // It may be gone already.
        let _ = kill_process(Pid::from_child(&self.child), signal);
    }

    /// Waits for the moment of a cell.
    fn reach(&mut self, cell: Cell, folder: &Folder) {
        let has_torque = |bus: &SimulatedBus| bus.servos().iter().all(Servo::has_torque);
        if cell.phase == Phase::BeforeTorque {
            // It asks for the key that starts.
            let asks = || folder.read("said").contains("RETURN");
            let begin = Instant::now();
            while !asks() {
                assert!(begin.elapsed() < Duration::from_secs(30), "no question");
                thread::sleep(Duration::from_millis(5));
            }
            return;
        }
        self.bus.await_that("torque", has_torque);
        if cell.phase == Phase::Approach {
            let first = self.bus.with(|bus| bus.servos()[0].angle());
            self.bus.await_that("motion", |bus| {
                (bus.servos()[0].angle() - first).abs() > 2.0
            });
            return;
        }
        let mut go = [0; 3];
        let out = self.child.stdout.as_mut().expect("piped");
        out.read_exact(&mut go).expect("the message");
        assert_eq!(go, *b"go\n");
        thread::sleep(Duration::from_millis(3 * PERIOD));
        if cell.phase == Phase::Leaving {
            self.signal(Signal::INT);
            if cell.at_end == Policy::Relax {
                self.bus
                    .await_that("leaving", |bus| bus.servos()[0].torque_limit() < 0.45);
            }
        }
    }

    fn happen(&mut self, event: Event) {
        match event {
            Event::Return => self.keys.press(b'\r'),
            Event::Escape => self.keys.press(0x1B),
            // The terminal makes a signal of it unless the command reads it as a key.
            Event::CtrlC if makes_signals(&self.keys) => self.signal(Signal::INT),
            Event::CtrlC => self.keys.press(0x03),
            Event::TwoSigterm => {
                self.signal(Signal::TERM);
                thread::sleep(Duration::from_millis(PERIOD));
                self.signal(Signal::TERM);
            }
            Event::Sighup => self.signal(Signal::HUP),
            Event::Sigquit => self.signal(Signal::QUIT),
            Event::Kill => self.signal(Signal::KILL),
            Event::UsbGone => self.bus.hang_up(),
            Event::End | Event::ProgramFault => {}
        }
    }
}

fn makes_signals(keys: &Pty) -> bool {
    let settings = tcgetattr(&keys.line).expect("a terminal");
    settings.local_modes.contains(LocalModes::ISIG)
}

/// Returns the state of the servos.
fn judge(bus: &SimulatedBus, at_end: Policy) -> (Left, String) {
    let servos = bus.servos();
    let mut details = String::new();
    for servo in servos {
        let (goal, here) = (servo.goal(), servo.position());
        let (on, limit) = (servo.has_torque(), servo.torque_limit());
        let watchdog = servo.register(98, 1).filter(|_| servo.mode().is_none());
        write!(
            details,
            "servo {}: torque {on}, limit {limit:.2}, goal {goal:.0}, at {here:.0}, {:.1} deg/s, mode {:?}, 98: {watchdog:?}; ",
            servo.id(),
            servo.velocity(),
            servo.mode()
        )
        .expect("a string");
    }
    let all = |is_so: &dyn Fn(&Servo) -> bool| servos.iter().all(is_so);
    let rests = all(&|servo| servo.velocity().abs() < 1.0);
    let policy = |policy: Policy| match policy == at_end {
        true => Left::AtEnd,
        false => Left::InEmergency,
    };
    let is_stiff = all(&|servo| servo.has_torque() && (servo.torque_limit() - 0.5).abs() < 0.02);
    let is_free = all(&|servo| !servo.has_torque());
    let left = match () {
        _ if !rests => Left::Other,
        _ if all(&|servo| servo.mode() == Some(11)) => Left::Damped,
        _ if is_stiff && all(&|servo| is_watched(servo) && servo.register(98, 1) == Some(0xFF)) => {
            Left::Watchdog
        }
        _ if is_stiff && all(&|servo| !is_watched(servo) || servo.register(98, 1) == Some(0)) => {
            policy(Policy::Hold)
        }
        _ if is_free => policy(Policy::Relax),
        _ => Left::Other,
    };
    (left, details)
}

/// Returns true of an X servo, whose register 98 is a watchdog.
fn is_watched(servo: &Servo) -> bool {
    servo.register(0, 2) == Some(1060)
}

fn execute(cell: Cell) -> Found {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let n = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Folder::new(&format!("endings-{n}"));
    let mut run = Run::begin(cell, &folder);
    run.reach(cell, &folder);
    run.happen(cell.event);
    let event = Instant::now();
    if (cell.event, cell.phase) == (Event::Return, Phase::BeforeTorque) {
        run.bus
            .await_that("torque", |bus| bus.servos()[0].has_torque());
        run.signal(Signal::KILL);
        let _ = run.child.wait();
        return Found {
            left: Left::Started,
            after: 0,
            details: String::new(),
        };
    }
    // It has time to do the wrong thing too.
    let status = loop {
        if let Some(status) = run.child.try_wait().expect("ours") {
            break Some(status);
        }
        if event.elapsed() > Duration::from_secs(12) {
            break None;
        }
        thread::sleep(Duration::from_millis(3));
    };
    let after = event.elapsed().as_millis();
    if status.is_none() {
        run.signal(Signal::KILL);
        let _ = run.child.wait();
    }
    // Time for watchdogs, and for servos that turn on.
    thread::sleep(Duration::from_millis(15 * PERIOD));
    let (mut left, servos) = run.bus.with(|bus| judge(bus, cell.at_end));
    if cell.phase == Phase::BeforeTorque && run.bus.stiff().is_empty() {
        left = Left::Untouched;
    }
    let is_alone = matches!(cell.event, Event::Kill | Event::UsbGone);
    if is_alone && !run.bus.stiff().is_empty() && left != Left::Watchdog && left != Left::Other {
        left = Left::Stiff;
    }
    if status.is_none() {
        left = Left::Other;
    }
    let said = folder.read("said");
    let last = said.lines().last().unwrap_or_default();
    let details = format!("{status:?}; {servos}{last}");
    Found {
        left,
        after,
        details,
    }
}

/// Executes all cells, many at a time: most of them wait.
fn run_all(cells: &[Cell]) -> Vec<Found> {
    let next = AtomicUsize::new(0);
    let found = Mutex::new(vec![None; cells.len()]);
    thread::scope(|scope| {
        for _ in 0..24 {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some(cell) = cells.get(place) else { return };
                    let end = execute(*cell);
                    found.lock().expect("no panic")[place] = Some(end);
                }
            });
        }
    });
    let found = found.into_inner().expect("no panic");
    found
        .into_iter()
        .map(|end| end.expect("executed"))
        .collect()
}

fn cells() -> Vec<Cell> {
    let mut cells = Vec::new();
    for event in EVENTS {
        for phase in PHASES {
            for at_end in [Policy::Hold, Policy::Relax] {
                for family in 0..FAMILIES.len() {
                    if is_possible(event, phase) {
                        cells.push(Cell {
                            event,
                            phase,
                            at_end,
                            family,
                        });
                    }
                }
            }
        }
    }
    cells
}

#[test]
fn every_ending_leaves_the_servos_as_the_file_says() {
    let cells = cells();
    let found = run_all(&cells);
    let mut wrong = String::new();
    for (cell, found) in cells.iter().zip(&found) {
        if found.left != expected(*cell) {
            writeln!(
                wrong,
                "{:?} {:?} at_end {:?} {}: {} instead of {}, after {} ms: {}",
                cell.event,
                cell.phase,
                cell.at_end,
                FAMILIES[cell.family].0,
                found.left,
                expected(*cell),
                found.after,
                found.details
            )
            .expect("a string");
        }
    }
    let count = wrong.lines().count();
    assert!(
        wrong.is_empty(),
        "{count} of {} cells:\n{wrong}",
        cells.len()
    );
}
