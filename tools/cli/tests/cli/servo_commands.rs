//! `tip drives zero`, `id` and `scan`, and lists of faults: nothing is believed, and nothing is written, that does not fit.

use crate::faults::terminal::Pty;
use crate::servo_bus::ServoBus;
use crate::support::{Folder, Outcome};
use crate::torque::{WAITS, leg};
use rustix::process::{Pid, Signal, kill_process};
use std::fs::File;
use std::io::{Read, Write};
use std::process::{Child, ChildStderr, ChildStdin, Stdio};
use tip_drives::simulated::Servo;

/// `tip drives zero` while a hand turns the joints.
struct Zero {
    child: Child,
    input: ChildStdin,
    said: ChildStderr,
    text: String,
}

impl Zero {
    fn start(folder: &Folder, bus: &ServoBus, options: &[&str]) -> Self {
        let zero = ["drives", "zero", "robot.toml", "--port", bus.port()];
        let mut command = folder.command(&[&zero[..], options].concat());
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.stderr(Stdio::piped()).spawn().expect("tip starts");
        Zero {
            input: child.stdin.take().expect("piped"),
            said: child.stderr.take().expect("piped"),
            child,
            text: String::new(),
        }
    }

    /// Waits until it says something more.
    fn asks(&mut self, what: &str) {
        let before = self.text.len();
        let mut bytes = Vec::new();
        loop {
            let mut byte = [0];
            let count = self.said.read(&mut byte).expect("readable");
            assert_eq!(count, 1, "{what:?} is missing: {}", self.text);
            bytes.push(byte[0]);
            if let Ok(text) = str::from_utf8(&bytes) {
                self.text.push_str(text);
                bytes.clear();
            }
            if self.text[before..].ends_with(what) {
                return;
            }
        }
    }

    fn answers(&mut self, line: &str) {
        self.input.write_all(line.as_bytes()).expect("it reads");
    }

    fn ends(self) -> Outcome {
        drop(self.input);
        let mut said = self.said;
        let mut err = self.text;
        let _ = said.read_to_string(&mut err);
        let mut outcome = Outcome::of(self.child.wait_with_output().expect("it ends"));
        outcome.err = err;
        outcome
    }
}

/// A bus with servos of one model at positions, with the identities 1, 2 and so on.
fn bus(model: &str, positions: &[f64], baud: u32) -> ServoBus {
    let servos = (1..).zip(positions);
    let servos = servos.map(|(id, position)| Servo::of(model, id, *position));
    ServoBus::new(servos.collect(), baud)
}

/// Turned by hand after the question and before the key: the place at the key counts, on a slow bus too.
#[test]
fn zero_takes_the_place_at_the_key() {
    for (model, baud, middle) in [("AX-12", 57_600, 512.0), ("STS3215", 1_000_000, 2048.0)] {
        let robot = leg("hold", "hold", &format!("baud = {baud}")).replace("STS3215", model);
        let folder = Folder::new(&format!("zero-{model}")).file("robot.toml", &robot);
        let mut bus = bus(model, &[middle; 3], baud);
        let mut zero = Zero::start(&folder, &bus, &["--write"]);
        for (id, sign) in [(1, 1.0), (2, -1.0), (3, 1.0)] {
            zero.asks(&format!("J1{id} at 0: "));
            bus.with(|bus| bus.turn(id, 10.0 * f64::from(id)));
            zero.answers("\n");
            zero.asks("in its positive direction: ");
            bus.with(|bus| bus.turn(id, 20.0 * sign));
            zero.answers("\n");
        }
        let outcome = zero.ends().expect(0);
        assert!(outcome.out.contains("of J11, J12, J13 now"), "{outcome:#?}");
        let written = folder.read("robot.toml");
        let value = |key: &str| -> Vec<f64> {
            let lines = written.lines().filter(|line| line.starts_with(key));
            let values = lines.filter_map(|line| line.split('=').nth(1)?.trim().parse().ok());
            values.collect()
        };
        assert_eq!(value("sign"), [1.0, -1.0, 1.0], "{model}");
        // Counts are as fine as 0.29 deg.
        for (offset, turned) in value("offset").iter().zip([10.0, 20.0, 30.0]) {
            assert!((offset - turned).abs() <= 0.3, "{model}: {offset}");
        }
    }
}

