//! Every fault at its location, with its reason and its help.

use crate::code::Code;
use crate::description::{Servo, parse, parse_for_servos};
use tip_runtime::model::Range;

/// `LINE:COLUMN: reason (help)` of each fault.
pub(super) fn faults(text: &str) -> Vec<String> {
    let loaded = parse("robot.toml", text.as_bytes()).expect_err("it has a fault");
    let reported = loaded.diagnostics.iter().map(|fault| {
        assert_eq!(fault.code, Code::Description);
        let (line, column) = loaded.source.line_column(fault.span.start);
        let help = fault.help.as_ref().expect("every fault says a way out");
        format!("{line}:{column}: {} ({help})", fault.reason)
    });
    reported.collect()
}

/// Returns a description whose leg and joint stand in the lines 2 and 3, and `more` from line 4 on.
pub(super) fn with(more: &str) -> String {
    format!(
        "name = \"test\"\nleg = [{{ base = [0, 0, 0] }}]\njoint = [{{ axis = \"x\", link = [0, 0, 9] }}]\n{more}"
    )
}

/// Like [`with`], with these keys in its joint as well, from column 42 on.
pub(super) fn with_joint(keys: &str) -> String {
    with("").replace("9] }", &format!("9], {keys} }}"))
}

#[track_caller]
pub(super) fn only(text: &str, expected: &str) {
    assert_eq!(faults(text), [expected], "{text}");
}

#[test]
fn a_key_that_does_not_exist() {
    only(
        &with("lampz = 3"),
        "4:1: the robot has no key `lampz` (did you mean `lamps`?)",
    );
    only(
        &with("mass = 3"),
        "4:1: the robot has no key `mass` (`mass` belongs to [[joint]])",
    );
    only(
        &with("[slider]\ninitial = [0, 0, 0]\ncolour = 3"),
        "6:1: [slider] has no key `colour` (the keys of [slider] are initial, x, y, z)",
    );
}

#[test]
fn a_key_that_is_missing() {
    assert_eq!(
        faults(""),
        [
            "1:1: the robot lacks `name` (`name` is a text: what programs, messages and traces call the robot: letters, digits, blanks, `-`, `_`, `.`)",
            "1:1: the robot lacks `leg` (`leg` is a list of [[leg]] tables: the legs, F1 first: 1 to 9, each with the same number of joints)",
        ]
    );
    only(
        &with("[body]\nx = [-1, 1]\nz = [-1, 1]"),
        "4:1: [body] lacks `y` (`y` is [min, max] in mm: along y)",
    );
}

#[test]
fn a_value_of_another_type() {
    for (value, stands) in [
        ("\"9\"", "text"),
        ("9", "a number"),
        ("9.5", "a number"),
        ("true", "true or false"),
        ("2026-01-01", "a date"),
        ("{}", "a table"),
    ] {
        only(
            &with(&format!("periods = {value}")),
            &format!("4:11: {stands} cannot stand here (`periods` is [min, max] in ms)"),
        );
    }
    only(
        &with("lamps = [1]"),
        "4:9: a list cannot stand here (`lamps` is a whole number, 0 to 255)",
    );
    only(
        &with("body = 1"),
        "4:8: a number cannot stand here (`body` is a [body] table)",
    );
    only(
        &with("periods = [1, \"2\"]"),
        "4:15: text cannot stand here (`periods` is [min, max] in ms)",
    );
}

#[test]
fn a_number_out_of_range() {
    let mass = |value| with_joint(&format!("mass = {value}"));
    for endless in [
        "inf",
        "-inf",
        "nan",
        "1e999",
        "1e7",
        "-1000001",
        "99999999999999999999",
    ] {
        only(
            &mass(endless),
            "3:49: a number from -1000000 to 1000000 belongs here (`mass` is a number in kg)",
        );
    }
    only(
        &mass("-1"),
        "3:49: it cannot be below 0 (`mass` is a number in kg)",
    );
    only(
        &with_joint("torque = 0"),
        "3:51: it must be above 0 (`torque` is a number in N·m)",
    );
    for lamps in ["256", "1.5"] {
        only(
            &with(&format!("lamps = {lamps}")),
            "4:9: this cannot be a number of lamps (`lamps` is a whole number, 0 to 255)",
        );
    }
}

