//! Real robots whose servos are simulated: runs, faults, and `tip drives` on a pseudo-terminal.

use crate::servo_bus::ServoBus;
use crate::support::Folder;
use crate::torque::leg;
use crate::view::data;
use serde_json::Value;
use std::io::{BufRead, BufReader};
use std::process::{Child, Stdio};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;
use tip_drives::model::MODELS;

/// The description with a bus, and the gait, of a new crate for a robot. Each is made once: its gait is tried in simulation.
pub(crate) fn made(robot: &str) -> &'static [String; 2] {
    static PHANTOMX: OnceLock<[String; 2]> = OnceLock::new();
    static SPOTMICRO: OnceLock<[String; 2]> = OnceLock::new();
    let cell = match robot {
        "phantomx" => &PHANTOMX,
        _ => &SPOTMICRO,
    };
    cell.get_or_init(|| {
        let folder = Folder::new(&format!("drives-made-{robot}"));
        folder
            .tip(&["new", "it", "--robot", robot, "--hardware"])
            .expect(0);
        ["it/robot.toml", "it/motions/walk.prg"].map(|name| folder.read(name))
    })
}

/// A robot with a bus; its program moves all feet back and ahead, and ends.
pub(crate) fn crate_for(robot: &str) -> Folder {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let n = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Folder::new(&format!("drives-{robot}-{n}"));
    let legs = if robot == "phantomx" { 6 } else { 4 };
    let move_all = |way: i32| -> String {
        let feet = (1..=legs).map(|leg| format!("  REL_PTP F{leg} 0 {way} 0\n"));
        format!(
            "  ALL_STOP\n{}  ALL_STOP_RELEASE\n  WAIT_INPOS ALL\n",
            feet.collect::<String>()
        )
    };
    let program = format!(
        "3.1\nAll feet go back and ahead\nDEF_VAR N\nINITIAL_POSTURE\nWAIT_INPOS ALL\nFOR N = 1 TO 8\n  MESSAGE move %N%\n{}{}NEXT N\nEND\n",
        move_all(-30),
        move_all(30)
    );
    folder
        .file("it/robot.toml", &made(robot)[0])
        .file("it/motions/walk.prg", program)
}

/// Returns the folder of [`crate_for`] with servos of another model. LX servos have 115200 bit/s, at which a reading of 18 takes 35 ms.
pub(crate) fn crate_on(robot: &str, servo: &str) -> Folder {
    let folder = crate_for(robot);
    let made = folder.read("it/robot.toml");
    if made.contains(&format!("servo = \"{servo}\"\n")) {
        return folder;
    }
    let own = format!("servo = \"{servo}\"\nbaud = 115200\n");
    let described = made
        .replace("servo = \"AX-12\"\n", &own)
        .replace("[standards]\n", "[standards]\nperiod = 40\n")
        .replace("voltage = [9, 13]", "voltage = [6, 13]");
    assert!(described.contains(&own) && described.contains("period = 40"));
    folder.file("it/robot.toml", described)
}

/// The gait of a new crate is steered on servos as in the simulation: the host has the sticks, every command is within the limits of
/// the drives, and no answer is missing.
#[test]
fn a_gait_is_steered_on_servos() {
    for robot in ["phantomx", "spotmicro"] {
        let folder = crate_for(robot).file("gait.prg", &made(robot)[1]);
        let walk = "VR1=10@3s..6s";
        let run = [
            "run",
            "gait.prg",
            "--hardware",
            "it/robot.toml",
            "--sensor",
            walk,
            "--halt",
            "450",
            "--cycles",
            "900",
        ];
        let outcome = folder.tip(&run).expect(0);
        assert!(
            outcome.out.contains("sitting down"),
            "{robot}: {}",
            outcome.out
        );
        assert!(
            outcome.err.contains("EXIT at line"),
            "{robot}: {}",
            outcome.err
        );
        assert!(
            outcome.err.contains("  answers 0 of "),
            "{robot}: {}",
            outcome.err
        );
    }
}