/// From 4000 by 20 deg to 132: the sign is + and not -; what nobody can tell is asked again.
#[test]
fn zero_knows_the_end_of_a_turn() {
    let folder = Folder::new("zero-seam").file("robot.toml", leg("hold", "hold", ""));
    let mut bus = bus("STS3215", &[4000.0, 2048.0, 2048.0], 1_000_000);
    let mut zero = Zero::start(&folder, &bus, &[]);
    zero.asks("J11 at 0: ");
    zero.answers("\n");
    zero.asks("in its positive direction: ");
    bus.with(|bus| bus.turn(1, 20.0));
    zero.answers("\n");
    zero.asks("J12 at 0: ");
    assert!(
        zero.text
            .contains("over the end of its servo's travel (4095 to 0)")
    );
    zero.answers("\n");
    zero.asks("in its positive direction: ");
    bus.with(|bus| bus.turn(2, 150.0));
    zero.answers("\n");
    zero.asks("J12 at 0: ");
    assert!(
        zero.text
            .contains("turned by 150 deg or the other way round")
    );
    let outcome = zero.ends().expect(1);
    assert!(
        outcome
            .out
            .contains("joint = \"J11\", sign = 1, offset = 171."),
        "{outcome:#?}"
    );
    assert!(!outcome.out.contains("J12"), "{outcome:#?}");
}

#[test]
fn zero_keeps_what_was_found_before_it_was_interrupted_or_failed() {
    for ends in ["SIGINT", "unplugged"] {
        let folder =
            Folder::new(&format!("zero-{ends}")).file("robot.toml", leg("hold", "hold", ""));
        let mut bus = bus("STS3215", &[2100.0, 2048.0, 2048.0], 1_000_000);
        let mut zero = Zero::start(&folder, &bus, &["--write"]);
        zero.asks("J11 at 0: ");
        zero.answers("\n");
        zero.asks("in its positive direction: ");
        bus.with(|bus| bus.turn(1, -20.0));
        zero.answers("\n");
        zero.asks("J12 at 0: ");
        let status = match ends {
            "SIGINT" => {
                kill_process(Pid::from_child(&zero.child), Signal::INT).expect("ours");
                // Before the end of its input, which ends it too.
                zero.child.wait().expect("it ends");
                130
            }
            _ => {
                bus.hang_up();
                zero.answers("\n");
                1
            }
        };
        let outcome = zero.ends().expect(status);
        assert!(outcome.out.contains("of J11 now"), "{ends}: {outcome:#?}");
        let written = folder.read("robot.toml");
        assert!(written.contains("offset = 4.6"), "{ends}: {written}");
        assert!(written.contains("sign = -1"), "{ends}: {written}");
    }
}

/// A servo that has gone is no angle, even though it had one before.
#[test]
fn zero_does_not_take_an_old_angle() {
    let folder = Folder::new("zero-old").file("robot.toml", leg("hold", "hold", ""));
    let text = folder
        .read("robot.toml")
        .replace("latency = 400", "latency = 20");
    let folder = folder.file("robot.toml", text);
    let mut bus = bus("STS3215", &[2048.0; 3], 1_000_000);
    let mut zero = Zero::start(&folder, &bus, &[]);
    zero.asks("J11 at 0: ");
    bus.with(|bus| bus.unplug(1));
    zero.answers("\n");
    zero.asks("J11 (servo 1) gave no two equal positions in a row: keep the joint still, look at its cables, and do it again\n");
    let outcome = zero.ends().expect(1);
    assert_eq!(outcome.out, "");
}

