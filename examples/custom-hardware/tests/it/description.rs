//! The robot description file: what it gives, and what it refuses.

use custom_hardware::description::{Description, DescriptionError};

const FILE: &str = include_str!("../../robot.toml");

fn parsed(text: &str) -> Result<Description, DescriptionError> {
    Description::parse(text)
}

#[test]
fn lengths_and_limits_reach_the_model() {
    let text = FILE.replace("shank = 200.0", "shank = 180.0").replace(
        "offset = 90.0\nlimits = [5.0, 150.0]",
        "offset = 90.0\nlimits = [10.0, 140.0]",
    );
    let model = parsed(&text).unwrap().model();
    assert_eq!(
        model.legs[0].joints[2].link,
        [-180.0, 0.0, 0.0],
        "left legs point to −x"
    );
    assert_eq!(model.legs[1].joints[2].link, [180.0, 0.0, 0.0]);
    assert_eq!(model.legs[0].joints[2].limits.max, 140.0);
    assert_eq!(model.legs[1].joints[2].limits.max, 150.0);
}

#[test]
fn an_angle_survives_the_way_to_the_servo_and_back() {
    let robot = parsed(FILE).unwrap();
    for joint in robot.joints.iter().flatten() {
        let counts = robot.servos.counts(joint, 37.5);
        assert!(
            (robot.servos.angle(joint, counts) - 37.5).abs() < 1e-9,
            "{}",
            joint.name
        );
    }
}

#[test]
fn sign_and_offset_turn_a_joint_angle_into_a_motor_angle() {
    let robot = parsed(FILE).unwrap();
    // J13: motor = −1 × 45 + 90 = 45 deg, an eighth of 4096 counts behind the middle 2048.
    assert_eq!(robot.servos.counts(&robot.joints[0][2], 45.0), 2560.0);
}

#[test]
fn joints_are_found_by_name_in_any_order() {
    let swapped = FILE
        .replace("\"J11\"", "\"J??\"")
        .replace("\"J12\"", "\"J11\"")
        .replace("\"J??\"", "\"J12\"");
    // Both joints fit each other's servo, so that only the places change.
    let text = swapped.replace("[-60.0, 75.0]", "[-60.0, 60.0]");
    assert_eq!(parsed(&text).unwrap().joints[0][0].servo, 12);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let cases = [
        (
            "name = \"J11\"",
            "name = \"J12\"",
            "joint J11 must be described once",
        ),
        ("servo = 12\n", "servo = 11\n", "servo 11 drives two joints"),
        ("sign = -1", "sign = 0", "J13: sign must be 1 or -1"),
        (
            "[5.0, 150.0]",
            "[150.0, 5.0]",
            "J13: limits must lie inside outer",
        ),
        (
            "[5.0, 150.0]",
            "[nan, 150.0]",
            "J13: limits must lie inside outer",
        ),
        (
            "offset = 90.0",
            "offset = 250.0",
            "J13: the servo cannot turn that far",
        ),
        (
            "hip = 50.0",
            "hip = 0.0",
            "lengths: every length must be above 0",
        ),
    ];
    for (from, to, message) in cases {
        let error = parsed(&FILE.replacen(from, to, 1)).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn a_misspelt_key_is_named() {
    let error = parsed(&FILE.replacen("offset =", "ofset =", 1)).unwrap_err();
    assert!(error.to_string().contains("ofset"), "{error}");
}