/// A gait is derived for the slowest drive of a description; one that needs faster servos is refused.
#[test]
fn a_gait_that_drives_are_too_slow_for_is_refused() {
    let (before, after) = made("spotmicro")[0].split_once("id = 7").expect("a drive");
    let slow = after.replacen("speed = 270", "speed = 90", 1);
    let folder = Folder::new("drives-slow").file("slow.toml", format!("{before}id = 7{slow}"));
    let new = ["new", "it", "--robot", "slow.toml", "--gait", "trot"];
    let said = folder.tip(&new).expect(1).err;
    let reason = "servos that turn 90 deg/s are too slow for it";
    assert!(said.contains(reason), "{said}");
}

/// The steps of a trace in their order, the messages, and the angles of the last cycle.
fn trace(text: &str) -> (Vec<u64>, Vec<String>, Vec<f64>) {
    let (mut steps, mut said, mut angles) = (Vec::new(), Vec::new(), Vec::new());
    for line in text.lines() {
        let record: Value = serde_json::from_str(line).expect("JSON");
        if let Some(step) = record["step"].as_u64() {
            steps.push(step);
        }
        said.extend(record["say"].as_str().map(str::to_owned));
        if let Some(now) = record["angles"].as_array() {
            let now = now.iter().flat_map(|leg| match leg {
                Value::Array(leg) => leg.clone(),
                angle => vec![angle.clone()],
            });
            angles = now.filter_map(|angle| angle.as_f64()).collect();
        }
    }
    // A step that waits takes longer on servos.
    steps.dedup();
    (steps, said, angles)
}

/// No servo measures a force or moves a slider: such a robot would stop in its first cycle, with its torque on.
#[test]
fn a_robot_that_a_bus_cannot_measure_is_refused_before_torque() {
    let folder = crate_for("phantomx");
    let text = folder.read("it/robot.toml");
    for (table, keys) in [
        ("forces", "torque_max = 2"),
        ("slider", "initial = [0, 0, 0]"),
    ] {
        let folder = Folder::new(&format!("drives-no-{table}"))
            .file("robot.toml", format!("{text}\n[{table}]\n{keys}\n"))
            .file("walk.prg", folder.read("it/motions/walk.prg"));
        // The same file is sound where nothing is real.
        folder.tip(&["robot", "check", "robot.toml"]).expect(0);
        let run = ["run", "walk.prg", "--hardware", "robot.toml"];
        let outcome = folder.tip(&run).expect(1);
        let said = format!("error: robot.toml: [{table}] cannot be on a bus");
        assert!(outcome.err.contains(&said), "{outcome:#?}");
        assert!(!outcome.err.contains("18 servos"), "{outcome:#?}");
    }
}

#[test]
fn robots_walk_on_servos_as_they_do_in_the_simulation() {
    for (robot, servo, resolution, servos) in [
        ("phantomx", "AX-12", 0.3, 18),
        ("phantomx", "LX-16A", 0.24, 18),
        ("spotmicro", "STS3215", 0.09, 12),
    ] {
        let folder = crate_on(robot, servo);
        let run = |options: &[&str], out: &str| {
            let all = [
                "run",
                "it/motions/walk.prg",
                "--trace-motion",
                "--trace",
                out,
            ];
            let outcome = folder.tip(&[&all[..], options].concat()).expect(0);
            (trace(&folder.read(out)), outcome.err)
        };
        let (real, said) = run(&["--hardware", "it/robot.toml"], "real.jsonl");
        let (simulated, _) = run(&["--robot", "it/robot.toml"], "simulated.jsonl");
        assert_eq!(real.0, simulated.0, "{robot}: steps");
        assert_eq!(real.1, simulated.1, "{robot}: messages");
        assert_eq!(real.2.len(), servos, "{robot}: {said}");
        // `tip view` shows both on one page.
        let view = [
            "view",
            "real.jsonl",
            "simulated.jsonl",
            "--program",
            "it/motions/walk.prg",
            "--robot",
            "it/robot.toml",
            "-o",
            "both.html",
        ];
        folder.tip(&view).expect(0);
        let page = folder.read("both.html");
        let [recorded, compared] = ["recording", "compared"].map(|id| data(&page, id));
        assert!(recorded.len() > 1000 && compared.len() > 1000, "{robot}");
        assert_ne!(recorded, compared, "{robot}: servos lag");
        for (real, simulated) in real.2.iter().zip(&simulated.2) {
            // The last step may begin within JUST of its position, 1 deg.
            let difference = (real - simulated).abs();
            assert!(difference <= 1.0 + resolution, "{robot}: {difference} deg");
        }
        let bus = format!("  bus     {servos} servos, ");
        assert!(said.contains(&bus), "{said}");
        assert!(said.contains("  answers 0 of "), "{said}");
    }
}

