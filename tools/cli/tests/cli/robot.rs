//! `--robot FILE.toml`, and `tip robot`.

use crate::dap::Client;
use crate::imported::URDF;
use crate::support::Folder;
use serde_json::json;

const HEXAPOD: &str = include_str!("../../../../tipc/tests/robots/hexapod.toml");

/// Lifts the last foot, then turns the last joint.
const LIFT: &str = "REL_PTP F6 0 0 20\nWAIT_INPOS F6\nREL_PTP_ANGLE J63 5\nEND";

fn folder(name: &str) -> Folder {
    Folder::new(name)
        .file("hexapod.toml", HEXAPOD)
        .program("lift.prg", LIFT)
}

#[test]
fn every_command_takes_a_description() {
    let folder = folder("described");
    let checked = folder
        .tip(&["check", "lift.prg", "--robot", "hexapod.toml"])
        .expect(0);
    assert!(
        checked.err.contains("4 steps for hexapod"),
        "{}",
        checked.err
    );
    let emitted = folder
        .tip(&["emit", "rust", "lift.prg", "--robot", "hexapod.toml"])
        .expect(0);
    assert!(
        emitted.out.contains("robot: \"hexapod\""),
        "{}",
        emitted.out
    );
    let run = folder
        .tip(&["run", "lift.prg", "--robot", "hexapod.toml", "--trace", "-"])
        .expect(0);
    assert!(
        run.out.contains("[\"REL_PTP_ANGLE\",\"J63\",5.0]"),
        "{}",
        run.out
    );
}

#[test]
fn faults_of_a_description_are_shown_like_those_of_a_program() {
    let folder =
        folder("misdescribed").file("bad.toml", "name = \"bad\"\nlegs = 6\n[body]\nmass = -1\n");
    for command in [&["check"][..], &["emit", "label"], &["run"]] {
        let arguments = [
            command,
            &[
                "lift.prg",
                "--robot",
                "bad.toml",
                "--message-format",
                "short",
            ],
        ];
        let outcome = folder.tip(&arguments.concat()).expect(1);
        let said = format!("{}{}", outcome.out, outcome.err);
        for place in [
            "bad.toml:1:1:",
            "bad.toml:2:1:",
            "bad.toml:3:1:",
            "bad.toml:4:8:",
        ] {
            assert!(said.contains(place), "{command:?}: {said}");
        }
        assert!(said.contains("TIP_ERR:Wrong robot description"), "{said}");
    }
    let human = folder
        .tip(&["check", "lift.prg", "--robot", "bad.toml"])
        .expect(1);
    assert!(human.err.contains("did you mean `leg`?"), "{}", human.err);
}