/// A robot that holds itself is not dropped without a word, whatever the family says in a reading.
#[test]
fn zero_releases_servos_after_a_key() {
    for model in ["STS3215", "XL430-W250", "LX-16A"] {
        let robot = leg("hold", "hold", "").replace("STS3215", model);
        let folder = Folder::new(&format!("zero-held-{model}")).file("robot.toml", &robot);
        let folder = folder.program("p.prg", "END");
        let mut bus = ServoBus::of(&robot, 0.5);
        let run = ["run", "p.prg", "--hardware", "robot.toml", "--yes"];
        let port = ["--port", bus.port()];
        folder.tip(&[&run[..], &port].concat()).expect(0);
        assert_eq!(bus.stiff(), [1, 2, 3], "{model}");
        let mut zero = Zero::start(&folder, &bus, &[]);
        zero.asks("RETURN switches their torque off: ");
        assert_eq!(bus.stiff(), [1, 2, 3], "{model}");
        let outcome = zero.ends().expect(1);
        assert!(outcome.err.contains("the input ended"), "{}", outcome.err);
        assert_eq!(bus.stiff(), [1, 2, 3], "{model}: nobody agreed");
        let mut zero = Zero::start(&folder, &bus, &[]);
        zero.asks("RETURN switches their torque off: ");
        zero.answers("\n");
        zero.asks("J11 at 0: ");
        assert!(bus.stiff().is_empty(), "{model}");
        zero.ends().expect(1);
    }
}

/// Neither a joint that was skipped at one of its questions nor one that was not turned has a result; the end of the input is none.
#[test]
fn zero_writes_joints_that_were_turned_and_no_others() {
    let robot = leg("hold", "hold", "");
    let folder = Folder::new("zero-skipped").file("robot.toml", &robot);
    let mut bus = bus("STS3215", &[2100.0, 2162.0, 2048.0], 1_000_000);
    let mut zero = Zero::start(&folder, &bus, &["--write"]);
    zero.asks("J11 at 0: ");
    zero.answers("\n");
    zero.asks("in its positive direction: ");
    bus.with(|bus| bus.turn(1, 20.0));
    zero.answers("s\n");
    zero.asks("J11 is skipped; its sign and its offset stay\n");
    zero.asks("J12 at 0: ");
    zero.answers("yes\n");
    zero.asks("`yes` is no answer: RETURN alone goes on, 's' and RETURN skips\n");
    zero.asks("J12 at 0: ");
    zero.answers("\n");
    zero.asks("in its positive direction: ");
    bus.with(|bus| bus.turn(2, 2.0));
    zero.answers("\n");
    zero.asks("J12 at 0: ");
    let said = "J12 has turned by less than 3 deg, so its sign and its 0 are not certain";
    assert!(zero.text.contains(said), "{}", zero.text);
    bus.with(|bus| bus.turn(2, -2.0));
    zero.answers("\n");
    zero.asks("in its positive direction: ");
    bus.with(|bus| bus.turn(2, 4.0));
    zero.answers("\n");
    zero.asks("J13 at 0: ");
    zero.answers("\n");
    zero.asks("in its positive direction: ");
    let outcome = zero.ends().expect(1);
    let said = "the input ended before these joints were done: J13 (servo 3)";
    assert!(outcome.err.contains(said), "{}", outcome.err);
    assert_eq!(
        outcome.out,
        "robot.toml has the signs and offsets of J12 now\n"
    );
    let old = "joint = \"J12\"\n";
    let new = "joint = \"J12\"\nsign = 1\noffset = 10\n";
    assert_eq!(folder.read("robot.toml"), robot.replace(old, new));
    assert!(bus.stiff().is_empty());
}