/// Where the robot rests between its steps, every joint is where the simulator has it, to half a count of its servo.
#[test]
fn robots_on_servos_rest_where_simulated_ones_do() {
    for (robot, servo, count) in [
        ("phantomx", "AX-12", 300.0 / 1024.0),
        ("phantomx", "LX-16A", 240.0 / 1000.0),
        ("spotmicro", "STS3215", 360.0 / 4096.0),
    ] {
        let folder = crate_on(robot, servo);
        // One stride; after each wait it rests for 0.4 s, and says so.
        let program = folder
            .read("it/motions/walk.prg")
            .replace("STRIDES = 4", "STRIDES = 1");
        let rests = program.lines().map(|line| {
            let waits = line.trim_start().starts_with("WAIT_");
            format!(
                "{line}\n{}",
                if waits {
                    "SLEEP 400\nMESSAGE rest\n"
                } else {
                    ""
                }
            )
        });
        let program: String = rests.collect();
        let folder = folder.file("rests.prg", program);
        let run = |where_to: &str| {
            let robot = "it/robot.toml";
            let run = ["run", "rests.prg", where_to, robot, "--trace-motion"];
            let all = [&run[..], &["--trace", "trace.jsonl"]].concat();
            folder.tip(&all).expect(0);
            let trace = folder.read("trace.jsonl");
            let rests = trace
                .lines()
                .filter(|line| line.contains("\"say\":\"rest\""));
            rests.map(|line| self::trace(line).2).collect::<Vec<_>>()
        };
        let (real, simulated) = (run("--hardware"), run("--robot"));
        assert!(real.len() > 15, "{robot}: {} rests", real.len());
        assert_eq!(real.len(), simulated.len(), "{robot}");
        let pairs = real.iter().flatten().zip(simulated.iter().flatten());
        let farthest = pairs.map(|(real, simulated)| (real - simulated).abs());
        let farthest = farthest.fold(0.0, f64::max);
        assert!(farthest <= 0.51 * count, "{robot} {servo}: {farthest} deg");
    }
}

/// The faults of docs/drives.md, on both robots. `tests/external/drives/run` lets them happen in real time.
#[test]
fn each_fault_has_its_outcome() {
    for robot in ["phantomx", "spotmicro"] {
        each_fault_has_its_outcome_on(robot);
    }
}