#[test]
fn a_description_that_is_not_there_is_a_file_not_found() {
    let outcome = folder("undescribed")
        .tip(&["check", "lift.prg", "--robot", "gone.toml"])
        .expect(1);
    assert!(
        outcome.err.contains("File not found(gone.toml)"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_robot_that_nobody_knows_is_wrong_usage() {
    let outcome = folder("unknown")
        .tip(&["check", "lift.prg", "--robot", "hexapod"])
        .expect(2);
    assert!(
        outcome.err.contains("titan8, hand, generic, a1"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_robot_that_a_debugger_does_not_know_is_answered_in_a_sentence() {
    let folder = folder("dap-unknown");
    let program = folder.path("lift.prg").display().to_string();
    let launch = |robot: &str| json!({ "program": program, "robot": robot });
    let mut client = Client::new();
    client.ask("initialize", json!({ "adapterID": "tip" }));
    let reason = client.refusal("launch", launch("hexapad"));
    assert!(reason.contains("titan8, hand, generic, a1"), "{reason}");
    assert!(!reason.contains("Robot {"), "{reason}");
    client.ask("launch", launch("phantomx"));
}

#[test]
fn a_robot_of_any_size_runs() {
    let leg = "{ base = [0, 0, 0] },";
    let joint = "{ axis = \"y\", link = [10, 0, 0], limits = [-90, 90] },";
    for (legs, joints) in [(1, 1), (1, 9), (9, 1), (5, 4), (9, 9)] {
        let robot = format!(
            "name = \"many\"\nleg = [{}]\njoint = [{}]\n",
            leg.repeat(legs),
            joint.repeat(joints)
        );
        let program = format!(
            "DEF_JOINT Q\nPTP_ANGLE HS J{legs}{joints} 10\nWAIT_INPOS J{legs}{joints}\n\
             TEACH_ANGLE F{legs} Q\nMESSAGE %ANGLE.0%\nEND"
        );
        let program = program.replace(
            "MESSAGE",
            &format!("DEF_VAR ANGLE\nANGLE = Q.J{joints}\nMESSAGE"),
        );
        let folder = Folder::new(&format!("size-{legs}-{joints}"))
            .file("many.toml", robot)
            .program("turn.prg", &program);
        let outcome = folder
            .tip(&["run", "turn.prg", "--robot", "many.toml", "--cycles", "500"])
            .expect(0);
        let angle: f64 = outcome.out.trim().parse().expect("a number");
        assert!((9.0..=10.0).contains(&angle), "{legs} × {joints}: {angle}");
    }
}

#[test]
fn a_robot_is_written_as_urdf() {
    let folder = Folder::new("exported").file("pendulum.urdf", URDF);
    let titan = folder.tip(&["robot", "export", "--urdf"]).expect(0);
    assert!(
        titan.out.contains("<robot name=\"titan8\">"),
        "{}",
        titan.out
    );
    assert_eq!(titan.out.matches("type=\"revolute\"").count(), 12);
    let to_file = [
        "robot",
        "export",
        "--urdf",
        "--robot",
        "hand",
        "-o",
        "hand.urdf",
    ];
    assert_eq!(folder.tip(&to_file).expect(0).out, "");
    let hand = folder.read("hand.urdf");
    assert_eq!(hand.matches("type=\"prismatic\"").count(), 1, "{hand}");

    // A URDF file becomes regular: its joint is J11, its foot F1.
    let regular = folder
        .tip(&["robot", "export", "--urdf", "--robot", "pendulum.urdf"])
        .expect(0);
    assert!(
        regular.out.contains("<joint name=\"J11\""),
        "{}",
        regular.out
    );
    let foot = "<child link=\"F1\"/>\n  <origin xyz=\"0 0 -0.5\"";
    assert!(regular.out.contains(foot), "{}", regular.out);
}

#[test]
fn a_robot_is_written_for_mujoco_with_what_surrounds_it() {
    let folder = Folder::new("exported-mjcf").file("step.toml", "[floor]\nfriction = 0.9\n");
    let export = |more: &[&str], status| {
        let all = [&["robot", "export"], more].concat();
        folder.tip(&all).expect(status)
    };
    let titan = export(&["--mjcf", "--scene", "step.toml"], 0).out;
    assert!(titan.contains("<mujoco model=\"titan8\">"), "{titan}");
    assert!(titan.contains("friction=\"0.9 0 0\""), "{titan}");
    export(
        &[
            "--mjcf", "--robot", "hand", "--scene", "cylinder", "-o", "hand.xml",
        ],
        0,
    );
    assert!(folder.read("hand.xml").contains("<body name=\"O1\""));

    let grasps = export(&["--mjcf", "--scene", "cylinder", "-o", "no.xml"], 2).err;
    assert!(grasps.contains("titan8 grasps nothing"), "{grasps}");
    let gone = export(&["--mjcf", "--scene", "gone.toml", "-o", "no.xml"], 1).err;
    assert!(gone.contains("gone.toml"), "{gone}");
    assert!(!folder.has("no.xml"));
    let itself = export(&["--mjcf", "--scene", "step.toml", "-o", "step.toml"], 1).err;
    assert!(itself.contains("which is being read"), "{itself}");
    // URDF knows no surroundings.
    assert!(
        export(&["--urdf", "--scene", "step.toml"], 2)
            .err
            .contains("--scene")
    );
    assert!(export(&["--urdf", "--mjcf"], 2).err.contains("--mjcf"));
}

#[test]
fn a_robot_that_cannot_be_written_leaves_nothing() {
    let folder = Folder::new("not-exported")
        .file("pendulum.urdf", URDF)
        .file("bad.toml", "name = \"bad\"\nlegs = 6\n");
    let export = |arguments: &[&str], status| {
        let all = [&["robot", "export"], arguments].concat();
        folder.tip(&all).expect(status).err
    };
    assert!(export(&[], 2).contains("--urdf"));
    assert!(export(&["--urdf", "--robot", "titan9"], 2).contains("titan8, hand, generic, a1"));
    let bad = export(&["--urdf", "--robot", "bad.toml", "-o", "out.urdf"], 1);
    assert!(bad.contains("bad.toml"), "{bad}");
    let gone = export(&["--urdf", "--robot", "gone.urdf", "-o", "out.urdf"], 1);
    assert!(gone.contains("gone.urdf"), "{gone}");
    assert!(!folder.has("out.urdf"));
    let itself = export(
        &["--urdf", "--robot", "pendulum.urdf", "-o", "pendulum.urdf"],
        1,
    );
    assert!(itself.contains("which is being read"), "{itself}");
    assert_eq!(folder.read("pendulum.urdf"), URDF);
}

#[test]
fn robot_check_shows_every_fault() {
    let folder = Folder::new("robot-check").file("bad.toml", "name = \"bad\"\nlegs = 6\n");
    let outcome = folder
        .tip(&["robot", "check", "bad.toml", "--message-format", "short"])
        .expect(1);
    let lines = outcome.lines();
    assert!(
        lines[0].starts_with("bad.toml:1:1: error[E401]: "),
        "{lines:?}"
    );
    assert!(
        lines[1].starts_with("bad.toml:2:1: error[E401]: "),
        "{lines:?}"
    );
}

#[test]
fn every_robot_that_has_a_name_is_listed_and_shown() {
    let folder = Folder::new("robot-list");
    let list = folder.tip(&["robot", "list"]).expect(0).out;
    let names: Vec<&str> = list
        .lines()
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    let all = [
        "titan8",
        "hand",
        "generic",
        "a1",
        "phantomx",
        "solo12",
        "spotmicro",
        "trifinger",
    ];
    assert_eq!(names, all);
    assert!(
        list.contains("\nphantomx    PhantomX AX: a hexapod of 18 hobby servos\n"),
        "{list}"
    );
    for name in names {
        let shown = folder.tip(&["robot", "show", name]).expect(0).out;
        assert!(shown.contains(&format!("{name}: ")), "{shown}");
        assert!(shown.contains("inverse kinematics: "), "{shown}");
    }
    let wrong = folder.tip(&["robot", "show", "asimo"]).expect(2);
    assert!(wrong.err.contains("phantomx"), "{wrong:#?}");
}

#[test]
fn what_is_shown_of_a_published_robot_is_its_description() {
    let folder = Folder::new("robot-show");
    let shown = folder.tip(&["robot", "show", "A1"]).expect(0).out;
    for line in [
        "# Licence: BSD-3-Clause. What is marked A is assumed.",
        "# a1: 4 legs of 3 joints, body of 6 kg",
        "# F1 to F4, J11 to J43, members J1 to J3; torque up to 33.5 N·m",
        "# inverse kinematics: roll-pitch-pitch",
        "#   F2  130.8 180.5 -282.8",
    ] {
        assert!(shown.lines().any(|it| it == line), "{line}: {shown}");
    }
    let folder = folder
        .file("mine.toml", &shown)
        .file("tip.toml", "robot = \"spotmicro\"\n");
    folder.tip(&["robot", "check", "mine.toml"]).expect(0);
    let folder = folder.program("lift.prg", "REL_PTP F4 0 0 20\nWAIT_INPOS F4\nEND");
    let by_project = folder.tip(&["check", "lift.prg"]).expect(0);
    assert!(by_project.err.contains("for spotmicro"), "{by_project:#?}");
    let by_option = folder
        .tip(&["check", "lift.prg", "--robot", "solo12"])
        .expect(0);
    assert!(by_option.err.contains("for solo12"), "{by_option:#?}");
}

#[test]
fn a_robot_is_imported_from_standard_input() {
    let folder = Folder::new("robot-stdin");
    let mut command = folder.command(&["robot", "import", "-"]);
    command
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped());
    let mut child = command.spawn().expect("tip starts");
    let input = child.stdin.take();
    std::io::Write::write_all(&mut input.expect("a pipe"), URDF.as_bytes()).expect("it reads");
    let outcome = crate::support::Outcome::of(child.wait_with_output().expect("it ends")).expect(0);
    assert!(
        outcome.out.starts_with("# From standard input"),
        "{outcome:#?}"
    );
    assert!(outcome.err.starts_with("standard input: "), "{outcome:#?}");
}
