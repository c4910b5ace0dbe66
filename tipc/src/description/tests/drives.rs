//! Drives: what a good file gives, and every fault at its location.

use super::faults::with;
use crate::description::{Servo, parse_for_servos};
use tip_runtime::model::Range;

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
fn faults(more: &str) -> Vec<String> {
    let text = with(more);
    let loaded = parse_for_servos("robot.toml", text.as_bytes(), &SERVOS);
    let loaded = loaded.expect_err("it has a fault");
    let told = loaded.diagnostics.iter().map(|fault| {
        let (line, column) = loaded.source.line_column(fault.span.start);
        format!("{line}:{column}: {}", fault.reason)
    });
    told.collect()
}

#[test]
fn a_bus_has_a_drive_for_each_joint() {
    let text = with(
        "[bus]\nport = \"/dev/ttyUSB0\"\nservo = \"ax-12\"\nsilence = 3\nbaud = 4500000\nat_end = \"relax\"\n\
         [[drive]]\njoint = \"J11\"\nid = 7\nsign = -1\noffset = 10\nlimits = [-90, 120]\n",
    );
    let description = parse_for_servos("robot.toml", text.as_bytes(), &SERVOS).expect("good");
    let bus = description.bus().expect("a bus");
    assert_eq!(bus.port.as_deref(), Some("/dev/ttyUSB0"));
    assert_eq!((bus.baud, bus.silence), (4_500_000, 3));
    assert_eq!(bus.relaxes, [true, false]);
    let [drive] = &bus.drives[..] else {
        panic!("one drive");
    };
    assert_eq!((drive.id, drive.model.as_str()), (7, "ax-12"));
    assert_eq!((drive.sign, drive.offset, drive.gear), (-1.0, 10.0, 1.0));
    assert_eq!(drive.limits, Range::new(-90.0, 120.0));
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
        ("[bus]\nservo = \"AX-13\"\n", "5:9: `servo` cannot be this"),
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
            "7:9: the motor would have to turn to -180 deg, and goes from -150 to 150 deg: look at sign, offset and gear, or narrow the limits",
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
            "10:10: no torque limit is above 1",
        ),
    ] {
        assert_eq!(faults(more), [expected], "{more}");
    }
}