fn each_fault_has_its_outcome_on(robot: &str) {
    let folder = crate_for(robot);
    // An AX says its load in units of about 0.1 %, 1000 of 1023 at most.
    let blocked = match robot {
        "phantomx" => "J31 (servo 7) needs 0.98 of its torque for too long",
        _ => "J31 (servo 7) needs 1.00 of its torque for too long",
    };
    for (fault, status, reason) in [
        ("", 0, "answers 0 of "),
        ("corrupt=0.01", 0, " missing, "),
        ("drop=0.01", 0, " missing, "),
        ("duplicate=0.01", 0, "  bus     "),
        ("delay=0.01", 0, " missing, "),
        ("truncate=0.01", 0, " missing, "),
        ("faults=0.01", 0, " missing, "),
        (
            "unplug=7@3",
            3,
            "J31 (servo 7) has not answered for more than 5 cycles",
        ),
        ("reset=7@3", 3, "J31 (servo 7) has lost its torque"),
        (
            "overheat=7@3",
            3,
            "J31 (servo 7) has 66 °C, and 65 at most is allowed",
        ),
        ("block=7@3", 3, blocked),
        (
            "sag=7@3",
            3,
            "J31 (servo 7) measures 7 V, and 9 to 13 V are allowed",
        ),
        ("unplug=7@0", 1, "J31 (servo 7) has not answered"),
        ("faults=2", 1, "`faults=2` is not a list of faults"),
        ("fire=7@3", 1, "`fire=7@3` is not a list of faults"),
    ] {
        let port = format!("simulated:{fault}");
        let run = [
            "run",
            "it/motions/walk.prg",
            "--hardware",
            "it/robot.toml",
            "--port",
            &port,
            "--cycles",
            "500",
        ];
        let outcome = folder.tip(&run).expect(status);
        assert!(
            outcome.err.contains(reason),
            "{robot} {fault}: {}",
            outcome.err
        );
        // The report of the emergency stop names the servo too.
        let named = "the hardware of the robot failed: J31 (servo 7): ";
        assert_eq!(
            outcome.err.contains(named),
            status == 3,
            "{robot} {fault}: {}",
            outcome.err
        );
    }
}

#[test]
fn a_model_that_does_not_exist_is_answered_with_all_that_do() {
    let robot = leg("hold", "hold", "").replace("STS3215", "AX12");
    let folder = Folder::new("drives-no-model").file("robot.toml", robot);
    let outcome = folder.tip(&["robot", "check", "robot.toml"]).expect(1);
    for model in MODELS {
        assert!(outcome.err.contains(model.name), "{}", outcome.err);
    }
    let help = "did you mean `AX-12`?";
    assert!(outcome.err.contains(help), "{}", outcome.err);
}

/// A hexapod loses the power of all its servos.
#[test]
fn every_servo_that_does_not_confirm_is_named() {
    let folder = crate_for("phantomx");
    let unplug = (1..=18).map(|id| format!("unplug={id}@3"));
    let port = format!("simulated:{}", unplug.collect::<Vec<_>>().join(","));
    let run = ["run", "it/motions/walk.prg", "--hardware", "it/robot.toml"];
    let outcome = folder
        .tip(&[&run[..], &["--port", &port]].concat())
        .expect(3);
    let name = |n: usize| {
        let (leg, joint) = (n / 3 + 1, n % 3 + 1);
        format!("J{leg}{joint} (servo {})", n + 1)
    };
    let names: Vec<String> = (0..18).map(name).collect();
    let said = format!(
        "because they did not confirm that they hold: {}\n",
        names.join(", ")
    );
    assert!(outcome.err.contains(&said), "{}", outcome.err);
}

/// Three answers of 30 bytes and their parts of the request take 0.93 ms at 1 Mbaud, and 60 % of a cycle are for reading.
#[test]
fn a_sampling_time_that_the_bus_cannot_carry_is_refused_with_a_way_out() {
    let robot = |period| leg("relax", "hold", &format!("[standards]\nperiod = {period}"));
    for (period, program, status) in [
        (1, "END", 1),
        (20, "SET_SAMPLING_TIME 1\nSLEEP 100\nEND", 3),
    ] {
        let folder = Folder::new(&format!("drives-period-{period}"))
            .file("robot.toml", robot(period))
            .program("p.prg", program);
        let run = ["run", "p.prg", "--hardware", "robot.toml", "--port"];
        let outcome = folder
            .tip(&[&run[..], &["simulated"]].concat())
            .expect(status);
        for said in [
            "the bus cannot carry a cycle of 1.0 ms: reading all servos takes 0.9 ms, and commanding them 0.2 ms",
            "Give it 2 ms or more (`period`, SET_SAMPLING_TIME), a faster bus or two of them",
        ] {
            assert!(outcome.err.contains(said), "{period}: {}", outcome.err);
        }
        for other in ["has not answered", "one of 1 cycles"] {
            assert!(!outcome.err.contains(other), "{period}: {}", outcome.err);
        }
    }
}