#[test]
fn what_has_a_size_has_one_that_exported_files_can_hold() {
    let ranges = ["[-1, 1]", "[-2, 2]", "[-3, 3]"];
    for (line, key) in [(5, "x"), (6, "y"), (7, "z")] {
        for flat in ["[0, 0]", "[5, 5.0000001]"] {
            let mut ranges = ranges;
            ranges[line - 5] = flat;
            let [x, y, z] = ranges;
            only(
                &with(&format!("[body]\nx = {x}\ny = {y}\nz = {z}")),
                &format!(
                    "{line}:5: the first number and the second are less than 0.000001 mm apart: what is there has a size, measure it \
                     (`{key}` is [min, max] in mm)"
                ),
            );
        }
    }
    for (shape, column) in [
        ("sphere = 1e-7", 62),
        ("block = [1, 1e-300, 1]", 65),
        ("cylinder = [1, 0.0000009]", 68),
    ] {
        let reported = faults(&with_joint(&format!("shape = [{{ {shape} }}]")));
        let start = format!("3:{column}: no size is below 0.000001 mm (");
        assert!(
            reported.len() == 1 && reported[0].starts_with(&start),
            "{reported:?}"
        );
    }
    only(
        &with("").replace("[0, 0, 9]", "[0, 0, 1e-7]"),
        "2:8: leg F1 has no length (the link of one joint at least is not [0, 0, 0])",
    );
}

#[test]
fn limits_that_contain_nothing() {
    only(
        &with_joint("limits = [10, -10]"),
        "3:51: 10 is above -10 (`limits` is [min, max] in deg)",
    );
    only(
        &with_joint("limits = [10, 20, 30]"),
        "3:51: 2 numbers belong here, and there are 3 (`limits` is [min, max] in deg)",
    );
    only(
        &with_joint("limits = [-10, 10], outer = [-9, 20]"),
        "3:70: the outer limits must contain the working limits -10 to 10 (`outer` is [min, max] in deg)",
    );
}

#[test]
fn an_axis_without_direction() {
    only(
        &with("").replace("\"x\"", "[0, 0, 0]"),
        "3:19: an axis of length 0 has no direction (`axis` is \"x\", \"-y\", … or [x, y, z])",
    );
    let text = with("").replace("\"x\"", "\"up\"");
    only(
        &text,
        "3:19: `axis` cannot be this (`axis` is \"x\", \"-y\", … or [x, y, z])",
    );
}

#[test]
fn legs_and_joints_that_are_too_many_or_too_few() {
    let leg = "{ base = [0, 0, 0] },";
    let joint = "{ axis = \"x\", link = [0, 0, 9] },";
    let robot = |legs, joints| {
        let (legs, joints) = (leg.repeat(legs), joint.repeat(joints));
        format!("name = \"test\"\nleg = [{legs}]\njoint = [{joints}]")
    };
    let help = "(`leg` is a list of [[leg]] tables)";
    only(
        &robot(10, 1),
        &format!("2:7: a robot has 1 to 9 legs, and here are 10 {help}"),
    );
    only(
        &robot(0, 1),
        &format!("2:7: a robot has 1 to 9 legs, and here are 0 {help}"),
    );
    let help = "(`joint` is a list of [[joint]] tables)";
    only(
        &robot(1, 10),
        &format!("3:9: a leg has 1 to 9 joints, and here are 10 {help}"),
    );
    only(
        &robot(1, 0),
        &format!("3:9: a leg has 1 to 9 joints, and here are 0 {help}"),
    );
}

#[test]
fn legs_that_differ() {
    let text = with("").replace(
        "leg = [{ base = [0, 0, 0] }]",
        "leg = [{ base = [0, 0, 0] }, { base = [1, 0, 0], joint = [\
         { axis = \"x\", link = [1, 0, 0] }, { axis = \"y\", link = [1, 0, 0] }] }]",
    );
    only(
        &text,
        "2:30: leg F2 has 2 joints, F1 has 1 (every leg needs the same number of joints: the language names them J1…Jn)",
    );
}

#[test]
fn a_leg_without_length() {
    only(
        &with("").replace("9", "0"),
        "2:8: leg F1 has no length (the link of one joint at least is not [0, 0, 0])",
    );
}