/// Comments, order and every other key stay; a file that would be wrong then is not written.
#[test]
fn zeros_are_written_into_the_description_and_nothing_else_changes() {
    let robot = leg("hold", "hold", "")
        .replace("id = 1\n", "id = 1\noffset=0   # by eye\n")
        .replace("id = 2\n", "id = 2\nsign = 1\n");
    let folder = Folder::new("zero-written").file("robot.toml", &robot);
    let mut bus = bus("STS3215", &[2100.0, 2162.0, 3248.0], 1_000_000);
    let zero = |bus: &mut ServoBus, turns: [f64; 3], options: &[&str]| {
        let mut zero = Zero::start(&folder, bus, options);
        for (id, turn) in (1..).zip(turns) {
            zero.asks(&format!("J1{id} at 0: "));
            if turn == 0.0 {
                // A word is no answer.
                zero.answers("quit\n");
                zero.asks(&format!("J1{id} at 0: "));
                zero.answers("s\n");
                continue;
            }
            zero.answers("\n");
            zero.asks("in its positive direction: ");
            bus.with(|bus| bus.turn(id, turn));
            zero.answers("\n");
        }
        zero.ends()
    };
    let none = zero(&mut bus, [0.0; 3], &["--write"]).expect(0).err;
    assert!(none.contains("robot.toml stays as it is"), "{none}");
    let printed = zero(&mut bus, [20.0, -20.0, 0.0], &[]).expect(0).out;
    assert!(
        printed.contains("joint = \"J11\", sign = 1, offset = 4.6\n"),
        "{printed}"
    );
    assert_eq!(folder.read("robot.toml"), robot);
    bus.with(|bus| {
        bus.turn(1, -20.0);
        bus.turn(2, 20.0);
    });
    zero(&mut bus, [20.0, -20.0, 0.0], &["--write"]).expect(0);
    let expected = robot
        .replace("offset=0   #", "offset= 4.6   #")
        .replace("joint = \"J11\"\n", "joint = \"J11\"\nsign = 1\n")
        .replace("joint = \"J12\"\n", "joint = \"J12\"\noffset = 10\n")
        .replace("id = 2\nsign = 1\n", "id = 2\nsign = -1\n");
    assert_eq!(folder.read("robot.toml"), expected);
    folder.tip(&["robot", "check", "robot.toml"]).expect(0);
    // At 105.5 deg, its limits would be beyond the servo's travel.
    let outcome = zero(&mut bus, [0.0, 0.0, 20.0], &["--write"]).expect(1);
    let said = "robot.toml is not changed";
    assert!(outcome.err.contains(said), "{}", outcome.err);
    let printed = "joint = \"J13\", sign = 1, offset = 105.5";
    assert!(outcome.out.contains(printed), "{}", outcome.out);
    assert_eq!(folder.read("robot.toml"), expected);
}

/// It ends as other commands do that someone reads until a signal.
#[test]
fn monitor_ends_with_the_status_of_what_ended_it() {
    let folder = Folder::new("monitor-ends").file("robot.toml", leg("hold", "hold", ""));
    let bus = bus("STS3215", &[2048.0; 3], 1_000_000);
    let monitor = ["drives", "monitor", "robot.toml", "--port", bus.port()];
    let start = |out: Stdio| {
        let mut command = folder.command(&monitor);
        command.stdin(Stdio::null()).stdout(out);
        command.stderr(Stdio::piped()).spawn().expect("tip starts")
    };
    let await_table = |child: &mut Child| {
        let out = child.stdout.as_mut().expect("piped");
        out.read_exact(&mut [0; 80]).expect("a table");
    };
    for (signal, status) in [(Signal::HUP, 129), (Signal::TERM, 143), (Signal::INT, 130)] {
        let mut child = start(Stdio::piped());
        await_table(&mut child);
        kill_process(Pid::from_child(&child), signal).expect("ours");
        Outcome::of(child.wait_with_output().expect("it ends")).expect(status);
    }
    let mut child = start(Stdio::piped());
    await_table(&mut child);
    drop(child.stdout.take());
    Outcome::of(child.wait_with_output().expect("it ends")).expect(130);
    // A terminal that is closed without a signal cannot be written.
    let screen = Pty::new();
    let child = start(screen.input());
    drop(screen);
    let outcome = Outcome::of(child.wait_with_output().expect("it ends")).expect(1);
    let said = "cannot write standard output";
    assert!(outcome.err.contains(said), "{}", outcome.err);
}

/// The control table of an AX-12, without what the servo measures.
fn table(bus: &mut ServoBus) -> Vec<u8> {
    bus.with(|bus| {
        let servo = &bus.servos()[0];
        let registers = (0..36).filter_map(|address| servo.register(address, 1));
        registers.map(|value| value as u8).collect()
    })
}

