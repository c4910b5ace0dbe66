//! `tip drives record`: motions that are taught by hand, and played by the servos that were turned.

use crate::faults::terminal::Pty;
use crate::serve::client::Socket as Viewer;
use crate::servo_bus::{ServoBus, described};
use crate::support::{Folder, Outcome, start};
use crate::torque::{leg, signal, two_legs};
use rustix::process::Signal;
use serde_json::json;
use std::io::Read;
use std::process::Child;
use std::sync::mpsc::{Receiver, channel};
use std::thread::spawn;
use std::time::Duration;
use tip_drives::Model;

const RETURN: u8 = 0x0D;
const ESCAPE: u8 = 0x1B;
const CONTROL_C: u8 = 0x03;
/// The longest time until it says something.
const PATIENCE: Duration = Duration::from_secs(60);

/// `tip drives record` before a terminal, while a hand turns the joints.
struct Lesson {
    child: Child,
    pty: Pty,
    terminal: String,
    said: Receiver<Vec<u8>>,
    text: String,
}

impl Lesson {
    /// Starts it, and waits for its question.
    fn start(folder: &Folder, bus: &ServoBus, options: &[&str]) -> Self {
        let pty = Pty::new();
        let record = ["drives", "record", "robot.toml", "--port", bus.port()];
        let mut command = folder.command(&[&record[..], options].concat());
        let mut child = start(&mut command, pty.input());
        let (sender, said) = channel();
        let mut error = child.stderr.take().expect("piped");
        // It is read all the time: the pose is shown again and again.
        spawn(move || {
            let mut bytes = [0; 4096];
            while let Ok(count @ 1..) = error.read(&mut bytes) {
                if sender.send(bytes[..count].to_vec()).is_err() {
                    return;
                }
            }
        });
        Lesson {
            child,
            terminal: pty.behaviour(),
            pty,
            said,
            text: String::new(),
        }
    }

    /// Starts it, and begins.
    fn begin(folder: &Folder, bus: &ServoBus, options: &[&str]) -> Self {
        let mut lesson = Lesson::start(folder, bus, options);
        lesson.says("RETURN begins: ");
        lesson.pty.press(b'\n');
        lesson.says("SPACE ");
        lesson
    }

    /// Waits until it says something more, and returns the text up to there.
    fn says(&mut self, what: &str) -> String {
        while !self.text.contains(what) {
            let Ok(bytes) = self.said.recv_timeout(PATIENCE) else {
                panic!("{what:?} is missing: {}", self.text);
            };
            self.text += &String::from_utf8_lossy(&bytes);
        }
        let end = self.text.find(what).map_or(0, |at| at + what.len());
        self.text.drain(..end).collect()
    }

    /// Presses a key, and waits for the answer.
    fn press(&mut self, key: u8, answer: &str) {
        self.pty.press(key);
        self.says(answer);
    }

    /// Presses keys one after the other.
    fn types(&self, keys: &str) {
        keys.bytes().for_each(|key| self.pty.press(key));
    }

    /// Waits for its end; the terminal is as it was.
    fn ends(mut self) -> Outcome {
        let mut outcome = Outcome::of(self.child.wait_with_output().expect("it ends"));
        while let Ok(bytes) = self.said.recv() {
            self.text += &String::from_utf8_lossy(&bytes);
        }
        outcome.err = self.text;
        assert_eq!(self.pty.behaviour(), self.terminal, "{outcome:#?}");
        outcome
    }
}

/// Turns joints of a description to angles, deg.
fn turn_to(bus: &mut ServoBus, robot: &str, angles: &[f64]) {
    let description = described(robot);
    let drives = &description.bus().expect("a bus").drives;
    bus.with(|bus| {
        for (drive, angle) in drives.iter().zip(angles) {
            let model = Model::named(&drive.model).expect("checked");
            let goal = drive.sign * drive.gear * angle + drive.offset;
            let own = bus.servos().iter().find(|servo| servo.id() == drive.id);
            let now = model.angle(own.expect("on the bus").position());
            bus.turn(drive.id, goal - now);
        }
    });
}

/// Returns the angles of the joints of a description, deg.
fn angles(bus: &mut ServoBus, robot: &str) -> Vec<f64> {
    let description = described(robot);
    let drives = &description.bus().expect("a bus").drives;
    bus.with(|bus| {
        let angle = |drive: &tipc::description::Drive| {
            let model = Model::named(&drive.model).expect("checked");
            let own = bus.servos().iter().find(|servo| servo.id() == drive.id);
            let motor = model.angle(own.expect("on the bus").position());
            (motor - drive.offset) / (drive.sign * drive.gear)
        };
        drives.iter().map(angle).collect()
    })
}