#[test]
fn legs_without_joints() {
    only(
        "name = \"test\"\n[[leg]]\nbase = [0, 0, 0]",
        "2:1: leg F1 has no joints (describe them under [[joint]], for every leg, or under [[leg.joint]], for this one)",
    );
}

#[test]
fn an_initial_posture_that_does_not_fit() {
    only(
        &with("initial = [1, 2]"),
        "2:8: the initial posture has 2 angles, the leg has 1 joint (`initial` is [deg, …], a number for each joint)",
    );
    let text = with("").replace("base", "initial = [200], base");
    only(
        &text,
        "2:20: the initial angle 200 of joint 1 is outside its limits -180 to 180 (`initial` is [deg, …], a number for each joint)",
    );
}

#[test]
fn a_mirror_of_other_letters() {
    for (letters, letter) in [("w", 'w'), ("xyx", 'x'), ("X", 'X')] {
        let text = with("").replace("base", &format!("mirror = \"{letters}\", base"));
        only(
            &text,
            &format!(
                "2:19: {letter:?} is not a coordinate, or appears twice (`mirror` is letters of \"x\", \"y\", \"z\")"
            ),
        );
    }
}

#[test]
fn an_inverse_that_does_not_fit() {
    let help =
        "(`inverse` is \"yaw-pitch-pitch\", \"roll-pitch-pitch\", \"planar\" or \"least-squares\")";
    only(
        &with("inverse = \"planar\""),
        &format!("4:11: the joints of leg F1 must have vertical axes only {help}"),
    );
    only(
        &with("inverse = \"yaw-pitch-pitch\""),
        &format!(
            "4:11: the joints of leg F1 must be a vertical and two level axes, with links straight outward at 0 and a knee that flexes downwards {help}"
        ),
    );
    only(
        &with("inverse = \"guess\""),
        &format!("4:11: `inverse` cannot be this {help}"),
    );
}

#[test]
fn times_and_travels_that_leave_their_ranges() {
    only(
        &with("periods = [5, 50]\n[standards]\nperiod = 4"),
        "6:10: the robot accepts sampling times of 5 to 50 ms only (`period` is a number in ms)",
    );
    only(
        &with("[slider]\ninitial = [0, 9, 0]\ny = [10, 20]"),
        "6:5: the slider starts at 9, which is outside (`y` is [min, max] in mm)",
    );
}

#[test]
fn a_name_that_is_none() {
    let help = "(`name` is a text)";
    for (name, reason) in [
        ("", "a robot needs a name"),
        ("  ", "a robot needs a name"),
        (" a", "a name neither begins nor ends with a blank"),
        ("a\\nb", "'\\n' cannot be part of a name"),
        ("a/b", "'/' cannot be part of a name"),
        ("generic", "this is the name of a built-in robot"),
        (&"n".repeat(41), "a name has 40 characters at most"),
    ] {
        let text = with("").replace("\"test\"", &format!("\"{name}\""));
        only(&text, &format!("1:8: {reason} {help}"));
    }
}

#[test]
fn all_faults_of_a_file_are_told_in_their_order() {
    let text = "name = 3
legz = 1
[[leg]]
base = [0, 0]
[[joint]]
axis = \"x\"
limits = [3, 2]
[standards]
v_max = -1";
    let locations: Vec<String> = faults(text)
        .iter()
        .map(|fault| fault.split(": ").next().unwrap_or_default().to_owned())
        .collect();
    // `legz`; the leg's `base`; the joint's missing `link` and its `limits`; `v_max`.
    assert_eq!(locations, ["1:8", "2:1", "4:8", "5:1", "7:10", "9:9"]);
}

#[test]
fn text_that_is_no_toml() {
    let help = "(the file is TOML: `key = value`, `[table]`, `[[one of many tables]]`)";
    let reported = faults("name = \"test\"\nlamps = = 3 4\nperiods = 1 2\n");
    assert_eq!(reported.len(), 2, "one for each line: {reported:?}");
    for (line, fault) in ["2:", "3:"].iter().zip(&reported) {
        assert!(fault.starts_with(line) && fault.ends_with(help), "{fault}");
    }
}

#[test]
fn bytes_that_are_no_text() {
    let loaded = parse("robot.toml", b"name = \"\xFF\"").unwrap_err();
    assert_eq!(loaded.diagnostics.len(), 1);
    assert_eq!(loaded.diagnostics[0].code, Code::Format);
}

