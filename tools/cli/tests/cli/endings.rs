//! Every way in which a run on servos can end, at every moment and for every family: the registers of the servos after the host is
//! gone. The table of endings in docs/drives.md and docs/faults.md is generated here.
//!
//! `at_end` and `in_emergency` are opposite in each run, so that the servos show which of them was obeyed.

use crate::faults::terminal::Pty;
use crate::servo_bus::ServoBus;
use crate::support::Folder;
use rustix::process::{Pid, Signal, kill_process};
use rustix::termios::{LocalModes, tcgetattr};
use std::fmt::Write;
use std::io::Read;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use std::{env, fs, thread};
use tip_drives::bus::{Bus, Port, Timing};
use tip_drives::drives::{self, Drives, Joint, Settings};
use tip_drives::guard::{Host, Request, Step, TorqueGuard};
use tip_drives::model::Model;
use tip_drives::serial::Serial;
use tip_drives::simulated::{Servo, SimulatedBus};
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::Range;

/// Something that ends a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Event {
    Return,
    Escape,
    CtrlC,
    TwoSigterm,
    Sighup,
    Sigquit,
    Panic,
    Kill,
    UsbGone,
    End,
    ProgramFault,
}

const EVENTS: [Event; 11] = [
    Event::Return,
    Event::Escape,
    Event::CtrlC,
    Event::TwoSigterm,
    Event::Sighup,
    Event::Sigquit,
    Event::Panic,
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

/// A model of each family.
const FAMILIES: [&str; 5] = ["AX-12", "XL430-W250", "STS3215", "LX-16A", "moteus-mj5208"];

/// The state in which the servos are left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

/// Returns the states in which the servos may be left, reasoned from docs/drives.md.
fn expected(cell: Cell) -> Vec<Left> {
    let model = FAMILIES[cell.family];
    let without_host = match model {
        "XL430-W250" => Left::Watchdog,
        "moteus-mj5208" => Left::Damped,
        _ => Left::Stiff,
    };
    let is_relaxing = cell.at_end == Policy::Relax && model != "LX-16A";
    match (cell.event, cell.phase) {
        (Event::Return, Phase::BeforeTorque) => vec![Left::Started],
        (_, Phase::BeforeTorque) => vec![Left::Untouched],
        // Nothing is sent any more. Where leaving takes no time, the host may have left already.
        (Event::Kill | Event::UsbGone, Phase::Leaving) if !is_relaxing => {
            vec![without_host, Left::AtEnd]
        }
        (Event::Kill | Event::UsbGone, _) => vec![without_host],
        (Event::Panic, _) => vec![Left::InEmergency],
        (Event::Return, Phase::Leaving) if !is_relaxing => vec![Left::AtEnd, Left::InEmergency],
        (Event::Return | Event::ProgramFault, _) => vec![Left::InEmergency],
        _ => vec![Left::AtEnd],
    }
}

/// Time after which a command counts as stuck.
const PATIENCE: Duration = Duration::from_secs(12);
/// ms
const PERIOD: u64 = 80;
/// deg/s; the approach of 40 deg takes two seconds.
const START: f64 = 20.0;

/// The speed of each joint, deg/s.
const SPEED: f64 = 90.0;

/// Returns the torque of each joint, as a part of the full torque. That of an LX cannot be limited.
fn torque(model: &str) -> f64 {
    if model == "LX-16A" { 1.0 } else { 0.5 }
}

fn other(policy: Policy) -> Policy {
    match policy {
        Policy::Hold => Policy::Relax,
        Policy::Relax => Policy::Hold,
    }
}

/// A robot of two joints on a bus where answers may take long, because tests share their machine.
fn description(model: &str, at_end: Policy) -> String {
    let word = |policy| match policy {
        Policy::Hold => "hold",
        Policy::Relax => "relax",
    };
    let (at_end, in_emergency) = (word(at_end), word(other(at_end)));
    let torque = torque(model);
    let drives: String = (1..=2)
        .map(|n| {
            format!("[[drive]]\njoint = \"J1{n}\"\nid = {n}\nspeed = {SPEED}\ntorque = {torque}\n")
        })
        .collect();
    format!(
        "name = \"ends\"
joint = [
    {{ axis = \"z\", link = [100, 0, 0], limits = [-90, 90] }},
    {{ axis = \"z\", link = [100, 0, 0], limits = [-90, 90] }},
]
leg = [{{ base = [0, 0, 0] }}]
[standards]
period = {PERIOD}
[bus]
servo = \"{model}\"
latency = 200
silence = 50
lag = [90, 60]
voltage = [6, 30]
start = {START}
at_end = \"{at_end}\"
in_emergency = \"{in_emergency}\"
{drives}"
    )
}

/// The program waves until it is ended from outside or asked to halt, or ends by itself.
fn program(event: Event) -> String {
    let last = match event {
        Event::End => "END",
        // A domain error: the fault of a step.
        Event::ProgramFault => "X = SQRT X\nEND",
        _ => "GOTO L1:\nOUT:\nEND",
    };
    let halt = match event {
        Event::End | Event::ProgramFault => "",
        _ => "IF HALT_REQUEST GOTO OUT:\n",
    };
    format!(
        "3.1\nwave\nDEF_VAR X\nX = -1\nL1:\nMESSAGE go\n{halt}PTP_ANGLE F1 30 -30\nWAIT_INPOS F1\n\
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
        let text = description(FAMILIES[cell.family], cell.at_end);
        let bus = ServoBus::of(&text, 40.0);
        fs::write(folder.path("robot.toml"), text).expect("ours");
        fs::write(folder.path("wave.prg"), program(cell.event)).expect("ours");
        let keys = Pty::new();
        let mut arguments = vec!["run", "wave.prg", "--hardware", "robot.toml", "--port"];
        arguments.push(bus.port());
        if cell.phase != Phase::BeforeTorque {
            arguments.push("--yes");
        }
        let mut command = folder.command(&arguments);
        command.stdin(keys.input()).stdout(Stdio::piped());
        let said = fs::File::create(folder.path("said")).expect("ours");
        command.stderr(said);
        let child = command.spawn().expect("tip starts");
        Run { child, keys, bus }
    }

    fn signal(&self, signal: Signal) {
        // It may be gone already.
        let _ = kill_process(Pid::from_child(&self.child), signal);
    }

    /// Waits for the moment of a cell; returns false if the run ended before it.
    fn reach(&mut self, cell: Cell, folder: &Folder) -> bool {
        let has_torque = |bus: &SimulatedBus| bus.servos().iter().all(Servo::has_torque);
        if cell.phase == Phase::BeforeTorque {
            // It asks for the key that starts.
            let asks = || folder.read("said").contains("RETURN");
            let begin = Instant::now();
            while !asks() {
                assert!(begin.elapsed() < Duration::from_secs(30), "no question");
                thread::sleep(Duration::from_millis(5));
            }
            return true;
        }
        self.bus.await_that("torque", has_torque);
        if cell.phase == Phase::Approach {
            let first = self.bus.with(|bus| bus.servos()[0].angle());
            self.bus.await_that("motion", |bus| {
                (bus.servos()[0].angle() - first).abs() > 2.0
            });
            return true;
        }
        let mut go = [0; 3];
        let out = self.child.stdout.as_mut().expect("piped");
        if out.read_exact(&mut go).is_err() {
            return false;
        }
        assert_eq!(go, *b"go\n");
        thread::sleep(Duration::from_millis(3 * PERIOD));
        if cell.phase == Phase::Leaving {
            self.signal(Signal::INT);
            if cell.at_end == Policy::Relax {
                self.bus
                    .await_that("leaving", |bus| bus.servos().iter().all(is_leaving));
            }
        }
        true
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
            Event::End | Event::ProgramFault | Event::Panic => {}
        }
    }
}

/// Returns the longest time from an event until the command is gone, ms: relaxing takes two seconds, and servos confirm their state
/// in three. A busy machine adds something.
fn limit(cell: Cell, left: Left) -> u128 {
    let policy = match left {
        Left::AtEnd => cell.at_end,
        Left::InEmergency => other(cell.at_end),
        _ => Policy::Hold,
    };
    let own = match policy {
        Policy::Hold => 3000,
        Policy::Relax => 5000,
    };
    // The time in which the program comes to its end belongs to it.
    let walking = match cell.event {
        Event::End | Event::ProgramFault => 4000,
        _ => 0,
    };
    own + walking + 1000
}

/// Returns true if a servo's torque falls, or is off.
fn is_leaving(servo: &Servo) -> bool {
    servo.torque_limit() < 0.45 || !servo.has_torque()
}

fn makes_signals(keys: &Pty) -> bool {
    let settings = tcgetattr(&keys.line).expect("a terminal");
    settings.local_modes.contains(LocalModes::ISIG)
}

/// Returns the state of the servos. A host that was killed has left nothing in order: what is stiff then is so by itself.
fn judge(bus: &SimulatedBus, at_end: Policy, is_alone: bool) -> (Left, String) {
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
    let policy = |policy: Policy| match policy == at_end {
        true => Left::AtEnd,
        false => Left::InEmergency,
    };
    let is_whole = |servo: &Servo| {
        let limit = servo.torque_limit();
        (limit - 0.5).abs() < 0.02 || limit == 1.0
    };
    let is_timed_out = |servo: &Servo| is_watched(servo) && servo.register(98, 1) == Some(0xFF);
    let left = match () {
        _ if !all(&|servo| servo.velocity().abs() < 1.0) => Left::Other,
        _ if all(&|servo| servo.mode() == Some(11)) => Left::Damped,
        _ if all(&|servo| !servo.has_torque()) => policy(Policy::Relax),
        _ if !all(&|servo| servo.has_torque()) => Left::Other,
        _ if all(&|servo| is_timed_out(servo)) => Left::Watchdog,
        _ if is_alone => Left::Stiff,
        _ if all(&|servo| is_whole(servo) && !is_timed_out(servo)) => policy(Policy::Hold),
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
    if cell.event == Event::Panic {
        return panicked(cell);
    }
    let folder = Folder::new(&format!("endings-{n}"));
    let mut run = Run::begin(cell, &folder);
    // On a machine that is too busy for a bus in real time, a run may stop for silent servos before its moment.
    for _ in 0..3 {
        if run.reach(cell, &folder) {
            break;
        }
        let _ = run.child.wait();
        run = Run::begin(cell, &folder);
    }
    run.happen(cell.event);
    let event = Instant::now();
    if cell.phase == Phase::BeforeTorque {
        match cell.event {
            Event::Return => {
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
            // It waits for a line.
            Event::Escape | Event::UsbGone => run.happen(Event::Return),
            _ => {}
        }
    }
    let status = loop {
        if let Some(status) = run.child.try_wait().expect("ours") {
            break Some(status);
        }
        if event.elapsed() > PATIENCE {
            break None;
        }
        thread::sleep(Duration::from_millis(3));
    };
    let after = event.elapsed().as_millis();
    if status.is_none() {
        run.signal(Signal::KILL);
        let _ = run.child.wait();
    }
    let (left, servos) = settled(&mut run.bus, cell);
    let said = folder.read("said");
    let last = said.lines().last().unwrap_or_default();
    Found {
        left: if status.is_none() { Left::Other } else { left },
        after,
        details: format!("{status:?}; {servos}{last}"),
    }
}

/// Returns the state of the servos when watchdogs have had their time, and servos that turn on would have turned.
fn settled(bus: &mut ServoBus, cell: Cell) -> (Left, String) {
    let is_alone = matches!(cell.event, Event::Kill | Event::UsbGone);
    let cycles = if is_alone { 15 } else { 4 };
    thread::sleep(Duration::from_millis(cycles * PERIOD));
    let stiff = bus.stiff();
    let (left, details) = bus.with(|bus| judge(bus, cell.at_end, is_alone));
    match cell.phase == Phase::BeforeTorque && stiff.is_empty() {
        true => (Left::Untouched, details),
        false => (left, details),
    }
}

/// A host that panics, once, when it is asked the `calls`-th time.
struct Panics {
    calls: u32,
}

impl Host<Serial> for Panics {
    fn wait(&mut self, port: &mut Serial, until: u64) {
        let left = until.saturating_sub(port.now());
        thread::sleep(Duration::from_micros(left));
    }

    fn request(&mut self) -> Option<Request> {
        self.calls = self.calls.saturating_sub(1);
        if self.calls == 1 {
            // It unwinds as a panic does, without the message.
            resume_unwind(Box::new("a panic"));
        }
        None
    }
}

/// The program that embeds the drives panics: through [`TorqueGuard`], since `tip` itself does not.
fn panicked(cell: Cell) -> Found {
    let model = Model::named(FAMILIES[cell.family]).expect("a model");
    let mut bus = ServoBus::of(&description(model.name, cell.at_end), 40.0);
    let (port, begin) = (bus.port().to_owned(), Instant::now());
    let host = thread::spawn(move || host(model, &port, cell));
    assert!(host.join().is_err(), "it panics");
    let after = begin.elapsed().as_millis();
    let (left, details) = settled(&mut bus, cell);
    Found {
        left,
        after,
        details,
    }
}

fn host(model: &'static Model, port: &str, cell: Cell) {
    let joint = |id| Joint {
        id,
        model,
        sign: 1.0,
        offset: 0.0,
        gear: 1.0,
        limits: Range::new(-90.0, 90.0),
        speed: SPEED,
        torque: torque(model.name),
    };
    let policy = |policy| match policy {
        Policy::Hold => drives::Policy::Hold,
        Policy::Relax => drives::Policy::Relax,
    };
    let settings = Settings {
        silence: 50,
        voltage: Range::new(6.0, 30.0),
        lag: (90.0, 60.0),
        at_end: policy(cell.at_end),
        in_emergency: policy(other(cell.at_end)),
        ..Settings::default()
    };
    let timing = Timing {
        baud: 1_000_000,
        return_delay: 0,
        latency: 200_000,
    };
    let serial = Serial::open(Path::new(port), timing.baud).expect("a port");
    let drives = Drives::new(Bus::new(serial, timing), &[joint(1), joint(2)], settings);
    let idle = Panics { calls: 0 };
    let mut robot = TorqueGuard::new(drives.expect("two"), idle, PERIOD as f64);
    robot.connect().expect("both are there");
    if cell.phase == Phase::BeforeTorque {
        resume_unwind(Box::new("a panic"));
    }
    if cell.phase == Phase::Approach {
        robot.host_mut().calls = 15;
    }
    let arrived = robot.approach(&[30.0, -30.0], 4.0 * START);
    assert_eq!(arrived.expect("well"), Step::Arrived);
    for _ in 0..5 {
        robot.read_cycle().expect("well");
        let commands = [JointCommand::at(0.0); 2];
        robot.write_cycle(&commands, PERIOD as f64).expect("well");
        robot.wait();
    }
    if cell.phase == Phase::Walking {
        resume_unwind(Box::new("a panic"));
    }
    // While it leaves.
    robot.host_mut().calls = 2;
    robot.leave();
}

/// Returns true if the servos were left as expected, in time.
fn is_right(cell: Cell, found: &Found) -> bool {
    expected(cell).contains(&found.left) && found.after <= limit(cell, found.left)
}

/// Returns true if a host that got no processor time explains an ending: it was late, or the servos' own watchdogs ended the run.
fn may_be_starved(cell: Cell, found: &Found) -> bool {
    let is_late = found.after > limit(cell, found.left);
    is_late || matches!(found.left, Left::Watchdog | Left::Damped)
}

/// Executes all cells, many at a time: most of them wait. One whose host was starved on a busy machine is executed again, without the
/// others, and counts then. Any other wrong state counts the first time.
fn run_all(cells: &[Cell]) -> Vec<Found> {
    let next = AtomicUsize::new(0);
    let found = Mutex::new(vec![None; cells.len()]);
    thread::scope(|scope| {
        for _ in 0..16 {
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
    let ends = cells.iter().zip(found).map(|(cell, end)| {
        let mut end = end.expect("executed");
        for _ in 0..2 {
            if !is_right(*cell, &end) && may_be_starved(*cell, &end) {
                end = execute(*cell);
            }
        }
        end
    });
    ends.collect()
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

/// Returns the path of a page of the documentation.
pub(crate) fn page(name: &str) -> PathBuf {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    docs.join(name)
}

/// Compares the part of a page that is between comments of this name, or writes it there.
pub(crate) fn replace_part(path: &Path, name: &str, part: &str) {
    let text = fs::read_to_string(path).expect("a page");
    let page = path.display();
    let [begin, end] = ["begin", "end"].map(|edge| format!("<!-- {name}: {edge} -->\n"));
    let (before, rest) = text.split_once(&begin).expect("its begin");
    let (old, after) = rest.split_once(&end).expect("its end");
    if env::var_os("TIP_BLESS").is_some() {
        let new = format!("{before}{begin}{part}{end}{after}");
        fs::write(path, new).expect("the docs can be written");
        return;
    }
    assert_eq!(old, part, "{page} differs; TIP_BLESS=1 rewrites it");
}

/// Returns the words for what may be found in the cells of an event at a moment.
fn words(event: Event, phase: Phase) -> &'static str {
    if !is_possible(event, phase) {
        return "–";
    }
    let mut all: Vec<Left> = Vec::new();
    for family in 0..FAMILIES.len() {
        for at_end in [Policy::Hold, Policy::Relax] {
            all.extend(expected(Cell {
                event,
                phase,
                at_end,
                family,
            }));
        }
    }
    let has = |left: Left| all.contains(&left);
    match () {
        _ if has(Left::Untouched) => "no torque",
        _ if has(Left::Started) => "starts the robot",
        _ if has(Left::Damped) && has(Left::AtEnd) => "alone; `at_end` if that was sent before",
        _ if has(Left::Damped) => "alone",
        _ if has(Left::InEmergency) && has(Left::AtEnd) => {
            "`in_emergency`; `at_end` if that was confirmed before"
        }
        _ if has(Left::InEmergency) => "`in_emergency`",
        _ => "`at_end`",
    }
}

fn table() -> String {
    let mut table = String::from(
        "| event | before the torque is on | on the way to the first posture | walking | leaving in order |\n\
         |---|---|---|---|---|\n",
    );
    for event in EVENTS {
        let name = match event {
            Event::Return => "RETURN",
            Event::Escape => {
                "ESC; while the program runs, it is the program that tests HALT_REQUEST and ends"
            }
            Event::CtrlC => "Ctrl-C, SIGINT",
            Event::TwoSigterm => "SIGTERM, and another one",
            Event::Sighup => "SIGHUP: the terminal is closed",
            Event::Sigquit => "SIGQUIT",
            Event::Panic => "a panic of a program that embeds the drives",
            Event::Kill => "kill -9, power failure of the host",
            Event::UsbGone => "the adapter is pulled out",
            Event::End => "END",
            Event::ProgramFault => "a fault of the program",
        };
        write!(table, "| {name} |").expect("a string");
        for phase in PHASES {
            write!(table, " {} |", words(event, phase)).expect("a string");
        }
        table.push('\n');
    }
    table += "\n*Alone*, servos get no commands any more:\n\n| servo | alone |\n|---|---|\n";
    for (family, model) in FAMILIES.iter().enumerate() {
        let cell = Cell {
            event: Event::Kill,
            phase: Phase::Walking,
            at_end: Policy::Hold,
            family,
        };
        let alone = match expected(cell)[0] {
            Left::Watchdog => {
                "stops within its time-out and keeps its torque; goals are refused until the next start"
            }
            Left::Damped => "brakes within its time-out and holds no angle, until the next start",
            _ => "goes to its last goal, and holds it with the torque limit that it had",
        };
        writeln!(table, "| {model} | {alone} |").expect("a string");
    }
    table
}

#[test]
fn every_ending_leaves_the_servos_as_the_file_says() {
    let cells = cells();
    let found = run_all(&cells);
    let mut wrong = String::new();
    for (cell, found) in cells.iter().zip(&found) {
        if !is_right(*cell, found) {
            let expected = expected(*cell);
            let Cell {
                event,
                phase,
                at_end,
                family,
            } = cell;
            let Found {
                left,
                after,
                details,
            } = found;
            let model = FAMILIES[*family];
            writeln!(
                wrong,
                "{event:?} {phase:?} at_end {at_end:?} {model}: {left:?} instead of {expected:?} after {after} ms: {details}",
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
    let table = table();
    for name in ["drives.md", "faults.md"] {
        replace_part(&page(name), "endings", &table);
    }
}
