//! `tip serve --hardware`: a robot on servos that a page drives. The registers of the servos are read meanwhile and afterwards.

use super::client::{Server, Socket};
use crate::faults::terminal::Pty;
use crate::servo_bus::ServoBus;
use crate::support::Folder;
use crate::torque::leg;
use serde_json::{Value, json};
use std::process::Stdio;
use std::time::{Duration, Instant};

/// Nothing takes so long, on however busy a machine.
const PATIENCE: Duration = Duration::from_secs(60);
/// Time without a sign after which the button is pressed anew: the machine was busy.
const LAPSE: Duration = Duration::from_millis(250);

/// Time after which the button is pressed anew: the robot was not ready when it was pressed.
const PRESS: Duration = Duration::from_secs(3);

/// The servos of the robot.
const ALL: [u8; 3] = [1, 2, 3];
const REST: [f64; 3] = [5.0; 3];
const AHEAD: [f64; 3] = [10.0, 5.0, 5.0];

/// It turns joint J11 as far as stick VR1 says, and ends when it is asked to, after another look at the stick.
const STEERED: &str = "DEF_VAR V\nDEF_VAR W\nDEF_VAR X\nDEF_VAR AIM\nLOOP:\nAD_IN VR1 V\nAD_IN VR2 W\nAD_IN VR3 X\nAIM = V * 8\nAIM = AIM - 40\nPTP_ANGLE HS J11 AIM\nIF HALT_REQUEST THEN\nAD_IN VR1 V\nEXIT\nENDIF\nGOTO LOOP:\nEND";
/// The same, but it does not hear a request to halt.
const DEAF: &str = "DEF_VAR V\nDEF_VAR W\nDEF_VAR X\nLOOP:\nAD_IN VR1 V\nAD_IN VR2 W\nAD_IN VR3 X\nGOTO LOOP:\nEND";

/// Silences that no test reaches.
const PATIENT: &str = "driver_silence = [5, 600, 600]";

/// A served robot whose servos relax at the end and hold in an emergency.
struct Bench {
    folder: Folder,
    bus: ServoBus,
    server: Server,
}

impl Bench {
    fn new(name: &str, program: &str, more: &str) -> Self {
        Self::beside(name, program, more, 0.5, Stdio::null())
    }

    /// A robot whose joints are this far from the first posture, deg.
    fn beside(name: &str, program: &str, more: &str, beside: f64, keys: Stdio) -> Self {
        let robot = leg("relax", "hold", more);
        let folder = Folder::new(&format!("serve-drive-{name}"));
        let folder = folder.file("robot.toml", &robot).program("p.prg", program);
        let bus = ServoBus::of(&robot, beside);
        let arguments = ["p.prg", "--hardware", "robot.toml", "--port", bus.port()];
        let arguments = [&arguments[..], &["--trace", "real.jsonl"]].concat();
        let server = Server::with_keys(&folder, &arguments, keys);
        Bench {
            folder,
            bus,
            server,
        }
    }

    /// A page that holds the robot.
    fn driver(&self) -> Page {
        let mut page = self.watcher();
        page.socket.does(json!({"do": "take"}));
        page.until(|page| page.robot["driver"] == true);
        page
    }

    fn watcher(&self) -> Page {
        Page {
            socket: self.server.viewer(),
            press: 1,
            signed: None,
        }
    }

    /// A page that drives the robot, whose program runs.
    fn driven(&self) -> Page {
        let mut page = self.driver();
        page.hold(REST, |page| {
            page.robot["phase"] == "running" && page.cycles > 3
        });
        page
    }

    fn position(&mut self, servo: usize) -> f64 {
        self.bus.with(|bus| bus.servos()[servo].position())
    }
}

/// A page, with the presses of its button.
struct Page {
    socket: Socket,
    press: u32,
    /// The time of the last sign.
    signed: Option<Instant>,
}

impl Page {
    fn sign(&mut self, press: u32, sticks: [f64; 3]) {
        let sign = json!({"do": "drive", "press": press, "sticks": sticks});
        self.socket.say(&sign.to_string());
        self.signed = Some(Instant::now());
    }