#[test]
fn an_inertia_that_no_body_has() {
    let help = "`inertia` is [xx, yy, zz, xy, xz, yz] in kg·m²";
    let reason = "no rigid body has this inertia: none of its principal moments is below 0, or above the other two together";
    for elements in ["1, 1, 3, 0, 0, 0", "-1, 1, 1, 0, 0, 0", "1, 1, 1, 1, 1, 1"] {
        only(
            &with_joint(&format!("inertia = [{elements}]")),
            &format!("3:52: {reason} ({help})"),
        );
    }
    only(
        &with_joint("inertia = [1, 1, 1]"),
        &format!("3:52: 6 numbers belong here, and there are 3 ({help})"),
    );
    let body = "[body]\nx = [-1, 1]\ny = [-1, 1]\nz = [-1, 1]\n";
    only(
        &with(&format!("{body}inertia = [1, 1, 3, 0, 0, 0]")),
        &format!("8:11: {reason} ({help})"),
    );
}

const SERVOS: [Servo; 3] = [
    Servo {
        name: "AX-12",
        family: "AX",
        travel: Range::new(-150.0, 150.0),
    },
    Servo {
        name: "MX-28",
        family: "AX",
        travel: Range::new(-180.0, 180.0),
    },
    Servo {
        name: "STS3215",
        family: "STS",
        travel: Range::new(-180.0, 180.0),
    },
];

/// The robot has one joint, from -180 to 180 deg, which starts at 0.
fn faults_of_drive(more: &str) -> Vec<String> {
    let text = with(more);
    let loaded = parse_for_servos("robot.toml", text.as_bytes(), &SERVOS);
    let loaded = loaded.expect_err("it has a fault");
    let reported = loaded.diagnostics.iter().map(|fault| {
        let (line, column) = loaded.source.line_column(fault.span.start);
        format!("{line}:{column}: {}", fault.reason)
    });
    reported.collect()
}

/// The keys that decide how far a motor turns are named, and not what kind of value a key has.
#[test]
fn the_help_for_a_motor_that_would_turn_too_far_names_the_keys() {
    let text = with("[bus]\nservo = \"AX-12\"\n[[drive]]\njoint = \"J11\"\nid = 1\n");
    let loaded = parse_for_servos("robot.toml", text.as_bytes(), &SERVOS);
    let loaded = loaded.expect_err("it turns by 180 deg");
    let helps = loaded.diagnostics.iter().map(|fault| fault.help.as_ref());
    let helps: Vec<_> = helps.map(|help| help.map(ToString::to_string)).collect();
    let expected = "look at `sign`, `offset` and `gear`, or give the drive narrower `limits`";
    assert_eq!(helps, [Some(expected.to_owned())]);
}

#[test]
fn a_bus_has_a_drive_for_each_joint() {
    let text = with(
        "[bus]\nport = \"/dev/ttyUSB0\"\nservo = \"ax-12\"\nsilence = 3\nbaud = 4500000\nat_end = \"relax\"\ncollisions = \"warn\"\nhold_to_drive = false\ndriver_silence = [1, 1, 3600]\n\
         [[drive]]\njoint = \"J11\"\nid = 7\nsign = -1\noffset = 10\nlimits = [-90, 120]\n",
    );
    let description = parse_for_servos("robot.toml", text.as_bytes(), &SERVOS).expect("good");
    let bus = description.bus().expect("a bus");
    assert_eq!(bus.port.as_deref(), Some("/dev/ttyUSB0"));
    assert_eq!((bus.baud, bus.silence), (4_500_000, 3));
    assert_eq!(bus.relaxes, [true, false]);
    assert!(!bus.stops_collisions);
    assert_eq!(
        (bus.hold_to_drive, bus.driver_silence),
        (false, [1.0, 1.0, 3600.0])
    );
    let [drive] = &bus.drives[..] else {
        panic!("one drive");
    };
    assert_eq!((drive.id, drive.model.as_str()), (7, "ax-12"));
    assert_eq!((drive.sign, drive.offset, drive.gear), (-1.0, 10.0, 1.0));
    assert_eq!(drive.limits, Range::new(-90.0, 120.0));
}