/// A servo that gets a number loses its torque: its operator is asked.
#[test]
fn a_servo_that_holds_gets_a_number_after_return_only() {
    let robot = leg("hold", "hold", "");
    let folder = Folder::new("id-holds").file("robot.toml", &robot);
    let folder = folder.program("p.prg", "END");
    let mut bus = ServoBus::of(&robot, 0.5);
    let run = ["run", "p.prg", "--hardware", "robot.toml", "--yes"];
    let port = bus.port().to_owned();
    folder
        .tip(&[&run[..], &["--port", &port]].concat())
        .expect(0);
    let id = |typed: &str| {
        std::fs::write(folder.path("typed"), typed).expect("a file");
        let id = ["drives", "id", "1", "7", "--family", "sts"];
        let more = ["--latency", "300", "--port", &port];
        let mut command = folder.command(&[&id[..], &more].concat());
        command.stdin(File::open(folder.path("typed")).expect("a file"));
        Outcome::of(command.output().expect("tip starts"))
    };
    for typed in ["", "no\n"] {
        let kept = id(typed).expect(1);
        assert!(kept.err.contains("servo 1 holds."), "{}", kept.err);
        assert!(kept.err.contains("keeps its number"), "{}", kept.err);
        assert_eq!(bus.stiff(), [1, 2, 3]);
    }
    assert_eq!(id("\n").expect(0).out, "servo 1 is servo 7 now\n");
    assert_eq!(bus.stiff(), [2, 3]);
}

#[test]
fn an_identity_is_written_into_a_servo_of_the_family_only() {
    let folder = Folder::new("id-family");
    let mut bus = bus("AX-12", &[512.0], 1_000_000);
    let before = table(&mut bus);
    assert!(before.len() > 20);
    let port = bus.port().to_owned();
    let id = |from: &str, to: &str, family: &str| {
        let id = ["drives", "id", from, to, "--family", family];
        // Tests share their machine: an answer may take long here.
        folder.tip(&[&id[..], &["--latency", "300", "--port", &port]].concat())
    };
    let wrong = id("1", "7", "sts").expect(1);
    assert!(
        wrong
            .err
            .contains("servo 1 is of another family: it reports to be AX-12 (--family ax)"),
        "{}",
        wrong.err
    );
    for family in ["x", "lx", "moteus"] {
        let other = id("1", "7", family).expect(1);
        let said = ": give --family ax\n";
        assert!(other.err.contains(said), "{family}: {}", other.err);
    }
    let silent = id("2", "7", "moteus").expect(1).err;
    let said = "nor does one answer as --family ax, x, sts, lx at this speed";
    assert!(silent.contains(said), "{silent}");
    assert_eq!(table(&mut bus), before, "nothing was written");
    assert_eq!(id("1", "7", "ax").expect(0).out, "servo 1 is servo 7 now\n");
    assert_eq!(bus.with(|bus| bus.servos()[0].id()), 7);
    // Its frames are understood, its registers mean something else.
    let scan = [
        "drives",
        "scan",
        "--family",
        "sts",
        "--to",
        "8",
        "--latency",
        "50",
        "--port",
        &port,
    ];
    let doubtful = folder.tip(&scan).expect(0);
    assert!(doubtful.out.contains("AX-12?"), "{}", doubtful.out);
    assert!(
        doubtful.err.contains("servo 7 is of another family"),
        "{}",
        doubtful.err
    );
    let all = folder
        .tip(&[
            "drives",
            "scan",
            "--to",
            "8",
            "--latency",
            "20",
            "--port",
            &port,
        ])
        .expect(0);
    assert!(
        all.out.contains("1 servos found") && all.out.contains("  7  AX-12 "),
        "{}",
        all.out
    );
    assert!(
        all.err.contains("asking mjbots moteus, identities 0 to 8"),
        "{}",
        all.err
    );
}