    /// Holds the button until something is known.
    #[track_caller]
    fn hold(&mut self, sticks: [f64; 3], knows: impl Fn(&Socket) -> bool) {
        let (begin, mut pressed) = (Instant::now(), Instant::now());
        while !knows(&self.socket) {
            assert!(begin.elapsed() < PATIENCE, "{}", self.socket.robot);
            let is_late = self.signed.is_none_or(|signed| signed.elapsed() > LAPSE);
            let is_vain = self.socket.robot["phase"] == "ready" && pressed.elapsed() > PRESS;
            if is_late || is_vain {
                self.press += 1;
                pressed = Instant::now();
            }
            self.sign(self.press, sticks);
            self.socket.next_soon();
        }
    }

    /// Takes updates until something is known, without a sign.
    #[track_caller]
    fn until(&mut self, knows: impl Fn(&Socket) -> bool) {
        let begin = Instant::now();
        while !knows(&self.socket) {
            assert!(begin.elapsed() < PATIENCE, "{}", self.socket.robot);
            self.socket.next_soon();
        }
    }

    #[track_caller]
    fn refuses(&mut self, request: Value, error: &str) {
        let answer = self.socket.ask(request.clone());
        assert_eq!(
            (&answer["ok"], &answer["error"]),
            (&json!(false), &json!(error)),
            "{request}"
        );
    }
}

fn is_left(page: &Socket) -> bool {
    page.robot["phase"] == "left"
}

#[test]
fn a_held_button_starts_the_robot_which_obeys_the_sticks_and_runs_again() {
    let mut bench = Bench::new("whole", STEERED, PATIENT);
    let mut page = bench.driver();
    page.until(|page| page.robot["servos"][2]["temperature"].is_number());
    let servo = &page.socket.robot["servos"][0];
    assert_eq!((&servo["joint"], &servo["id"]), (&json!("J11"), &json!(1)));
    let angle = servo["angle"].as_f64().expect("measured");
    assert!((angle - 0.5).abs() < 0.2, "{angle}");
    assert!(servo["voltage"].as_f64() > Some(6.0), "{servo}");
    // A click is not enough.
    page.sign(1, REST);
    page.sign(0, REST);
    page.socket.does(json!({"do": "pause"}));
    assert_eq!(page.socket.robot["phase"], "ready");
    assert_eq!(bench.bus.stiff(), [] as [u8; 0]);
    let begin = Instant::now();
    page.hold(REST, |page| page.robot["phase"] != "ready");
    assert!(begin.elapsed() >= Duration::from_millis(900), "{begin:?}");
    page.hold(REST, |page| page.robot["phase"] == "running");
    assert_eq!(bench.bus.stiff(), ALL);
    page.hold(AHEAD, |page| page.value("V") == Some(10.0));
    page.hold(AHEAD, |page| {
        page.robot["servos"][0]["angle"].as_f64() > Some(30.0)
    });
    assert!(bench.position(0) > 2048.0 + 300.0, "30 deg are 341 counts");
    for request in [
        json!({"do": "step", "cycles": -1}),
        json!({"do": "step", "cycles": 1}),
        json!({"do": "go", "cycle": 1}),
        json!({"do": "speed", "times": 0.5}),
        json!({"do": "event", "event": "push 1 1 1 for 5"}),
        json!({"do": "event", "event": "read fails"}),
        json!({"do": "event", "event": "touch on"}),
    ] {
        page.refuses(request, "forward");
    }
    page.refuses(json!({"do": "restart"}), "moving");
    page.refuses(json!({"do": "play"}), "hold");
    page.socket.does(json!({"do": "event", "event": "halt"}));
    page.hold(REST, is_left);
    assert_eq!(page.socket.status["outcome"]["how"], "EXIT");
    assert_eq!(bench.bus.stiff(), [] as [u8; 0], "it relaxes at the end");
    // The button that is held all the time does not start it again.
    let run = page.socket.run;
    page.socket.does(json!({"do": "restart"}));
    page.hold(REST, |page| {
        page.run > run && page.robot["phase"] == "ready"
    });
    page.hold(REST, |page| page.robot["phase"] == "running");
    assert_eq!(bench.bus.stiff(), ALL);
    assert_eq!(bench.server.end(), Some(130));
    assert_eq!(bench.bus.stiff(), [] as [u8; 0], "Ctrl-C ends in order");
}

