//! Robots that stand as high as they are asked to, by trigonometry of their figures.

use tip_sim::import::{ImportOptions, import_with};
use tip_sim::urdf::export;
use tip_sim::{Robot, RobotDescription};

/// Exports a robot, and imports it to stand at a height, mm.
fn standing(robot: &Robot, height: f64) -> Result<RobotDescription, String> {
    let options = ImportOptions {
        stand: Some(height),
        ..ImportOptions::default()
    };
    let import = import_with("test.urdf", &export(robot), &options);
    let import = import.map_err(|error| error.to_string())?;
    let said = format!("has all feet {height} mm below the robot frame");
    assert!(
        import
            .report
            .iter()
            .any(|it| it.to_string().contains(&said))
    );
    let robot = Robot::from_description(&import.toml);
    Ok(robot.map_err(|faults| faults.to_string())?.description())
}

#[track_caller]
fn near(ours: &[f64], expected: &[f64]) {
    let apart = ours.iter().zip(expected).map(|(a, b)| (a - b).abs());
    assert!(
        ours.len() == expected.len() && apart.fold(0.0, f64::max) < 1e-4,
        "{ours:?} is not {expected:?}"
    );
}

#[test]
fn a_quadruped_stands_on_feet_below_its_thighs() {
    let a1 = Robot::named("a1").expect("it is published");
    let robot = standing(&a1, 280.0).unwrap_or_else(|error| panic!("{error}"));
    // Thigh and calf, 200 mm each, make a triangle with equal sides.
    let half = (140.0_f64 / 200.0).acos().to_degrees();
    for leg in &robot.legs {
        near(&leg.initial, &[0.0, half, -2.0 * half]);
    }
    let x = 47.0 + 83.8;
    for (foot, (x, y)) in
        robot
            .feet
            .iter()
            .zip([(-x, 180.5), (x, 180.5), (-x, -180.5), (x, -180.5)])
    {
        near(foot, &[x, y, -280.0]);
    }
}

/// A quadruped whose knees may bend either way, with the axes of its left legs turned round.
const EITHER_WAY: &str = r#"
name = "either"
joint = [
    { axis = "y", link = [50, 0, 0] },
    { axis = "x", link = [0, 0, -100] },
    { axis = "x", link = [0, 0, -120] },
]
leg = [
    { base = [-40, 100, 0], mirror = "x" },
    { base = [40, 100, 0] },
    { base = [-40, -100, 0], joint = [
        { axis = "-y", link = [-50, 0, 0] },
        { axis = "-x", link = [0, 0, -100] },
        { axis = "-x", link = [0, 0, -120] },
    ] },
    { base = [40, -100, 0] },
]
[body]
x = [-40, 40]
y = [-120, 120]
z = [-30, 30]
"#;

#[test]
fn all_knees_bend_backwards_where_they_may_bend_either_way() {
    let robot = Robot::from_description(EITHER_WAY).expect("a robot");
    let robot = standing(&robot, 180.0).unwrap_or_else(|error| panic!("{error}"));
    // The law of cosines; about x a positive angle swings the leg ahead.
    let cosine = (100.0_f64 * 100.0 + 180.0 * 180.0 - 120.0 * 120.0) / (2.0 * 100.0 * 180.0);
    let back = 100.0 * cosine.acos().sin();
    for leg in &robot.legs {
        let knee = leg.frames(&leg.initial)[1].point(leg.joints[1].link);
        near(&knee[1..], &[leg.base[1] - back, -100.0 * cosine]);
    }
}

#[test]
fn feet_come_nearer_where_straight_legs_would_not_reach_the_floor() {
    // TITAN's legs point outwards at 0: 490 mm do not reach 200 mm down out there.
    let titan = Robot::named("titan8").expect("it is built in");
    let robot = standing(&titan, 200.0).unwrap_or_else(|error| panic!("{error}"));
    let outward = robot.feet[1][0] - robot.legs[1].base[0];
    // An eighth nearer it does.
    near(&robot.feet[1], &[101.0 + 490.0 * 7.0 / 8.0, 201.0, -200.0]);
    assert!(outward.hypot(200.0) < 490.0);
}

#[test]
fn a_height_out_of_reach_is_refused_with_one_that_is_not() {
    let a1 = Robot::named("a1").expect("it is published");
    // Its calf bends by 52.5 deg at least; the hip rolls until the foot is below it.
    let most = (400.0 * 26.25_f64.to_radians().cos()).hypot(83.8);
    assert!(standing(&a1, most.floor()).is_ok());
    let error = standing(&a1, most.ceil()).expect_err("too high");
    assert!(
        error.contains("no posture within the limits puts all feet 369 mm"),
        "{error}"
    );
    let near = error
        .split("`--stand ")
        .nth(1)
        .and_then(|rest| rest.split('`').next());
    let near: f64 = near.expect("a height").parse().expect("a number");
    assert!(near < most && standing(&a1, near).is_ok(), "{near}");

    let hand = Robot::named("hand").expect("it is built in");
    let error = standing(&hand, 100.0).expect_err("it is bolted down");
    assert!(
        error.contains("`--stand` is for a robot that walks"),
        "{error}"
    );

    // Legs that point upwards, and hardly turn.
    let turned = EITHER_WAY
        .replace("link = [0, 0, -", "limits = [-9, 9], link = [0, 0, ")
        .replace("link = [50", "limits = [-9, 9], link = [50")
        .replace("link = [-50", "limits = [-9, 9], link = [-50");
    let robot = Robot::from_description(&turned).expect("a robot");
    let error = standing(&robot, 100.0).expect_err("its feet are above");
    assert!(error.contains("leave `--stand` out"), "{error}");
}