#[test]
fn equal_faults_give_equal_traces() {
    let folder = crate_for("spotmicro");
    let run = |out: &str| {
        let port = "simulated:faults=0.02";
        folder
            .tip(&[
                "run",
                "it/motions/walk.prg",
                "--hardware",
                "it/robot.toml",
                "--port",
                port,
                "--cycles",
                "200",
                "--trace-state",
                "--trace",
                out,
            ])
            .expect(0);
        folder.read(out)
    };
    assert_eq!(run("a.jsonl"), run("b.jsonl"));
}

#[test]
fn an_input_that_nothing_drives_is_refused_until_it_has_a_value() {
    let folder = crate_for("phantomx").file(
        "stick.prg",
        "3.1\nStick\nDEF_VAR V\nAD_IN VR1 V\nMESSAGE %V%\nEND\n",
    );
    let run = ["run", "stick.prg", "--hardware", "it/robot.toml", "-q"];
    let outcome = folder.tip(&run).expect(1);
    assert!(outcome.err.contains("stick.prg:4:"), "{}", outcome.err);
    let reason = "nothing is connected to VR1";
    assert!(outcome.err.contains(reason), "{}", outcome.err);
    let given = [&run[..], &["--sensor", "VR1=5@0"]].concat();
    assert_eq!(folder.tip(&given).expect(0).out, "5\n");
}

#[test]
fn a_file_without_a_bus_or_a_port_says_what_is_missing() {
    let folder = crate_for("phantomx");
    let text = folder.read("it/robot.toml");
    let without = text.replace("port = \"simulated\"", "");
    let folder = folder.file("port.toml", without);
    let program = "it/motions/walk.prg";
    let outcome = folder
        .tip(&["run", program, "--hardware", "port.toml"])
        .expect(1);
    assert!(
        outcome.err.contains("--port /dev/ttyUSB0"),
        "{}",
        outcome.err
    );
    let (model, _) = text.split_once("[bus]").expect("a bus");
    let folder = folder.file("model.toml", model);
    let outcome = folder
        .tip(&["run", program, "--hardware", "model.toml"])
        .expect(1);
    assert!(
        outcome.err.contains("model.toml has no [bus]"),
        "{}",
        outcome.err
    );
    let wrong = text.replace("id = 2\n", "id = 1\n");
    let folder = folder.file("wrong.toml", wrong);
    let outcome = folder.tip(&["robot", "check", "wrong.toml"]).expect(1);
    let said = outcome.out + &outcome.err;
    let same = "cannot have the identity 1: that of J11 has it";
    assert!(said.contains(same), "{said}");
    assert!(said.contains("give each servo its own `id`"), "{said}");
    let nowhere = ["--port", "/dev/nowhere", "--yes"];
    let run = [&["run", program, "--hardware", "port.toml"][..], &nowhere].concat();
    let outcome = folder.tip(&run).expect(1);
    assert!(
        outcome.err.contains("cannot open /dev/nowhere"),
        "{}",
        outcome.err
    );
}

/// Simulated servos on a pseudo-terminal; the process ends with it.
struct Pty(Child, String);