/// The poses are counts of servos (4096 in a turn), rounded to tenths: 512 counts are 45 deg. The lowest speed is that of `start`, the
/// highest that of the drives, so that the time between the keys does not count.
#[test]
fn poses_become_a_program_that_a_person_would_write() {
    let robot = leg("hold", "hold", "start = 150").replace("id = ", "speed = 150\nid = ");
    let folder = Folder::new("record-poses").file("robot.toml", &robot);
    let mut bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
    turn_to(&mut bus, &robot, &[-45.0, 20.0, 0.04]);
    lesson.press(b' ', "pose 1 is added\n");
    turn_to(&mut bus, &robot, &[45.0, 20.0, -12.3]);
    lesson.press(b' ', "pose 2 is added\n");
    lesson.press(b' ', "pose 3 is added\n");
    lesson.press(b'd', "pose 3 is deleted\n");
    lesson.pty.press(b'q');
    let outcome = lesson.ends().expect(0);
    assert_eq!(
        outcome.out,
        "wave.prg has the motion now; it was tried in simulation. Number of set points: 2\n"
    );
    let written = folder.read("wave.prg");
    // The way to pose 2 is 90 deg; a joint takes 0.6 s at 150 deg/s and 0.417 s to speed up and to slow down at 360 deg/s².
    let expected = "3.2
Taught by hand: 2 poses
DEF_JOINT POSE1_F1
DEF_JOINT POSE2_F1
TIP_SPEED_UP 255  // all legs set off in one cycle

POSE1_F1.J1 = -45 ; POSE1_F1.J2 = 20 ; POSE1_F1.J3 = 0

POSE2_F1.J1 = 45 ; POSE2_F1.J2 = 20 ; POSE2_F1.J3 = -12.3

SET_OMEGA_MAX ALL 150  // slowly to the first pose
PTP_ANGLE F1 POSE1_F1
WAIT_INPOS ALL

SET_OMEGA_MAX ALL 150  // 1.0 s
PTP_ANGLE F1 POSE2_F1
WAIT_INPOS ALL
END
";
    assert_eq!(written, expected);
    assert!(bus.stiff().is_empty());
    let check = [
        "check",
        "wave.prg",
        "--robot",
        "robot.toml",
        "--deny",
        "warnings",
    ];
    folder.tip(&check).expect(0);
    folder
        .tip(&["fmt", "--check", "wave.prg", "--robot", "robot.toml"])
        .expect(0);
}

/// What a hand has shown, servos repeat: within the steps of their positions, the rounding and the tolerance of a position.
#[test]
fn what_was_taught_is_played() {
    for model in ["AX-12", "STS3215", "XL430-W250"] {
        let robot = leg("hold", "hold", "start = 90").replace("STS3215", model);
        let folder = Folder::new(&format!("record-played-{model}")).file("robot.toml", &robot);
        let mut bus = ServoBus::of(&robot, 0.0);
        let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
        let last = [33.3, -21.7, 48.2];
        for (number, pose) in [[10.0, -40.0, 60.0], last].iter().enumerate() {
            turn_to(&mut bus, &robot, pose);
            lesson.press(b' ', &format!("pose {} is added\n", number + 1));
        }
        lesson.pty.press(ESCAPE);
        lesson.ends().expect(0);
        assert!(bus.stiff().is_empty(), "{model}");
        turn_to(&mut bus, &robot, &[0.0; 3]);
        let run = [
            "run",
            "wave.prg",
            "--hardware",
            "robot.toml",
            "--yes",
            "--port",
            bus.port(),
        ];
        folder.tip(&run).expect(0);
        assert_eq!(bus.stiff(), [1, 2, 3], "{model}: at_end holds");
        for (played, taught) in angles(&mut bus, &robot).into_iter().zip(last) {
            // 300 deg / 1024 of an AX-12 at each reading and command, and its compliance.
            assert!(
                (played - taught).abs() < 1.5,
                "{model}: {played} for {taught}"
            );
        }
    }
}

/// A joint at a constant speed needs its ends only; all samples are within the error, on a program that passes every check.
#[test]
fn a_motion_becomes_few_set_points() {
    let robot = leg("hold", "hold", "").replace("id = ", "speed = 60\nid = ");
    let folder = Folder::new("record-motion").file("robot.toml", &robot);
    let mut bus = ServoBus::of(&robot, 0.0);
    turn_to(&mut bus, &robot, &[-30.0, 10.0, 20.0]);
    let options = ["-o", "wave.prg", "--continuous", "--error", "2"];
    let mut lesson = Lesson::begin(&folder, &bus, &options);
    lesson.press(b' ', "the motion is being recorded\n");
    // The line of the pose shows where the joints are, and the first one of a motion has its first sample.
    lesson.says(": -30  10  20");
    for joint in [-20, -10, 0, 10, 20, 30] {
        turn_to(&mut bus, &robot, &[f64::from(joint), 10.0, 20.0]);
        lesson.says(&format!("{joint:4}  10  20"));
    }
    lesson.pty.press(b' ');
    let outcome = lesson.ends().expect(0);
    assert!(bus.stiff().is_empty(), "{outcome:#?}");
    // The hand of this test takes no time.
    let fast = "deg/s, and its drive turns at 60 at most: it will lag behind there\n";
    assert!(outcome.err.contains(fast), "{outcome:#?}");
    let written = folder.read("wave.prg");
    let points: Vec<&str> = written
        .lines()
        .filter(|line| line.starts_with("PTP_ANGLE"))
        .collect();
    assert_eq!(points.first(), Some(&"PTP_ANGLE F1 -30 10 20"), "{written}");
    assert_eq!(
        points.last(),
        Some(&"PTP_ANGLE HS F1 30 10 20"),
        "{written}"
    );
    assert!(
        !written.contains("J12") && !written.contains("J13"),
        "{written}"
    );
    let check = [
        "check",
        "wave.prg",
        "--robot",
        "robot.toml",
        "--deny",
        "warnings",
    ];
    folder.tip(&check).expect(0);
    folder
        .tip(&["fmt", "--check", "wave.prg", "--robot", "robot.toml"])
        .expect(0);
    turn_to(&mut bus, &robot, &[0.0; 3]);
    let run = ["run", "wave.prg", "--hardware", "robot.toml", "--yes"];
    folder
        .tip(&[&run[..], &["--port", bus.port()]].concat())
        .expect(0);
    for (played, taught) in angles(&mut bus, &robot).into_iter().zip([30.0, 10.0, 20.0]) {
        assert!((played - taught).abs() < 1.0, "{played} for {taught}");
    }
}

