//! A robot on servos ends in the state that its file names, whatever ends the command: the torque of its servos is read afterwards.

use crate::faults::terminal::Pty;
use crate::servo_bus::ServoBus;
use crate::support::{Folder, Outcome, process, start, through};
use rustix::process::{Pid, Signal, kill_process};
use std::io::Read;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Stdio};
use std::thread::{scope, sleep};
use std::time::{Duration, Instant};
use tip_drives::simulated::SimulatedBus;

const RETURN: u8 = 0x0D;
const ESCAPE: u8 = 0x1B;
const CONTROL_C: u8 = 0x03;

/// The servos of the robot.
const ALL: [u8; 3] = [1, 2, 3];

/// A leg of three joints on a bus where answers may take long, because tests share their machine.
pub(crate) fn leg(at_end: &str, in_emergency: &str, more: &str) -> String {
    let drives: String = (1..=3)
        .map(|n| format!("[[drive]]\njoint = \"J1{n}\"\nid = {n}\n"))
        .collect();
    format!(
        "name = \"leg\"
joint = [
    {{ axis = \"z\", link = [50, 0, 0], limits = [-90, 90] }},
    {{ axis = \"-y\", link = [100, 0, 0], limits = [-90, 90] }},
    {{ axis = \"y\", link = [120, 0, 0], limits = [-90, 90] }},
]
leg = [{{ base = [80, 0, 0] }}]
[bus]
servo = \"STS3215\"
latency = 400
silence = 200
lag = [90, 60]
at_end = \"{at_end}\"
in_emergency = \"{in_emergency}\"
{more}
{drives}"
    )
}

/// Two legs of one turning link of 180 mm, 200 mm apart, with initial angles of J12 and J22, deg. Their links have radii of 9 mm, and
/// cross where each has turned by more than 30.4 deg towards the other.
pub(crate) fn two_legs([one, other]: [f64; 2], keys: &str) -> String {
    let drives: String = ["J11", "J12", "J21", "J22"]
        .iter()
        .zip(1..)
        .map(|(joint, id)| format!("[[drive]]\njoint = \"{joint}\"\nid = {id}\n"))
        .collect();
    format!(
        "name = \"two\"
joint = [
    {{ axis = \"z\", link = [20, 0, 0], limits = [-90, 90] }},
    {{ axis = \"z\", link = [180, 0, 0], limits = [-90, 90]{keys} }},
]
leg = [{{ base = [0, 100, 0], initial = [0, {one}] }}, {{ base = [0, -100, 0], initial = [0, {other}] }}]
[bus]
servo = \"STS3215\"
latency = 400
silence = 200
lag = [90, 60]
at_end = \"relax\"
start = 90
{drives}"
    )
}

/// It says that it runs, and then does nothing.
pub(crate) const WAITS: &str = "MESSAGE go\nL1:\nSLEEP 100\nGOTO L1:\nEND";

/// A command on a robot, with a terminal before it.
pub(crate) struct Session {
    folder: Folder,
    pub(crate) bus: ServoBus,
    pty: Pty,
    terminal: String,
}

impl Session {
    /// A robot whose joints are this far from the first posture, deg.
    pub(crate) fn new(name: &str, robot: &str, beside: f64, program: &str) -> Self {
        let folder = Folder::new(&format!("torque-{name}"));
        let pty = Pty::new();
        Session {
            folder: folder.file("robot.toml", robot).program("p.prg", program),
            bus: ServoBus::of(robot, beside),
            terminal: pty.behaviour(),
            pty,
        }
    }

    fn start(&self, arguments: &[&str]) -> Child {
        let port = ["--port", self.bus.port()];
        let mut command = self.folder.command(&[arguments, &port].concat());
        start(&mut command, self.pty.input())
    }

    pub(crate) fn run(&self) -> Child {
        self.start(&["run", "p.prg", "--hardware", "robot.toml", "--yes"])
    }

    /// Waits until all servos are stiff and have turned from where they were.
    fn await_motion(&mut self) {
        let from = self.bus.with(positions);
        self.bus.await_that("the robot moves", |bus| {
            let moved = bus.servos().iter().zip(&from);
            let mut moved = moved.map(|(servo, from)| (servo.position() - from).abs() > 10.0);
            bus.servos().iter().all(|servo| servo.has_torque()) && moved.all(|it| it)
        });
    }

    /// The command has ended, and the terminal is as it was.
    pub(crate) fn ended(&self, child: Child) -> Outcome {
        let outcome = Outcome::of(child.wait_with_output().expect("it ends"));
        assert_eq!(self.pty.behaviour(), self.terminal, "{outcome:#?}");
        outcome
    }
}

fn positions(bus: &mut SimulatedBus) -> Vec<f64> {
    bus.servos().iter().map(|servo| servo.position()).collect()
}

/// Reads the message of the program.
pub(crate) fn await_go(child: &mut Child) {
    let mut first = [0; 3];
    let out = child.stdout.as_mut().expect("piped");
    out.read_exact(&mut first).expect("the message");
    assert_eq!(first, *b"go\n");
}

/// Reads standard error until the question that starts a run.
fn await_question(child: &mut Child) {
    let mut said = Vec::new();
    let mut byte = [0];
    while !said.ends_with(b"RETURN starts") {
        let err = child.stderr.as_mut().expect("piped");
        err.read_exact(&mut byte).expect("the question");
        said.push(byte[0]);
    }
}

pub(crate) fn signal(child: &Child, signal: Signal) {
    kill_process(Pid::from_child(child), signal).expect("nobody has waited for it yet");
}

/// The servos that a policy leaves stiff.
fn stiff(policy: &str) -> &'static [u8] {
    match policy {
        "hold" => &ALL,
        _ => &[],
    }
}

#[test]
fn keys_on_the_way_to_the_first_posture_end_it_as_the_file_says() {
    let way = |key: u8, at_end: &'static str, in_emergency: &'static str| {
        let robot = leg(at_end, in_emergency, "start = 2");
        let name = format!("approach-{key}-{at_end}");
        // It takes 20 s.
        let mut session = Session::new(&name, &robot, 40.0, WAITS);
        let child = session.run();
        session.await_motion();
        let (policy, status) = match key {
            RETURN => (in_emergency, 3),
            _ => (at_end, 130),
        };
        let (from, pressed) = (session.bus.with(positions), Instant::now());
        session.pty.press(key);
        let outcome = session.ended(child).expect(status);
        let time = pressed.elapsed();
        assert_eq!(session.bus.stiff(), stiff(policy), "{name}: {outcome:#?}");
        assert_eq!(outcome.out, "", "the program does not run");
        assert!(time < Duration::from_secs(8), "{name}: {time:?}");
        for (from, to) in from.into_iter().zip(session.bus.with(positions)) {
            // 5 deg, in which it stops.
            assert!((to - from).abs() < 60.0, "{name}: {from} to {to}");
        }
    };
    scope(|scope| {
        for (at_end, in_emergency) in [("relax", "hold"), ("hold", "relax")] {
            for key in [RETURN, ESCAPE, CONTROL_C] {
                scope.spawn(move || way(key, at_end, in_emergency));
            }
        }
    });
}

#[test]
fn signals_do_not_cut_the_leaving_short() {
    let signals: [(&[Signal], i32); 10] = [
        (&[Signal::TSTP], 128 + 20),
        (&[Signal::TTIN; 2], 128 + 21),
        (&[Signal::TTOU, Signal::TSTP], 128 + 22),
        (&[Signal::TERM; 2], 143),
        (&[Signal::USR1], 128 + 10),
        (&[Signal::ALARM, Signal::USR2], 128 + 14),
        (&[Signal::XCPU], 128 + 24),
        (&[Signal::INT; 5], 130),
        (&[Signal::QUIT; 3], 131),
        (&[Signal::HUP, Signal::TERM, Signal::QUIT], 129),
    ];
    let one = |number: usize, signals: &[Signal], status: i32| {
        let robot = leg("relax", "hold", "");
        let mut session = Session::new(&format!("signals-{number}"), &robot, 0.5, WAITS);
        let mut child = session.run();
        await_go(&mut child);
        assert_eq!(session.bus.stiff(), ALL);
        for next in signals {
            signal(&child, *next);
            sleep(Duration::from_millis(150));
        }
        let outcome = session.ended(child).expect(status);
        assert_eq!(session.bus.stiff(), stiff("relax"), "{outcome:#?}");
    };
    scope(|scope| {
        for (number, (signals, status)) in signals.into_iter().enumerate() {
            scope.spawn(move || one(number, signals, status));
        }
    });
}

/// Nobody can refuse SIGSTOP. The watchdogs, ten cycles of 80 ms, stop the servos; they answer again and would follow nothing.
#[test]
fn a_host_that_was_suspended_stops_servos_that_their_watchdogs_stopped() {
    let one = |number: usize, at_end, in_emergency| {
        let robot = leg(at_end, in_emergency, "[standards]\nperiod = 80");
        let robot = robot.replace("STS3215", "XL430-W250");
        let mut session = Session::new(&format!("suspended-{number}"), &robot, 0.5, WAITS);
        let mut child = session.run();
        await_go(&mut child);
        signal(&child, Signal::STOP);
        session.bus.await_that("the watchdogs expire", |bus| {
            let mut watchdogs = bus.servos().iter().map(|servo| servo.register(98, 1));
            watchdogs.all(|watchdog| watchdog == Some(0xFF))
        });
        signal(&child, Signal::CONT);
        let outcome = session.ended(child).expect(3);
        assert_eq!(session.bus.stiff(), stiff(in_emergency), "{outcome:#?}");
        let said = "J11 (servo 1) was stopped by its watchdog, because it heard nothing for more than 800 ms";
        assert!(outcome.err.contains(said), "{}", outcome.err);
        let watchdogs = session.bus.with(|bus| {
            let servos = bus.servos().iter();
            servos
                .map(|servo| servo.register(98, 1))
                .collect::<Vec<_>>()
        });
        assert_eq!(watchdogs, [Some(0); 3], "none is left to refuse goals");
    };
    scope(|scope| {
        scope.spawn(|| one(0, "relax", "hold"));
        scope.spawn(|| one(1, "hold", "relax"));
    });
}

/// A shell starts jobs in the background so. What is meant for the robot counts all the same.
#[test]
fn a_command_that_inherits_ignored_signals_obeys_them_on_a_robot() {
    for (sent, status) in [(Signal::INT, 130), (Signal::QUIT, 131)] {
        let robot = leg("relax", "hold", "");
        let name = format!("ignored-{status}");
        let mut session = Session::new(&name, &robot, 0.5, WAITS);
        let run = [
            "run",
            "p.prg",
            "--hardware",
            "robot.toml",
            "--yes",
            "--port",
        ];
        let tip = session
            .folder
            .command(&[&run[..], &[session.bus.port()]].concat());
        let shell = ["sh", "-c", "trap '' INT QUIT; exec \"$@\"", "sh"];
        let mut child = start(&mut through(&shell, &tip), session.pty.input());
        await_go(&mut child);
        signal(&child, sent);
        let outcome = session.ended(child).expect(status);
        assert_eq!(session.bus.stiff(), stiff("relax"), "{outcome:#?}");
    }
}

#[test]
fn return_stops_a_robot_that_relaxes() {
    let robot = leg("relax", "hold", "");
    let mut session = Session::new("relaxing", &robot, 0.5, WAITS);
    let mut child = session.run();
    await_go(&mut child);
    signal(&child, Signal::TERM);
    session.bus.await_that("it relaxes", |bus| {
        bus.servos().iter().all(|servo| servo.torque_limit() < 0.7)
    });
    session.pty.press(RETURN);
    let outcome = session.ended(child).expect(3);
    assert_eq!(session.bus.stiff(), ALL, "{outcome:#?}");
    let limits = session.bus.with(|bus| {
        let limits = bus.servos().iter().map(|servo| servo.torque_limit());
        limits.collect::<Vec<_>>()
    });
    assert_eq!(limits, [1.0; 3], "the torque of the file");
}

/// Nobody reads the output of a command, so that it stands still with the torque on, and reads no keys. Nobody needs to do anything.
#[test]
fn a_robot_without_control_cycles_is_left_as_in_an_emergency() {
    let talks =
        "L1:\nMESSAGE and so on and so on and so on and so on and so on and so on\nGOTO L1:\nEND";
    let one = |number: usize, (at_end, in_emergency), trace: bool, all: bool| {
        let name = format!("stalled-{number}");
        let mut session = Session::new(&name, &leg(at_end, in_emergency, ""), 0.5, talks);
        let port = session.bus.port().to_owned();
        let mut run = vec!["run", "p.prg", "--hardware", "robot.toml", "--yes"];
        run.extend(["--port", &port]);
        if trace {
            run.extend(["--realtime", "--trace", "-"]);
        }
        // A terminal that nobody reads is full earlier than a pipe.
        let deaf = Pty::new();
        let mut command = session.folder.command(&run);
        command.stdin(session.pty.input()).stdout(deaf.input());
        // `2>&1` before a reader.
        command.stderr(if all { deaf.input() } else { Stdio::piped() });
        let child = command.spawn().expect("tip starts");
        let outcome = session.ended(child).expect(3);
        assert_eq!(session.bus.stiff(), stiff(in_emergency), "{}", outcome.err);
        let said = "emergency stop: no control cycle for 3 s";
        assert_eq!(outcome.err.contains(said), !all, "{}", outcome.err);
    };
    let policies = [("relax", "hold"), ("hold", "relax")];
    scope(|scope| {
        scope.spawn(|| one(0, policies[0], false, false));
        scope.spawn(|| one(1, policies[1], true, false));
        scope.spawn(|| one(2, policies[1], true, true));
    });
}

/// A sampling time of more than 3 s is no standstill.
#[test]
fn a_robot_with_long_control_cycles_goes_on() {
    let periods = "name = \"leg\"\nperiods = [1, 5000]";
    let robot = leg("relax", "hold", "").replace("name = \"leg\"", periods);
    let slow = "SET_SAMPLING_TIME 3500\nMESSAGE go\nEND";
    let mut session = Session::new("slow", &robot, 0.5, slow);
    let child = session.run();
    let outcome = session.ended(child).expect(0);
    assert_eq!(outcome.out, "go\n");
    assert_eq!(session.bus.stiff(), stiff("relax"), "{}", outcome.err);
}

/// A pipe for the trace may never get a reader. The robot waits without torque, and a signal ends the command.
#[test]
fn a_trace_without_a_reader_comes_before_the_torque() {
    let mut session = Session::new("fifo", &leg("relax", "hold", ""), 0.5, WAITS);
    let made = std::process::Command::new("mkfifo")
        .arg(session.folder.path("trace"))
        .status();
    assert!(made.expect("mkfifo").success());
    let run = ["run", "p.prg", "--hardware", "robot.toml", "--yes"];
    let child = session.start(&[&run[..], &["--trace", "trace"]].concat());
    let mut heard = 0;
    while std::mem::replace(&mut heard, session.bus.with(|bus| bus.understood())) != heard
        || heard == 0
    {
        sleep(Duration::from_millis(500));
    }
    assert_eq!(session.bus.stiff(), stiff("relax"));
    signal(&child, Signal::TERM);
    signal(&child, Signal::TERM);
    session.ended(child).expect(143);
    assert_eq!(session.bus.stiff(), stiff("relax"));
}

/// The trace may not become longer than a block: the run ends as on a full disk, and the robot is left as at its end.
#[test]
fn a_trace_that_becomes_too_long_ends_a_run_in_order() {
    let mut session = Session::new("limited", &leg("relax", "hold", ""), 0.5, WAITS);
    let script = "ulimit -f 1; exec \"$0\" run p.prg --hardware robot.toml --yes --trace t --trace-motion --port \"$1\"";
    let mut command = process("sh");
    command.args(["-c", script, env!("CARGO_BIN_EXE_tip"), session.bus.port()]);
    command.current_dir(session.folder.path(""));
    let child = start(&mut command, session.pty.input());
    session.bus.await_that("it holds", |bus| {
        bus.servos().iter().all(|servo| servo.has_torque())
    });
    let outcome = session.ended(child).expect(1);
    assert!(outcome.err.contains("cannot write t: "), "{outcome:#?}");
    assert_eq!(session.bus.stiff(), stiff("relax"), "{}", outcome.err);
    assert_eq!(session.folder.names(), ["p.prg", "robot.toml"]);
}

/// Nobody reads the messages: the command is stuck in its output, with the torque on.
#[test]
fn a_command_that_is_stuck_leaves_the_robot_before_it_ends() {
    let talks =
        "L1:\nMESSAGE and so on and so on and so on and so on and so on and so on\nGOTO L1:\nEND";
    let mut session = Session::new("stuck", &leg("relax", "hold", ""), 0.5, talks);
    let port = session.bus.port().to_owned();
    let run = [
        "run",
        "p.prg",
        "--hardware",
        "robot.toml",
        "--yes",
        "--port",
        &port,
    ];
    // A terminal that nobody reads is full earlier than a pipe.
    let deaf = Pty::new();
    let mut command = session.folder.command(&run);
    command.stdin(session.pty.input()).stdout(deaf.input());
    let child = command.stderr(Stdio::piped()).spawn().expect("tip starts");
    session.bus.await_that("it holds", |bus| {
        bus.servos().iter().all(|servo| servo.has_torque())
    });
    let mut heard = 0;
    while std::mem::replace(&mut heard, session.bus.with(|bus| bus.understood())) != heard {
        sleep(Duration::from_secs(1));
    }
    signal(&child, Signal::TERM);
    let outcome = session.ended(child).expect(143);
    assert_eq!(session.bus.stiff(), stiff("relax"), "{}", outcome.err);
}

#[test]
fn a_servo_that_does_not_confirm_is_named() {
    let robot = leg("relax", "relax", "").replace("silence = 200", "silence = 3");
    let robot = robot.replace("latency = 400", "latency = 30");
    let mut session = Session::new("unplugged", &robot, 0.5, WAITS);
    let mut child = session.run();
    await_go(&mut child);
    session.bus.with(|bus| bus.unplug(2));
    let outcome = session.ended(child).expect(3);
    assert_eq!(session.bus.stiff(), [2], "{outcome:#?}");
    let said = "perhaps still stiff, because they did not confirm that they relaxed: J12 (servo 2)";
    assert!(outcome.err.contains(said), "{}", outcome.err);
}

#[test]
fn the_port_that_is_gone_leaves_stiff_servos_and_says_so() {
    let mut session = Session::new("usb", &leg("relax", "relax", ""), 0.5, WAITS);
    let mut child = session.run();
    await_go(&mut child);
    session.bus.hang_up();
    let outcome = session.ended(child).expect(3);
    assert_eq!(session.bus.stiff(), ALL);
    assert!(outcome.err.contains("the port is gone"), "{}", outcome.err);
    let said = "did not confirm that they relaxed: J11 (servo 1), J12 (servo 2), J13 (servo 3)";
    assert!(outcome.err.contains(said), "{}", outcome.err);
}

#[test]
fn jog_leaves_the_robot_as_the_file_says() {
    let jog = |name: &str, at_end: &str, in_emergency: &str, act: &dyn Fn(&mut Session), status| {
        let robot = leg(at_end, in_emergency, "overload = [0.9, 0.2]");
        let mut session = Session::new(&format!("jog-{name}"), &robot, 0.5, WAITS);
        let child = session.start(&["drives", "jog", "robot.toml", "J12"]);
        session.bus.await_that("it holds", |bus| {
            bus.servos().iter().all(|servo| servo.has_torque())
        });
        act(&mut session);
        let outcome = session.ended(child).expect(status);
        let policy = if status == 3 { in_emergency } else { at_end };
        assert_eq!(session.bus.stiff(), stiff(policy), "{name}: {outcome:#?}");
        outcome.err
    };
    let turned = |session: &mut Session| {
        let from = session.bus.with(positions)[1];
        // An arrow is not ESC, which would end it.
        session.pty.send(b"\x1b[A");
        for _ in 0..9 {
            session.pty.press(b'+');
        }
        session.bus.await_that("it turns", |bus| {
            (bus.servos()[1].position() - from).abs() > 50.0
        });
        session.pty.press(b'q');
    };
    let obstacle = |session: &mut Session| {
        session.bus.with(|bus| bus.block(2));
        session.pty.press(b'+');
    };
    jog("turned", "relax", "hold", &turned, 0);
    jog("escape", "hold", "relax", &|it| it.pty.press(ESCAPE), 0);
    jog("return", "hold", "relax", &|it| it.pty.press(RETURN), 3);
    let said = jog("obstacle", "hold", "relax", &obstacle, 3);
    assert!(
        said.contains("J12 (servo 2) needs 1.00 of its torque"),
        "{said}"
    );
}

/// A key that would turn a link into another one is refused, and the robot holds.
#[test]
fn jog_turns_no_link_into_another() {
    let mut session = Session::new("jog-collides", &two_legs([-28.0, 28.0], ""), 0.5, WAITS);
    let child = session.start(&["drives", "jog", "robot.toml", "J12"]);
    session.bus.await_that("it holds", |bus| {
        bus.servos().iter().all(|servo| servo.has_torque())
    });
    for _ in 0..12 {
        session.pty.press(b'-');
    }
    session.pty.press(b'q');
    let outcome = session.ended(child).expect(0);
    let said = "link22 and link12 would overlap by ";
    assert!(outcome.err.contains(said), "{outcome:#?}");
    // -28 deg, turned by 4 deg at most: 2048 counts are 0 deg, and 4096 a turn.
    let turned = (session.bus.with(positions)[1] - 2048.0) * 360.0 / 4096.0;
    assert!((-33.0..-27.0).contains(&turned), "{turned}: {outcome:#?}");
}

/// Links that are thicker than the robot's pose allows are compared with nothing, and this is said before the torque.
#[test]
fn pairs_that_overlap_at_first_are_named_before_the_torque() {
    let ends = "MESSAGE go\nEND";
    // 200 mm between both links, and 98 or 101 mm of each radius.
    for (keys, line) in [
        (", radius = 98", None),
        (", radius = 101", Some("link22/link12 (2.0 mm)")),
    ] {
        let robot = two_legs([0.0, 0.0], keys);
        let session = Session::new("not-compared", &robot, 0.5, ends);
        let outcome = session.ended(session.run()).expect(0);
        let warned = outcome.err.find("warning: not compared: ");
        assert_eq!(warned.is_some(), line.is_some(), "{outcome:#?}");
        let checked = session.folder.tip(&["robot", "check", "robot.toml"]);
        let checked = checked.expect(0).out;
        assert_eq!(checked.contains("not compared: "), line.is_some());
        if let (Some(line), Some(warned)) = (line, warned) {
            assert!(checked.contains(line), "{checked}");
            assert!(outcome.err.contains(line), "{outcome:#?}");
            let torque = outcome
                .err
                .find("to the initial posture")
                .unwrap_or(usize::MAX);
            assert!(warned < torque, "{outcome:#?}");
        }
    }
}

/// `q` and ESC are its own ends; what ends every command has the status that it has everywhere.
#[test]
fn jog_ends_with_the_status_of_the_signal() {
    for (sent, status) in [(Signal::TERM, 143), (Signal::HUP, 129), (Signal::INT, 130)] {
        let robot = leg("relax", "hold", "");
        let mut session = Session::new(&format!("jog-signal-{status}"), &robot, 0.5, WAITS);
        let child = session.start(&["drives", "jog", "robot.toml", "J12"]);
        session.bus.await_that("it holds", |bus| {
            bus.servos().iter().all(|servo| servo.has_torque())
        });
        signal(&child, sent);
        let outcome = session.ended(child).expect(status);
        assert_eq!(session.bus.stiff(), stiff("relax"), "{outcome:#?}");
    }
}

/// Ctrl-Z is a key here, but SIGSTOP and `bg` of the shell bring a robot with torque into the background. Its keys belong to others
/// then, and changing the terminal would block it: a signal still ends it in order.
#[test]
fn a_robot_in_the_background_is_left_in_order() {
    let mut session = Session::new("background", &leg("relax", "hold", ""), 0.5, WAITS);
    let run = ["run", "p.prg", "--hardware", "robot.toml", "--yes"];
    let port = ["--port", session.bus.port()];
    let tip = session.folder.command(&[&run[..], &port].concat());
    let shell = "set -m; \"$@\"; echo stopped; bg; wait %1; echo over $?";
    let wrapper = ["setsid", "--ctty", "--wait", "sh", "-c", shell, "sh"];
    let mut child = start(&mut through(&wrapper, &tip), session.pty.input());
    await_go(&mut child);
    let port = session.bus.port();
    let processes = std::fs::read_dir("/proc").expect("Linux").flatten();
    let is_it = |process: &std::fs::DirEntry| {
        let words = std::fs::read_to_string(process.path().join("cmdline"));
        words.is_ok_and(|words| {
            words.ends_with(&format!("--port\0{port}\0")) && words.starts_with('/')
        })
    };
    let number = processes
        .filter(is_it)
        .find_map(|process| process.file_name().to_str()?.parse().ok());
    let it = Pid::from_raw(number.expect("it runs")).expect("a process");
    kill_process(it, Signal::STOP).expect("it runs");
    sleep(Duration::from_millis(700));
    assert_eq!(session.bus.stiff(), ALL, "it goes on");
    kill_process(it, Signal::TERM).expect("it runs");
    let outcome = Outcome::of(child.wait_with_output().expect("it ends"));
    assert!(outcome.out.ends_with("over 143\n"), "{outcome:#?}");
    assert_eq!(session.bus.stiff(), stiff("relax"), "{outcome:#?}");
}

/// Who waits at the question may suspend the run, and turn a joint meanwhile. 20 deg are 227 counts.
#[test]
fn a_joint_that_was_turned_before_the_key_is_held_where_it_is() {
    let robot = leg("hold", "hold", "start = 2");
    let mut session = Session::new("turned", &robot, 0.5, WAITS);
    let mut child = session.start(&["run", "p.prg", "--hardware", "robot.toml"]);
    await_question(&mut child);
    signal(&child, Signal::STOP);
    session.bus.with(|bus| bus.turn(2, 20.0));
    signal(&child, Signal::CONT);
    let turned = session.bus.with(positions)[1];
    session.pty.press(RETURN);
    session.bus.await_that("it holds", |bus| {
        bus.servos().iter().all(|servo| servo.has_torque())
    });
    let (goal, now) = session.bus.with(|bus| {
        let servo = &bus.servos()[1];
        (servo.goal(), servo.position())
    });
    session.pty.press(ESCAPE);
    let outcome = session.ended(child).expect(130);
    // 2 deg/s are 23 counts in a second.
    for place in [goal, now] {
        assert!((place - turned).abs() < 60.0, "{place} of {turned}");
    }
    assert_eq!(session.bus.stiff(), ALL, "{outcome:#?}");
}

/// Before the first torque there is nothing to leave in order.
#[test]
fn a_signal_at_the_question_ends_a_run_and_moves_nothing() {
    for sent in [Signal::USR1, Signal::ALARM] {
        let mut session = Session::new("asked", &leg("relax", "relax", ""), 0.5, WAITS);
        let mut child = session.start(&["run", "p.prg", "--hardware", "robot.toml"]);
        await_question(&mut child);
        let from = session.bus.with(positions);
        signal(&child, sent);
        let status = child.wait().expect("it ends");
        assert_eq!(status.signal(), Some(sent.as_raw()));
        assert_eq!(session.bus.stiff(), stiff("relax"));
        assert_eq!(session.bus.with(positions), from);
    }
}

/// A run that ends before its first torque leaves stiff servos stiff, and says so.
#[test]
fn servos_that_were_stiff_before_a_run_that_does_not_start_are_named() {
    let mut session = Session::new("stiff-before", &leg("hold", "hold", ""), 0.5, "END");
    let cold = leg("hold", "hold", "voltage = [20, 24]");
    std::fs::write(session.folder.path("cold.toml"), cold).expect("a file");
    let said = "was on before this run, and stays on: J11 (servo 1), J12 (servo 2), J13 (servo 3)";
    let refused = |session: &Session| {
        let mut child = session.start(&["run", "p.prg", "--hardware", "robot.toml"]);
        // It comes before the question, and starts nothing.
        session.pty.press(RETURN);
        await_question(&mut child);
        for key in *b"q\r" {
            session.pty.press(key);
        }
        let declined = session.ended(child).expect(130).err;
        let jog = ["drives", "jog", "cold.toml", "J12"];
        let run = ["run", "p.prg", "--hardware", "cold.toml", "--yes"];
        let mut all = vec![declined];
        for arguments in [&jog[..], &run] {
            let child = session.start(arguments);
            all.push(session.ended(child).expect(1).err);
        }
        all
    };
    for err in refused(&session) {
        assert!(!err.contains("stays on"), "{err}");
    }
    assert!(session.bus.stiff().is_empty());
    let child = session.run();
    session.ended(child).expect(0);
    for err in refused(&session) {
        assert!(err.contains(said), "{err}");
        assert_eq!(session.bus.stiff(), ALL);
    }
}

#[test]
fn a_port_has_one_master() {
    let session = Session::new("two-masters", &leg("hold", "hold", ""), 0.5, WAITS);
    let mut child = session.run();
    await_go(&mut child);
    let port = session.bus.port();
    let scan = ["drives", "scan", "--family", "sts", "--to", "3"];
    let id = ["drives", "id", "1", "7", "--family", "sts"];
    let monitor = ["drives", "monitor", "robot.toml", "--once"];
    let zero = ["drives", "zero", "robot.toml"];
    let run = ["run", "p.prg", "--hardware", "robot.toml", "--yes"];
    for second in [&scan[..], &id, &monitor, &zero, &run] {
        let outcome = session
            .folder
            .tip(&[second, &["--port", port]].concat())
            .expect(1);
        let said = format!("{port} is in use by tip (process {})", child.id());
        assert!(outcome.err.contains(&said), "{second:?}: {}", outcome.err);
    }
    signal(&child, Signal::TERM);
    session.ended(child).expect(143);
    // It is free again.
    session
        .folder
        .tip(&[&monitor[..], &["--port", port]].concat())
        .expect(0);
}