impl Pty {
    fn open(folder: &Folder) -> Self {
        let mut command = folder.command(&["drives", "simulate", "slow.toml"]);
        let mut child = command.stdout(Stdio::piped()).spawn().expect("it starts");
        let mut line = String::new();
        let out = child.stdout.take().expect("a pipe");
        BufReader::new(out).read_line(&mut line).expect("a line");
        let port = line
            .split_whitespace()
            .find(|word| word.starts_with("/dev/"));
        let port = port.expect(&line).trim_end_matches(';').to_owned();
        Pty(child, port)
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn servos_on_a_pseudo_terminal_are_found_named_watched_and_moved() {
    let folder = crate_for("spotmicro");
    // Tests share their machine: an answer may take long here.
    let slow = folder.read("it/robot.toml").replace(
        "[bus]\n",
        "[bus]\nlatency = 400\nsilence = 200\nlag = [90, 60]\n",
    );
    let folder = folder.file("slow.toml", slow);
    let pty = Pty::open(&folder);
    let (port, patient) = (["--port", &pty.1], ["--latency", "400"]);
    let scan = [
        &["drives", "scan", "--family", "sts", "--to", "13"][..],
        &patient,
        &port,
    ]
    .concat();
    let found = folder.tip(&scan).expect(0).out;
    assert!(found.contains("12 servos found"), "{found}");
    assert!(
        found.contains("STS3215") && found.contains("  12 V"),
        "{found}"
    );

    let id = |from: &str, to: &str| {
        let id = ["drives", "id", from, to, "--family", "sts"];
        folder.tip(&[&id[..], &patient, &port].concat())
    };
    assert!(
        id("3", "4")
            .expect(1)
            .err
            .contains("servo 4 exists already")
    );
    assert_eq!(id("12", "13").expect(0).out, "servo 12 is servo 13 now\n");
    assert_eq!(id("13", "12").expect(0).out, "servo 13 is servo 12 now\n");

    let monitor = [&["drives", "monitor", "slow.toml", "--once"][..], &port].concat();
    let table = folder.tip(&monitor).expect(0).out;
    assert!(table.contains("J43       12  STS3215"), "{table}");

    let run = [
        "run",
        "it/motions/walk.prg",
        "--hardware",
        "slow.toml",
        "--cycles",
        "50",
    ];
    let outcome = folder.tip(&[&run[..], &port].concat()).expect(2);
    assert!(outcome.err.contains("give --yes"), "{}", outcome.err);
    let outcome = folder
        .tip(&[&run[..], &port, &["--yes"]].concat())
        .expect(0);
    assert!(
        outcome.err.contains("  jitter  cycles start late by "),
        "{}",
        outcome.err
    );
}

/// Servos without a host stop within their time-out, or after the last step.
#[test]
fn a_killed_host_leaves_servos_that_stand() {
    let folder = crate_for("spotmicro");
    let slow = folder
        .read("it/robot.toml")
        .replace("STS3215", "XL430-W250")
        .replace(
            "[bus]\n",
            "[bus]\nlatency = 400\nsilence = 200\nlag = [90, 60]\n",
        );
    // Watchdogs wait for ten cycles, and a busy machine keeps the host from its work for longer than those of 20 ms.
    let slow = slow.replace("[standards]\n", "[standards]\nperiod = 100\n");
    let mut bus = ServoBus::of(&slow, 0.0);
    let folder = folder.file("slow.toml", slow);
    let run = [
        "run",
        "it/motions/walk.prg",
        "--hardware",
        "slow.toml",
        "--yes",
        "--port",
        bus.port(),
    ];
    let mut host = folder.command(&run);
    let mut host = host.stderr(Stdio::piped()).spawn().expect("it starts");
    let lines = BufReader::new(host.stderr.take().expect("a pipe")).lines();
    let mut said = Vec::new();
    for line in lines.map_while(Result::ok) {
        said.push(line);
        // The status is shown each second: it walks.
        if said.last().is_some_and(|line| line.starts_with("3.")) {
            break;
        }
    }
    let walks = said.last().is_some_and(|line| line.starts_with("3."));
    assert!(walks, "{said:#?}");
    host.kill().expect("it runs");
    host.wait().expect("it ends");
    std::thread::sleep(Duration::from_secs(1));
    let mut counts = || {
        bus.with(|bus| {
            let counts = bus.servos().iter().map(|servo| servo.position().round());
            counts.collect::<Vec<_>>()
        })
    };
    let stopped = counts();
    assert_eq!(stopped.len(), 12);
    std::thread::sleep(Duration::from_secs(1));
    assert_eq!(counts(), stopped);
    assert_eq!(bus.stiff().len(), 12);
}

#[test]
fn jitter_is_measured() {
    let folder = Folder::new("jitter");
    let outcome = folder.tip(&["jitter", "--period", "2", "--seconds", "0.2"]);
    let text = outcome.expect(0).out;
    assert!(
        text.contains(" of 100 missed\na period of 2 ms is "),
        "{text}"
    );
}