/// A servo that is away for longer than a run allows ends nothing; a motion has no sample of that time.
#[test]
fn a_motion_has_no_sample_without_each_servo() {
    let robot = leg("hold", "hold", "")
        .replace("latency = 400", "latency = 20")
        .replace("silence = 200", "silence = 20");
    let folder = Folder::new("record-away").file("robot.toml", &robot);
    let mut bus = ServoBus::of(&robot, 0.0);
    turn_to(&mut bus, &robot, &[-30.0, 10.0, 20.0]);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg", "--continuous"]);
    lesson.press(b' ', "the motion is being recorded\n");
    lesson.says(": -30  10  20");
    bus.with(|bus| bus.unplug(2));
    turn_to(&mut bus, &robot, &[60.0]);
    lesson.says("  60   ?  20");
    turn_to(&mut bus, &robot, &[40.0]);
    lesson.says("  40   ?  20");
    bus.with(|bus| bus.plug(2));
    lesson.says("  40  10  20");
    // The port is told, though the servo was silent before.
    bus.hang_up();
    let outcome = lesson.ends().expect(1);
    assert!(outcome.err.contains("the port is gone"), "{outcome:#?}");
    let written = folder.read("wave.prg");
    assert!(written.contains("PTP_ANGLE HS F1 40 10 20\n"), "{written}");
    assert!(!written.contains("F1 60 "), "{written}");
}

/// A servo that has gone is no pose, even though it had an angle before; nor is a joint that moves, or is where it must not be.
#[test]
fn a_pose_that_is_not_certain_is_not_added() {
    let robot = leg("hold", "hold", "").replace("latency = 400", "latency = 20");
    let folder = Folder::new("record-stale").file("robot.toml", &robot);
    let mut bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
    lesson.press(b'd', "there is no pose yet\n");
    bus.with(|bus| bus.unplug(2));
    lesson.press(
        b' ',
        "J12 (servo 2) gave no two equal positions in a row: keep the joint still",
    );
    bus.with(|bus| bus.plug(2));
    turn_to(&mut bus, &robot, &[0.0, 0.0, 95.0]);
    lesson.press(b' ', "J13 (servo 3) is at 95.0 deg, outside of -90 to 90");
    lesson.press(b'm', "no mirror image: leg F1 has no leg on the other side");
    lesson.press(b'q', "nothing was recorded; wave.prg is not written\n");
    lesson.ends().expect(1);
    assert_eq!(folder.names(), ["robot.toml"]);
}