/// Another family is found from its answers, also where it reports no model.
#[test]
fn a_servo_of_another_family_is_named() {
    let folder = Folder::new("id-other");
    for (model, asked, said) in [
        (
            "LX-16A",
            "sts",
            "servo 1 does not answer as Feetech STS does, but as Hiwonder LX: give --family lx",
        ),
        ("STS3215", "x", ": give --family sts"),
        ("moteus-mj5208", "lx", ": give --family moteus"),
    ] {
        let bus = bus(model, &[500.0], 1_000_000);
        let id = [
            "drives",
            "id",
            "1",
            "7",
            "--latency",
            "50",
            "--port",
            bus.port(),
        ];
        let outcome = folder
            .tip(&[&id[..], &["--family", asked]].concat())
            .expect(1);
        assert!(outcome.err.contains(said), "{model}: {}", outcome.err);
        let scan = scan(&bus);
        if asked == "x" {
            let outcome = folder
                .tip(&[&scan[..], &["--family", asked]].concat())
                .expect(1);
            let said = "or try the other families, ax, sts, lx, moteus";
            assert!(outcome.err.contains(said), "{model}: {}", outcome.err);
        }
    }
}

/// Returns the arguments that look for the first identities.
fn scan(bus: &ServoBus) -> Vec<&str> {
    let scan = ["drives", "scan", "--to", "2", "--latency", "50", "--port"];
    [&scan[..], &[bus.port()]].concat()
}

/// All families are asked, those of lines too.
#[test]
fn a_scan_lists_servos_of_every_family() {
    let folder = Folder::new("scan-all");
    for (model, name) in [
        ("moteus-mj5208", "mjbots moteus"),
        ("LX-16A", "Hiwonder LX"),
        ("XL430-W250", "XL430-W250"),
    ] {
        let bus = bus(model, &[500.0], 1_000_000);
        let scan = scan(&bus);
        let outcome = folder.tip(&scan).expect(0);
        assert!(
            outcome.out.contains(name) && outcome.out.contains("1 servos found"),
            "{model}: {outcome:#?}"
        );
    }
}

#[test]
fn a_fault_that_can_never_happen_is_refused() {
    let folder = Folder::new("injected")
        .file("robot.toml", leg("hold", "hold", ""))
        .program("p.prg", WAITS);
    for (list, reason) in [
        (
            "unplug=99@1",
            "`unplug=99@1` can never happen: the robot has no servo 99",
        ),
        ("faults=0.01,reset=4@1", "the robot has no servo 4"),
        ("unplug=1@nan", "is not a list of faults"),
        ("unplug=1@inf", "is not a list of faults"),
        ("unplug=1@-1", "is not a list of faults"),
        ("unplug=1@", "is not a list of faults"),
        ("unplug=@1", "is not a list of faults"),
        ("unplug=", "is not a list of faults"),
        ("faults=", "is not a list of faults"),
        ("faults=nan", "is not a list of faults"),
        ("drop=-0.1", "is not a list of faults"),
        ("drop=0.1,,sag=1@1", "is not a list of faults"),
        ("drop=0.1,", "is not a list of faults"),
    ] {
        let port = format!("simulated:{list}");
        let run = [
            "run",
            "p.prg",
            "--hardware",
            "robot.toml",
            "--cycles",
            "5",
            "--port",
            &port,
        ];
        let err = folder.tip(&run).expect(1).err;
        assert!(err.contains(reason), "{list}: {err}");
        let simulate = ["drives", "simulate", "robot.toml", "--inject", list];
        let err = folder.tip(&simulate).expect(2).err;
        assert!(err.contains(reason), "{list}: {err}");
    }
    for port in [
        "simulated",
        "simulated:unplug=1@1e6",
        "simulated:faults=0,sag=3@60",
    ] {
        let run = [
            "run",
            "p.prg",
            "--hardware",
            "robot.toml",
            "--cycles",
            "5",
            "--port",
            port,
        ];
        folder.tip(&run).expect(0);
    }
    let run = [
        "run",
        "p.prg",
        "--hardware",
        "robot.toml",
        "--port",
        "simulatedx",
        "--yes",
    ];
    let err = folder.tip(&run).expect(1).err;
    assert!(err.contains("cannot open simulatedx"), "{err}");
}