#[test]
fn a_watcher_moves_nothing_and_stops_the_robot_at_any_time() {
    let mut bench = Bench::new("watcher", STEERED, PATIENT);
    let mut page = bench.driven();
    let mut watcher = bench.watcher();
    watcher.until(|page| page.robot["phase"] == "running");
    assert_eq!(watcher.socket.robot["driver"], false);
    for request in [
        json!({"do": "drive", "press": 1, "sticks": AHEAD}),
        json!({"do": "pause"}),
        json!({"do": "play"}),
        json!({"do": "give"}),
        json!({"do": "restart"}),
        json!({"do": "event", "event": "halt"}),
        json!({"do": "event", "event": "key F"}),
        json!({"do": "event", "event": "VR1=10"}),
        json!({"do": "event", "event": "set AIM=40"}),
    ] {
        watcher.refuses(request, "watching");
    }
    page.hold(REST, |page| page.cycles > 20);
    assert_eq!(page.socket.value("V"), Some(5.0));
    let pressed = Instant::now();
    watcher
        .socket
        .does(json!({"do": "event", "event": "key 0x0D"}));
    // Nobody waits for the driver's agreement, nor for its signs.
    page.hold(AHEAD, is_left);
    let took = pressed.elapsed();
    assert_eq!(page.socket.status["outcome"]["how"], "emergency");
    assert_eq!(bench.bus.stiff(), ALL, "it holds in an emergency");
    let stopped_in = page.socket.robot["stopped_in"].as_f64();
    let stopped_in = stopped_in.expect("it was measured");
    assert!(
        stopped_in > 0.0 && stopped_in < took.as_secs_f64() * 1000.0,
        "{stopped_in} ms of {took:?}"
    );
    assert_eq!(page.socket.value("V"), Some(5.0));
}