/// Two legs of a yaw and a roll about x. The image changes their places. Of a leg that is drawn mirrored, equal angles are mirrored
/// postures; one that is turned round has the opposite ones, because a turn to the left is one to the front on the right only.
#[test]
fn the_mirror_image_of_a_pose_is_added() {
    for (other, image) in [
        (
            "mirror = \"x\"",
            ["30 ; POSE2_F1.J2 = 40", "10 ; POSE2_F2.J2 = 20"],
        ),
        (
            "turn = 180",
            ["-30 ; POSE2_F1.J2 = -40", "-10 ; POSE2_F2.J2 = -20"],
        ),
    ] {
        let drives: String = (1..)
            .zip(["11", "12", "21", "22"])
            .map(|(id, joint)| format!("[[drive]]\njoint = \"J{joint}\"\nid = {id}\n"))
            .collect();
        let robot = format!(
            "name = \"two\"
joint = [
    {{ axis = \"z\", link = [50, 0, 0], limits = [-90, 90] }},
    {{ axis = \"x\", link = [100, 0, 0], limits = [-90, 45] }},
]
leg = [{{ base = [-80, 0, 0], {other} }}, {{ base = [80, 0, 0] }}]
[bus]
servo = \"STS3215\"
latency = 400
silence = 200
{drives}"
        );
        let folder = Folder::new("record-mirror").file("robot.toml", &robot);
        let mut bus = ServoBus::of(&robot, 0.0);
        let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
        turn_to(&mut bus, &robot, &[10.0, 20.0, 30.0, 40.0]);
        lesson.press(b' ', "pose 1 is added\n");
        lesson.press(b'm', "pose 2 is added\n");
        turn_to(&mut bus, &robot, &[10.0, 20.0, 30.0, -60.0]);
        if image[0].starts_with('-') {
            let said = "not added: J12 would be at 60.0 deg, outside of -90 to 45\n";
            lesson.press(b'm', said);
        }
        lesson.pty.press(b'q');
        lesson.ends().expect(0);
        let written = folder.read("wave.prg");
        let values: Vec<&str> = written
            .lines()
            .filter(|line| line.contains(".J1 = "))
            .collect();
        let image = [1, 2].map(|leg| format!("POSE2_F{leg}.J1 = {}", image[leg - 1]));
        assert_eq!(
            values,
            [
                "POSE1_F1.J1 = 10 ; POSE1_F1.J2 = 20",
                "POSE1_F2.J1 = 30 ; POSE1_F2.J2 = 40",
                &image[0],
                &image[1],
            ]
        );
    }
}

/// A table of four legs that lifts the two on its right.
#[test]
fn what_goes_wrong_in_simulation_is_said() {
    let drives: String = (1..=4)
        .map(|leg| format!("[[drive]]\njoint = \"J{leg}1\"\nid = {leg}\n"))
        .collect();
    let robot = format!(
        "name = \"table\"
joint = [{{ axis = \"y\", link = [0, 0, -100], limits = [-90, 90] }}]
leg = [
    {{ base = [-80, 100, 0] }},
    {{ base = [-80, -100, 0] }},
    {{ base = [80, 100, 0] }},
    {{ base = [80, -100, 0] }},
]
[body]
x = [-80, 80]
y = [-100, 100]
z = [-20, 20]
mass = 2
[bus]
servo = \"STS3215\"
latency = 400
silence = 200
{drives}"
    );
    let folder = Folder::new("record-falls").file("robot.toml", &robot);
    let mut bus = ServoBus::of(&robot, 0.0);
    turn_to(&mut bus, &robot, &[0.0, 0.0, -80.0, -80.0]);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
    lesson.press(b' ', "pose 1 is added\n");
    lesson.press(b'q', "in simulation this happens:\nwarning: the robot ");
    let outcome = lesson.ends().expect(0);
    assert!(outcome.err.contains("would fall"), "{outcome:#?}");
    assert!(folder.has("wave.prg"));
}

/// Nothing is lost, and nothing is half written, whatever ends it.
#[test]
fn every_end_writes_what_there_is() {
    for (end, status) in [("key", 130), ("SIGTERM", 143), ("unplugged", 1)] {
        let robot = leg("hold", "hold", "");
        let folder = Folder::new(&format!("record-{end}")).file("robot.toml", &robot);
        let mut bus = ServoBus::of(&robot, 0.0);
        let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
        // RETURN stops nothing where there is no torque.
        lesson.pty.press(RETURN);
        lesson.press(b' ', "pose 1 is added\n");
        match end {
            "key" => lesson.pty.press(CONTROL_C),
            "SIGTERM" => signal(&lesson.child, Signal::TERM),
            _ => bus.hang_up(),
        }
        let outcome = lesson.ends().expect(status);
        assert!(
            outcome.out.contains("Number of set points: 1\n"),
            "{end}: {outcome:#?}"
        );
        assert!(
            folder.read("wave.prg").ends_with("WAIT_INPOS ALL\nEND\n"),
            "{end}"
        );
        assert_eq!(folder.names(), ["robot.toml", "wave.prg"], "{end}");
        assert!(bus.stiff().is_empty(), "{end}");
    }
}

/// A robot that holds itself is not dropped without a word.
#[test]
fn stiff_servos_are_relaxed_after_a_key() {
    let robot = leg("hold", "hold", "");
    let folder = Folder::new("record-stiff").file("robot.toml", &robot);
    let folder = folder.program("p.prg", "END");
    let mut bus = ServoBus::of(&robot, 0.5);
    let run = [
        "run",
        "p.prg",
        "--hardware",
        "robot.toml",
        "--yes",
        "--port",
        bus.port(),
    ];
    folder.tip(&run).expect(0);
    assert_eq!(bus.stiff(), [1, 2, 3]);
    for (answer, status, left) in [("no\n", 1, &[1, 2, 3][..]), ("\n", 1, &[])] {
        let mut lesson = Lesson::start(&folder, &bus, &["-o", "wave.prg"]);
        lesson.says("J11 (servo 1), J12 (servo 2), J13 (servo 3). Support the robot; RETURN switches their torque off: ");
        assert_eq!(bus.stiff(), [1, 2, 3]);
        for byte in answer.bytes() {
            lesson.pty.press(byte);
        }
        if status == 1 && answer == "\n" {
            lesson.says("SPACE ");
            lesson.pty.press(b'q');
        }
        let outcome = lesson.ends().expect(status);
        let said = "nothing was recorded; wave.prg is not written\n";
        assert!(outcome.err.contains(said), "{outcome:#?}");
        assert_eq!(bus.stiff(), left);
        assert!(!folder.has("wave.prg"));
    }
}

#[test]
fn what_cannot_be_recorded_is_refused_first() {
    let robot = leg("hold", "hold", "port = \"simulated\"");
    let folder = Folder::new("record-refused").file("robot.toml", &robot);
    let folder = folder.file("wave.prg", "mine");
    let folder = folder.file("old.prg", "3.1\nold\nALL_STOP\nEND\n");
    let folder = folder.file("new.prg", "3.2\nnew\nALL_STOP\nEND\n");
    let record = ["drives", "record", "robot.toml", "-o"];
    let tip = |more: &[&str], status: i32| {
        let pty = Pty::new();
        let mut command = folder.command(&[&record[..], more].concat());
        let output = command.stdin(pty.input()).output().expect("tip starts");
        Outcome::of(output).expect(status).err
    };
    let said = tip(&["wave.prg"], 1);
    assert_eq!(
        said,
        "error: wave.prg exists: --at end adds to it, --force replaces it, -o takes another name\n"
    );
    let said = tip(&["wave.prg", "--at", "end"], 1);
    assert!(said.contains("Wrong version number"), "{said}");
    let said = tip(&["old.prg", "--at", "end"], 1);
    let migrate = "`tip migrate --to 3.2` rewrites it\n";
    assert!(
        said.contains("of edition 3.1") && said.ends_with(migrate),
        "{said}"
    );
    let said = tip(&["new.prg", "--at", "6"], 1);
    assert_eq!(
        said,
        "error: new.prg has no place at line 6: its END is in line 4\n"
    );
    let said = tip(&["new.prg", "--at", "2"], 2);
    assert!(
        said.contains(
            "`2` is no place in a program: give the number of a line from 3 on, or `end`"
        ),
        "{said}"
    );
    let said = tip(&["-", "--at", "end"], 2);
    let name = "--at adds to a program in a file: give its name after -o\n";
    assert!(said.contains(name), "{said}");
    let protect = |is_protected: bool| {
        let file = folder.path("new.prg");
        let mut permissions = std::fs::metadata(&file).expect("there").permissions();
        permissions.set_readonly(is_protected);
        std::fs::set_permissions(&file, permissions).expect("ours");
    };
    protect(true);
    let said = tip(&["new.prg", "--at", "end"], 1);
    assert!(said.starts_with("error: cannot write new.prg"), "{said}");
    protect(false);
    let said = tip(&["other.prg", "--listen", "192.0.2.1:80"], 1);
    assert!(said.starts_with("error: 192.0.2.1:80: "), "{said}");
    let said = tip(&["none.prg", "--at", "end"], 1);
    assert!(said.contains("none.prg"), "{said}");
    let said = tip(&["robot.toml", "--force"], 1);
    assert!(
        said.contains("this is robot.toml, which is being read"),
        "{said}"
    );
    let said = tip(&["missing/wave.prg"], 1);
    assert!(
        said.starts_with("error: cannot write missing/wave.prg"),
        "{said}"
    );
    let said = tip(&["other.prg", "--continuous", "--error", "0.1"], 2);
    assert!(
        said.contains("`0.1` is no error that a motion can have: give 0.2 to 45 deg"),
        "{said}"
    );
    let said = folder
        .tip(&[&record[..], &["other.prg"]].concat())
        .expect(1)
        .err;
    assert_eq!(said, "error: this needs a terminal with a keyboard\n");
    assert_eq!(folder.read("wave.prg"), "mine");
    let names = ["new.prg", "old.prg", "robot.toml", "wave.prg"];
    assert_eq!(folder.names(), names);
}

/// Poses have names, in the order in which they were added; a name that the program could not have is refused.
#[test]
fn poses_are_chosen_named_and_deleted() {
    let robot = leg("hold", "hold", "");
    let folder = Folder::new("record-names").file("robot.toml", &robot);
    let mut bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
    for key in [b'n', b'd', b'g', b'p', b'<'] {
        lesson.press(key, "there is no pose yet\n");
    }
    for (number, joint) in [(1, 10.0), (2, 20.0), (3, 30.0)] {
        turn_to(&mut bus, &robot, &[joint, 0.0, 0.0]);
        lesson.press(b' ', &format!("pose {number} is added\n"));
    }
    lesson.press(b'<', "pose 2 is chosen: POSE2\n");
    lesson.types("nwavf");
    lesson.says("name of pose 2: WAVF ");
    // The key deletes a letter.
    lesson.types("\x7fe_out\n");
    lesson.says("pose 2 is chosen: WAVE_OUT\n");
    lesson.press(b'>', "pose 3 is chosen: POSE3\n");
    lesson.press(b'>', "pose 3 is chosen: POSE3\n");
    for refused in ["Wave_Out", "3up"] {
        lesson.types(&format!("n{refused}\n"));
        let name = refused.to_uppercase();
        lesson.says(&format!("`{name}` cannot name a pose: use a letter"));
    }
    // What a name cannot hold does not vanish without a word; a character of several bytes is one.
    for (typed, name) in [
        ("u- p", "UP"),
        ("\u{6b69}ab", "AB"),
        (
            "THIRTY_LETTERS_ARE_TOO_MANY_XX",
            "THIRTY_LETTERS_ARE_TOO_MANY_X",
        ),
    ] {
        lesson.types(&format!("n{typed}\n"));
        let said = lesson.says(&format!("pose 3 is chosen: {name}\n"));
        let rings = typed.chars().count() - name.len();
        let told = "\x07a name has letters, digits and _, 29 at most\n";
        assert_eq!(said.matches(told).count(), rings, "{typed}: {said}");
    }
    lesson.types("nPOSE3\n");
    lesson.says("pose 3 is chosen: POSE3\n");
    lesson.types("n\n");
    lesson.says("pose 3 is chosen: POSE3\n");
    lesson.press(b'<', "pose 2 is chosen: WAVE_OUT\n");
    lesson.press(b'<', "pose 1 is chosen: POSE1\n");
    lesson.press(b'd', "pose 1 is deleted\n");
    lesson.pty.press(b'q');
    lesson.ends().expect(0);
    let written = folder.read("wave.prg");
    let values: Vec<&str> = written.lines().filter(|it| it.contains(".J1")).collect();
    assert_eq!(
        values,
        [
            "WAVE_OUT_F1.J1 = 20 ; WAVE_OUT_F1.J2 = 0 ; WAVE_OUT_F1.J3 = 0",
            "POSE3_F1.J1 = 30 ; POSE3_F1.J2 = 0 ; POSE3_F1.J3 = 0",
        ]
    );
    let check = ["check", "wave.prg", "--robot", "robot.toml"];
    folder.tip(&check).expect(0);
}

/// The robot goes to a pose with `start` deg/s at most, holds it, and has no torque after the key. The time with torque does not count:
/// with it, the way to the next pose would be slower than `start`.
#[test]
fn the_robot_goes_to_poses_with_torque_and_is_limp_after_a_key() {
    for at_end in ["hold", "relax"] {
        let robot = leg(at_end, "hold", "start = 90");
        let folder = Folder::new(&format!("record-goes-{at_end}")).file("robot.toml", &robot);
        let mut bus = ServoBus::of(&robot, 0.0);
        let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
        let taught = [[30.0, 20.0, -10.0], [-30.0, 0.0, 10.0]];
        for (number, pose) in (1..).zip(taught) {
            turn_to(&mut bus, &robot, &pose);
            lesson.press(b' ', &format!("pose {number} is added\n"));
        }
        lesson.press(b',', "pose 1 is chosen: POSE1\n");
        for (key, goal) in [(b'g', taught[0]), (b'p', taught[1])] {
            lesson.press(key, "move with 90 deg/s; RETURN is the emergency stop\n");
            lesson.says("r switches the torque off\n");
            assert_eq!(bus.stiff(), [1, 2, 3]);
            for (now, goal) in angles(&mut bus, &robot).into_iter().zip(goal) {
                assert!((now - goal).abs() < 0.5, "{now} for {goal}");
            }
            // Other keys move and add nothing meanwhile.
            lesson.types(" d");
            lesson.press(b'r', "the joints are free\n");
            assert!(bus.stiff().is_empty(), "{at_end}");
        }
        lesson.pty.press(b'q');
        lesson.ends().expect(0);
        assert!(bus.stiff().is_empty(), "{at_end}");
        assert!(
            folder
                .read("wave.prg")
                .starts_with("3.2\nTaught by hand: 2 poses\n")
        );
    }
}

/// While the robot holds a pose, `q` ends the lesson as ESC does: the robot is left as at an end.
#[test]
fn a_lesson_ends_while_the_robot_holds() {
    for (at_end, left) in [("hold", &[1, 2, 3][..]), ("relax", &[])] {
        let robot = leg(at_end, "hold", "start = 90");
        let folder = Folder::new(&format!("record-holds-{at_end}")).file("robot.toml", &robot);
        let mut bus = ServoBus::of(&robot, 0.0);
        let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
        lesson.press(b' ', "pose 1 is added\n");
        lesson.press(b'g', "r switches the torque off\n");
        lesson.pty.press(b'q');
        lesson.ends().expect(0);
        assert_eq!(bus.stiff(), left, "{at_end}");
        assert!(folder.has("wave.prg"), "{at_end}");
    }
}

/// A pose in which links cross is said, and the robot goes neither there nor through such a one, and gets no torque.
#[test]
fn the_robot_goes_to_no_pose_in_which_it_hits_itself() {
    let robot = two_legs([0.0, 80.0], "");
    let folder = Folder::new("record-collides").file("robot.toml", &robot);
    let folder = folder.program("p.prg", "END");
    let mut bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
    turn_to(&mut bus, &robot, &[0.0, -60.0, 0.0, 60.0]);
    lesson.press(
        b' ',
        "pose 1 is added\nin pose 1 link22 and link12 overlap by 18.0 mm",
    );
    turn_to(&mut bus, &robot, &[0.0; 4]);
    lesson.press(b'g', "link22 and link12 would overlap by ");
    lesson.says("nothing moves");
    assert!(bus.stiff().is_empty());
    lesson.press(b' ', "pose 2 is added\n");
    lesson.press(b'g', "r switches the torque off\n");
    lesson.press(b'r', "the joints are free\n");
    lesson.pty.press(b'q');
    lesson.ends().expect(0);
    // The way of a run to its first posture is judged in the same way: both ends are free, and the links cross on the way.
    turn_to(&mut bus, &robot, &[0.0, -80.0, 0.0, 0.0]);
    let run = ["run", "p.prg", "--hardware", "robot.toml", "--yes"];
    let outcome = folder.tip(&[&run[..], &["--port", bus.port()]].concat());
    let outcome = outcome.expect(1);
    assert!(outcome.err.contains("would overlap by "), "{outcome:#?}");
    assert!(bus.stiff().is_empty(), "{outcome:#?}");
}

/// A file that appears during a lesson is not replaced, and what was taught is printed.
#[test]
fn a_file_that_appears_during_a_lesson_stays() {
    let robot = leg("hold", "hold", "");
    let folder = Folder::new("record-appears").file("robot.toml", &robot);
    let bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
    lesson.press(b' ', "pose 1 is added\n");
    let folder = folder.file("wave.prg", "mine");
    lesson.pty.press(b'q');
    let outcome = lesson.ends().expect(1);
    assert_eq!(folder.read("wave.prg"), "mine");
    assert!(outcome.out.contains("DEF_JOINT POSE1_F1"), "{outcome:#?}");
}

/// On the way RETURN is the emergency stop, ESC and signals are the ordered end; the servos have the state of each, and the program is
/// written.
#[test]
fn the_way_to_a_pose_is_stopped_as_a_run_is() {
    for (end, status, left) in [
        ("RETURN", 3, &[][..]),
        ("ESC", 0, &[1, 2, 3]),
        ("SIGTERM", 143, &[1, 2, 3]),
        ("unplugged", 3, &[1, 2, 3]),
    ] {
        let robot = leg("hold", "relax", "start = 5");
        let folder = Folder::new(&format!("record-way-{end}")).file("robot.toml", &robot);
        let mut bus = ServoBus::of(&robot, 0.0);
        let mut lesson = Lesson::begin(&folder, &bus, &["-o", "wave.prg"]);
        turn_to(&mut bus, &robot, &[60.0, 0.0, 0.0]);
        lesson.press(b' ', "pose 1 is added\n");
        turn_to(&mut bus, &robot, &[0.0; 3]);
        lesson.pty.press(b'g');
        bus.await_that("J11 is on its way", |bus| {
            bus.servos()[0].position() > 2048.0 + 10.0
        });
        match end {
            "RETURN" => lesson.pty.press(RETURN),
            "ESC" => lesson.pty.press(ESCAPE),
            "SIGTERM" => signal(&lesson.child, Signal::TERM),
            _ => bus.hang_up(),
        }
        let outcome = lesson.ends().expect(status);
        assert_eq!(bus.stiff(), left, "{end}: {outcome:#?}");
        // 12 s of the way were left.
        assert!(angles(&mut bus, &robot)[0] < 30.0, "{end}");
        assert!(
            folder.read("wave.prg").contains("POSE1_F1.J1 = 60"),
            "{end}"
        );
    }
}

/// The page shows the posture that was read last. Its stop is obeyed while the robot has torque, and it does nothing else.
#[test]
fn a_page_shows_the_robot_that_is_taught() {
    let robot = leg("hold", "relax", "start = 90")
        .replace("latency = 400", "latency = 20")
        .replace("silence = 200", "silence = 20");
    let folder = Folder::new("record-page").file("robot.toml", &robot);
    let mut bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::start(&folder, &bus, &["-o", "wave.prg", "--listen"]);
    lesson.says("RETURN begins: ");
    lesson.pty.press(b'\n');
    lesson.says("http://");
    let address = format!("http://{}", lesson.says("\n").trim_end());
    let mut page = Viewer::of(&address);
    turn_to(&mut bus, &robot, &[-45.0, 20.0, 0.0]);
    // 512 and 228 of 4096 counts in a turn, in hundredths of a degree.
    page.until(|page| page.motion() == [-4500, 2004, 0]);
    page.until(|page| page.robot["servos"][0]["angle"] == -45.0);
    assert_eq!(page.robot["phase"], "limp");
    lesson.press(b' ', "pose 1 is added\n");
    page.until(|page| page.robot["poses"] == json!(["POSE1"]));
    bus.with(|bus| bus.unplug(2));
    page.until(|page| page.robot["servos"][1]["angle"].is_null());
    let problem = page.robot["servos"][1]["problem"].to_string();
    assert!(
        problem.contains("J12 (servo 2) has not answered"),
        "{problem}"
    );
    bus.with(|bus| bus.plug(2));
    page.until(|page| page.robot["servos"][1]["problem"].is_null());
    for request in ["take", "restart", "play", "save"] {
        let answer = page.ask(json!({"do": request}));
        assert_eq!(answer["error"], "taught", "{answer}");
    }
    let stop = json!({"do": "event", "event": "key 0x0D"});
    page.does(stop.clone());
    lesson.press(b' ', "pose 2 is added\n");
    lesson.press(b'g', "r switches the torque off\n");
    page.until(|page| page.robot["phase"] == "holds" && page.robot["chosen"] == 1);
    assert_eq!(bus.stiff(), [1, 2, 3]);
    page.does(stop);
    let outcome = lesson.ends().expect(3);
    let said = "the emergency stop was pressed on the page\n";
    assert!(outcome.err.contains(said), "{outcome:#?}");
    assert!(bus.stiff().is_empty(), "in_emergency relaxes");
    assert!(folder.has("wave.prg"));
}

/// Every byte of the program stays around the new lines: line ends of DOS, a text in Shift_JIS, and what follows END.
#[test]
fn poses_are_added_to_a_program_that_exists() {
    let robot = leg("hold", "hold", "start = 90");
    let before = b"3.2\r\n\x95\xE0\x82\xAD // a walk\r\nDEF_VAR POSE1_F1\r\nPOSE1_F1 = 1\r\nIF POSE1_F1 == 1 THEN\r\n".to_vec();
    let after = b"  MESSAGE %POSE1_F1%\r\nENDIF\r\n SLEEP 20 ; END\r\nmore\x1A".to_vec();
    let old = [&before[..], &after].concat();
    let folder = Folder::new("record-at").file("robot.toml", &robot);
    let folder = folder.file("walk.prg", &old);
    let mut bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "walk.prg", "--at", "6"]);
    turn_to(&mut bus, &robot, &[30.0, 20.0, -10.0]);
    lesson.press(b' ', "pose 1 is added\n");
    // The program has variables of this name, so that the pose gets another one.
    lesson.types("npose1\n");
    lesson.says("`POSE1` cannot name a pose");
    lesson.pty.press(b'q');
    let outcome = lesson.ends().expect(0);
    let said = "walk.prg has the motion now; only its new lines were tried in simulation. Number of set points: 1\n";
    assert_eq!(outcome.out, said);
    let block = "  // Taught by hand: 1 pose
  DEF_JOINT POSE2_F1
  TIP_SPEED_UP 255  // all legs set off in one cycle

  POSE2_F1.J1 = 30 ; POSE2_F1.J2 = 20 ; POSE2_F1.J3 = -10

  SET_OMEGA_MAX ALL 90  // slowly to the first pose
  PTP_ANGLE F1 POSE2_F1
  WAIT_INPOS ALL

  SET_OMEGA_MAX ALL 90  // as at the start of a program
  TIP_SPEED_UP 1

";
    let block = block.replace('\n', "\r\n").into_bytes();
    let written = std::fs::read(folder.path("walk.prg")).expect("written");
    assert_eq!(
        String::from_utf8_lossy(&written),
        String::from_utf8_lossy(&[&before[..], &block, &after].concat())
    );
    // SLEEP 20 and END share a line. A second lesson adds its pose between them.
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "walk.prg", "--at", "end"]);
    lesson.press(b' ', "pose 1 is added\n");
    lesson.pty.press(b'q');
    lesson.ends().expect(0);
    let written = std::fs::read(folder.path("walk.prg")).expect("written");
    let written = String::from_utf8_lossy(&written).into_owned();
    let at = written.find("DEF_JOINT POSE3_F1\r\n").expect("a free name");
    assert!(
        written[..at].ends_with("ENDIF\r\n SLEEP 20 ; \r\n // Taught by hand: 1 pose\r\n ")
            && written.ends_with("TIP_SPEED_UP 1\r\n\r\n END\r\nmore\x1A"),
        "{written}"
    );
    turn_to(&mut bus, &robot, &[0.0; 3]);
    let run = [
        "run",
        "walk.prg",
        "--hardware",
        "robot.toml",
        "--yes",
        "--port",
    ];
    folder.tip(&[&run[..], &[bus.port()]].concat()).expect(0);
    for (played, taught) in angles(&mut bus, &robot)
        .into_iter()
        .zip([30.0, 20.0, -10.0])
    {
        assert!((played - taught).abs() < 0.5, "{played} for {taught}");
    }
}

/// A program that was changed meanwhile stays as it is, and the lines are printed.
#[test]
fn what_was_taught_is_printed_where_it_cannot_be_added() {
    let robot = leg("hold", "hold", "");
    let folder = Folder::new("record-not-added").file("robot.toml", &robot);
    let folder = folder.file("walk.prg", "3.2\nwalk\nALL_STOP\nEND\n");
    let bus = ServoBus::of(&robot, 0.0);
    let mut lesson = Lesson::begin(&folder, &bus, &["-o", "walk.prg", "--at", "end"]);
    lesson.press(b' ', "pose 1 is added\n");
    let other = "3.2\nanother\nEND\n";
    let folder = folder.file("walk.prg", other);
    lesson.pty.press(b'q');
    let outcome = lesson.ends().expect(1);
    // The lines alone, without the first and the last of a program.
    assert!(
        outcome
            .out
            .starts_with("// Taught by hand: 1 pose\nDEF_JOINT POSE1_F1\n"),
        "{outcome:#?}"
    );
    assert!(
        outcome.out.contains("PTP_ANGLE F1 POSE1_F1\n") && !outcome.out.contains("END\n"),
        "{outcome:#?}"
    );
    assert!(
        outcome.err.contains("cannot write walk.prg"),
        "{outcome:#?}"
    );
    assert_eq!(folder.read("walk.prg"), other);
}