#[test]
fn a_servo_model_that_is_nearly_right_is_named() {
    let help_of = |name: &str| {
        let drive = "[[drive]]\njoint = \"J11\"\nid = 1\n";
        let text = with(&format!("[bus]\nservo = \"{name}\"\n{drive}"));
        let loaded = parse_for_servos("robot.toml", text.as_bytes(), &SERVOS);
        let loaded = loaded.expect_err("no such model");
        let [fault] = &loaded.diagnostics[..] else {
            panic!("{:?}", loaded.diagnostics);
        };
        fault.help.as_ref().map(ToString::to_string)
    };
    for (name, near) in [
        ("AX12", "AX-12"),
        ("ax_12", "AX-12"),
        ("MX28", "MX-28"),
        ("STS-3215", "STS3215"),
        ("sts", "STS3215"),
    ] {
        assert_eq!(
            help_of(name),
            Some(format!("did you mean `{near}`?")),
            "{name}"
        );
    }
    let none = help_of("Dynamixel").unwrap_or_default();
    assert!(none.starts_with("`servo` is"), "{none}");
}

#[test]
fn every_fault_of_a_drive_is_at_its_location() {
    let bus = "[bus]\nservo = \"AX-12\"\n[[drive]]\njoint = \"J11\"\n";
    for (more, expected) in [
        (
            "[[drive]]\njoint = \"J11\"\nid = 1\n",
            "4:1: drives need a [bus]",
        ),
        (
            "[bus]\nservo = \"AX-12\"\n",
            "4:1: joint J11 has no [[drive]]",
        ),
        (
            "[bus]\nservo = \"AX-13\"\n",
            "5:9: no servo model has this name; there are AX-12, MX-28, STS3215",
        ),
        (
            &format!("{bus}id = 253\nlimits = [-9, 9]\n"),
            "8:6: a whole number from 0 to 252 belongs here",
        ),
        (
            &format!("{bus}id = 1\nsign = 2\nlimits = [-9, 9]\n"),
            "9:8: a sign is 1 or -1",
        ),
        (
            &format!("{bus}id = 1\nlimits = [9, 20]\n"),
            "9:10: the initial posture has this joint at 0 deg, which is outside",
        ),
        (
            &format!("{bus}id = 1\nlimits = [-190, 20]\n"),
            "9:10: the joint itself goes from -180 to 180 deg only",
        ),
        (
            &format!("{bus}id = 1\n"),
            "7:9: the motor would have to turn to -180 deg, and goes from -150 to 150 deg",
        ),
        (
            // 57.3 times 9 is 515.7, which is no binary number.
            &format!("{bus}id = 1\ngear = 9\nlimits = [-9, 57.3]\n"),
            "10:10: the motor would have to turn to 515.7 deg, and goes from -150 to 150 deg",
        ),
        (
            &format!("{bus}id = 1\nmodel = \"STS3215\"\n"),
            "9:9: servos of STS and AX cannot share a bus",
        ),
        (
            &format!("{bus}id = 1\nmodel = \"MX-28\"\n[[drive]]\njoint = \"J12\"\nid = 2\n"),
            "11:9: the robot has no joint of this name",
        ),
        (
            &format!("{bus}id = 1\nmodel = \"MX-28\"\n[[drive]]\njoint = \"J11\"\nid = 2\n"),
            "11:9: this joint has a drive already",
        ),
        (
            &format!("{bus}id = 1\nmodel = \"MX-28\"\ntorque = 2\n"),
            "10:10: a number from 0.01 to 1 belongs here",
        ),
        (
            "[bus]\nservo = \"MX-28\"\ndriver_silence = [3, 1, 10]\n[[drive]]\njoint = \"J11\"\nid = 1\n",
            "6:18: 3 is above 1",
        ),
        (
            "[bus]\nservo = \"MX-28\"\ndriver_silence = [1, 3, 3601]\n[[drive]]\njoint = \"J11\"\nid = 1\n",
            "6:18: a number from 3 to 3600 belongs here",
        ),
        (
            "[bus]\nservo = \"MX-28\"\nhold_to_drive = \"no\"\n[[drive]]\njoint = \"J11\"\nid = 1\n",
            "6:17: text cannot stand here",
        ),
    ] {
        assert_eq!(faults_of_drive(more), [expected], "{more}");
    }
}