/// Each request of a flood waits for the hub; the stop does not.
#[test]
fn the_emergency_stop_overtakes_a_flood_of_twenty_watchers() {
    let mut bench = Bench::new("flood", STEERED, PATIENT);
    let mut page = bench.driven();
    let mut watchers: Vec<Page> = (0..20).map(|_| bench.watcher()).collect();
    for watcher in &mut watchers {
        for _ in 0..100 {
            watcher.socket.say(r#"{"do":"hover","at":[3,3]}"#);
        }
    }
    let stop = r#"{"do":"event","event":"key 0x0D"}"#;
    watchers[19].socket.say(stop);
    page.hold(AHEAD, is_left);
    assert_eq!(page.socket.status["outcome"]["how"], "emergency");
    assert_eq!(bench.bus.stiff(), ALL);
    let stopped_in = page.socket.robot["stopped_in"].as_f64();
    // A cycle of 20 ms; the machine of a test may be busy.
    assert!(stopped_in.is_some_and(|it| it < 500.0), "{stopped_in:?} ms");
}

#[test]
fn the_robot_is_handed_over_and_taken_from_a_page_that_is_gone() {
    let bench = Bench::new("lease", STEERED, PATIENT);
    let mut page = bench.driven();
    let mut other = bench.watcher();
    other.socket.does(json!({"do": "take"}));
    page.hold(REST, |page| page.robot["asked"] == true);
    assert_eq!(page.socket.robot["driver"], true);
    page.socket.does(json!({"do": "give"}));
    other.until(|page| page.robot["driver"] == true && page.robot["stage"] == "paused");
    page.until(|page| page.robot["driver"] == false);
    page.refuses(
        json!({"do": "drive", "press": 90, "sticks": AHEAD}),
        "watching",
    );
    let cycles = other.socket.cycles;
    other.hold(REST, |page| page.cycles > cycles + 3);
    drop(other);
    page.until(|page| page.robot["held"] == false);
    page.socket.does(json!({"do": "take"}));
    page.until(|page| page.robot["driver"] == true && page.robot["stage"] == "paused");
    let cycles = page.socket.cycles;
    page.hold(REST, |page| page.cycles > cycles + 3);
}

#[test]
fn a_short_silence_pauses_the_robot_until_a_new_press() {
    let mut bench = Bench::new("pause", STEERED, "driver_silence = [0.3, 600, 600]");
    let mut page = bench.driven();
    page.hold(AHEAD, |page| page.value("V") == Some(10.0));
    page.until(|page| page.robot["stage"] == "paused");
    let (cycles, press) = (page.socket.cycles, page.press);
    // The page is back, and its button was held all the time.
    for _ in 0..20 {
        page.sign(press, AHEAD);
        page.socket.next_soon();
    }
    page.socket.does(json!({"do": "pause"}));
    assert_eq!(page.socket.cycles, cycles, "it holds");
    assert_eq!(page.socket.robot["stage"], "paused");
    assert_eq!(bench.bus.stiff(), ALL);
    page.press += 1;
    page.hold(REST, |page| {
        page.cycles > cycles + 10 && page.value("V") == Some(5.0)
    });
    // A released button pauses it as well.
    page.sign(0, AHEAD);
    page.until(|page| page.robot["stage"] == "paused");
    assert_eq!(page.socket.status["playing"], false);
}

/// A pause has no records. The trace is that of any run: `tip view` shows it beside a simulated one.
#[test]
fn a_served_run_is_traced_and_its_servos_are_counted() {
    let mut bench = Bench::new("trace", STEERED, PATIENT);
    let mut page = bench.driven();
    page.hold(AHEAD, |page| page.robot["bus"].as_f64() > Some(0.0));
    let [bus, period] = ["bus", "period"].map(|it| page.socket.robot[it].as_f64());
    // Three servos at 1 Mbaud; a busy machine adds to it.
    assert!(
        bus < period && period == Some(20.0),
        "{bus:?} of {period:?}"
    );
    bench.bus.with(|bus| bus.unplug(2));
    // A busy machine misses answers of all.
    page.hold(REST, |page| {
        let [one, other] =
            [0, 1].map(|servo| page.robot["servos"][servo]["missing"].as_u64().unwrap_or(0));
        other > one + 2
    });
    bench.bus.with(|bus| bus.plug(2));
    page.sign(0, REST);
    page.until(|page| page.robot["stage"] == "paused");
    assert!(!bench.folder.has("real.jsonl"), "it is not complete");
    page.hold(REST, |page| page.robot["stage"] == "driven");
    page.socket.does(json!({"do": "event", "event": "halt"}));
    page.hold(REST, is_left);
    assert_eq!(bench.server.end(), Some(130));
    let trace = bench.folder.read("real.jsonl");
    let records: Vec<Value> = trace
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    let (last, cycles) = records.split_last().expect("records");
    assert_eq!(
        (&last["end"], last["cycles"].as_u64()),
        (&json!("EXIT"), Some(cycles.len() as u64))
    );
    assert_eq!(page.socket.cycles, cycles.len() as u64);
    for (number, record) in (0..).zip(cycles) {
        assert_eq!(record["cycle"], number);
        assert_eq!(
            record["angles"][0].as_array().map(Vec::len),
            Some(3),
            "{record}"
        );
    }
    let simulate = [
        "run",
        "p.prg",
        "--robot",
        "robot.toml",
        "--quiet",
        "--halt",
        "9",
    ];
    let traced = [
        "--sensor", "VR1=10@0", "--sensor", "VR2=5@0", "--sensor", "VR3=5@0",
    ];
    let to = ["--trace-motion", "--trace", "simulated.jsonl"];
    bench
        .folder
        .tip(&[&simulate[..], &traced, &to].concat())
        .expect(0);
    let view = [
        "view",
        "real.jsonl",
        "simulated.jsonl",
        "--program",
        "p.prg",
    ];
    let to = ["--robot", "robot.toml", "-o", "both.html"];
    bench.folder.tip(&[&view[..], &to].concat()).expect(0);
    assert!(bench.folder.has("both.html"));
    let compare = ["compare", "simulated.jsonl", "real.jsonl"];
    let of = ["--program", "p.prg", "--robot", "robot.toml"];
    let compared = bench.folder.tip(&[&compare[..], &of].concat()).expect(0);
    assert!(compared.out.contains("real.jsonl"), "{compared:#?}");
}

#[test]
fn a_longer_silence_asks_the_program_to_halt_with_sticks_at_rest() {
    let mut bench = Bench::new("halt", STEERED, "driver_silence = [0.3, 0.9, 600]");
    let mut page = bench.driven();
    page.hold(AHEAD, |page| page.value("V") == Some(10.0));
    page.until(is_left);
    assert_eq!(page.socket.status["outcome"]["how"], "EXIT");
    assert_eq!(page.socket.value("V"), Some(5.0), "the last value");
    assert_eq!(bench.bus.stiff(), [] as [u8; 0], "it relaxes at the end");
}

#[test]
fn a_page_that_is_closed_is_silent() {
    let mut bench = Bench::new("closed", STEERED, "driver_silence = [0.3, 0.9, 600]");
    let mut page = bench.driven();
    let mut watcher = bench.watcher();
    page.hold(AHEAD, |page| page.value("V") == Some(10.0));
    drop(page);
    watcher.until(is_left);
    assert_eq!(watcher.socket.status["outcome"]["how"], "EXIT");
    assert_eq!(bench.bus.stiff(), [] as [u8; 0]);
}

#[test]
fn the_longest_silence_is_an_emergency() {
    let mut bench = Bench::new("alone", DEAF, "driver_silence = [0.3, 0.6, 0.9]");
    let mut page = bench.driven();
    page.until(is_left);
    assert_eq!(page.socket.status["outcome"]["how"], "emergency");
    assert_eq!(bench.bus.stiff(), ALL, "it holds in an emergency");
}

#[test]
fn a_bench_runs_without_the_button_and_is_stopped_without_the_page() {
    let more = "hold_to_drive = false\ndriver_silence = [0.3, 0.9, 600]";
    let mut bench = Bench::new("bench", STEERED, more);
    let mut page = bench.driver();
    page.hold(REST, |page| page.robot["phase"] == "running");
    let begin = Instant::now();
    // Nobody presses, and the page is there.
    let cycles = page.socket.cycles;
    while page.socket.cycles < cycles + 60 {
        assert!(begin.elapsed() < PATIENCE, "{}", page.socket.robot);
        page.sign(0, AHEAD);
        page.socket.next_soon();
    }
    assert_eq!(page.socket.value("V"), Some(10.0));
    page.until(is_left);
    assert_eq!(page.socket.status["outcome"]["how"], "EXIT");
    assert_eq!(bench.bus.stiff(), [] as [u8; 0]);
}

/// The way takes 20 s.
#[test]
fn on_the_way_to_the_first_posture_the_button_is_needed_and_the_stop_counts() {
    let more = format!("start = 2\n{PATIENT}");
    let mut bench = Bench::beside("approach", STEERED, &more, 40.0, Stdio::null());
    let mut page = bench.driver();
    let from = bench.position(0);
    page.hold(REST, |page| page.robot["phase"] == "approach");
    page.hold(REST, |page| {
        page.robot["servos"][0]["angle"].as_f64() < Some(39.0)
    });
    assert_eq!(bench.bus.stiff(), ALL);
    page.sign(0, REST);
    page.until(|page| page.robot["stage"] == "paused");
    let paused = bench.position(0);
    for _ in 0..20 {
        page.sign(0, REST);
        page.socket.next_soon();
    }
    let moved = (bench.position(0) - paused).abs();
    assert!(
        moved < 5.0 && paused < from,
        "{moved} of 4096 counts a turn"
    );
    let mut watcher = bench.watcher();
    watcher
        .socket
        .does(json!({"do": "event", "event": "key 0x0D"}));
    watcher.until(is_left);
    assert_eq!(bench.bus.stiff(), ALL, "it holds in an emergency");
    assert!((bench.position(0) - paused).abs() < 60.0);
    assert!(page.socket.messages.is_empty());
}

#[test]
fn nobody_on_the_way_to_the_first_posture_ends_it() {
    for (silence, stiff) in [("[0.3, 0.6, 600]", &[][..]), ("[0.3, 0.6, 0.6]", &ALL)] {
        let more = format!("start = 2\ndriver_silence = {silence}");
        let name = format!("approach-{}", stiff.len());
        let mut bench = Bench::beside(&name, STEERED, &more, 40.0, Stdio::null());
        let mut page = bench.driver();
        page.hold(REST, |page| page.robot["phase"] == "approach");
        page.until(is_left);
        assert_eq!(bench.bus.stiff(), stiff, "{silence}");
    }
}

#[test]
fn the_key_of_the_terminal_starts_and_stops_the_robot() {
    let pty = Pty::new();
    let mut bench = Bench::beside("terminal", STEERED, PATIENT, 0.5, pty.input());
    let mut page = bench.driver();
    // What is typed before the robot is ready is forgotten.
    page.until(|page| page.robot["servos"][2]["temperature"].is_number());
    pty.press(b'\r');
    page.until(|page| page.robot["phase"] == "approach");
    page.hold(REST, |page| page.cycles > 3);
    assert_eq!(bench.bus.stiff(), ALL);
    pty.press(b'\r');
    page.hold(REST, is_left);
    assert_eq!(page.socket.status["outcome"]["how"], "emergency");
    assert_eq!(bench.bus.stiff(), ALL, "it holds in an emergency");
}

#[test]
fn what_cannot_be_driven_is_refused_before_anything_moves() {
    let folder = Folder::new("serve-drive-not")
        .file("robot.toml", leg("relax", "hold", "temperature = 95"))
        .program("one.prg", "DEF_VAR V\nAD_IN VR1 V\nEND")
        .program("p.prg", STEERED);
    let hardware = ["serve", "one.prg", "--hardware", "robot.toml"];
    let outcome = folder.tip(&[&hardware[..], &["--port", "simulated"]].concat());
    let outcome = outcome.expect(1);
    assert!(outcome.err.contains("one.prg:4"), "{outcome:?}");
    let hardware = ["serve", "p.prg", "--hardware", "robot.toml"];
    folder.tip(&hardware).expect(1);
    for more in [
        &["--paused"][..],
        &["--cycles", "9"],
        &["--robot", "titan8"],
        &["--plant", "dynamic"],
    ] {
        folder.tip(&[&hardware[..], more].concat()).expect(2);
    }
    folder
        .tip(&["serve", "p.prg", "--port", "simulated"])
        .expect(2);
    let trace = ["--port", "simulated", "--trace", "missing/real.jsonl"];
    let outcome = folder.tip(&[&hardware[..], &trace].concat()).expect(1);
    let said = "error: cannot write missing/real.jsonl";
    assert!(
        outcome.err.contains(said) && outcome.out.is_empty(),
        "{outcome:?}"
    );
    let servers = Server::begin(
        &folder,
        &[&hardware[1..], &["--port", "simulated:overheat=2@0.2"]].concat(),
    );
    let mut page = servers.viewer();
    page.until(|page| page.robot["phase"] == "ready");
    // The alarm of a servo is shown at it.
    page.until(|page| page.robot["servos"][1]["problem"].is_string());
    let problems = [0, 1, 2].map(|servo| page.robot["servos"][servo]["problem"].to_string());
    assert!(
        problems[1].contains("J12 (servo 2) has the alarm"),
        "{problems:?}"
    );
    assert_eq!([&*problems[0], &problems[2]], ["null"; 2]);
    drop(page);
    assert_eq!(servers.end(), Some(130));
}

#[test]
fn a_simulated_robot_has_no_driver() {
    let server = Server::begin(&super::counts("serve-no-driver"), &["counts.prg"]);
    let mut viewer = server.viewer();
    for request in [
        json!({"do": "take"}),
        json!({"do": "give"}),
        json!({"do": "drive", "press": 1, "sticks": REST}),
    ] {
        let answer = viewer.ask(request);
        assert_eq!(answer["error"], "simulated");
    }
}
