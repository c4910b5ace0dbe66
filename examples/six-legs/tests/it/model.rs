//! The description makes the robot that it draws: feet worked out by hand from lengths and angles.

use six_legs::HEXAPOD;
use tip_runtime::kinematics::Chain;

/// Returns the position of foot `leg` (F1 is 1) at these joint angles (deg), mm.
fn foot(leg: usize, angles: [f64; 3]) -> [f64; 3] {
    Chain::new(&HEXAPOD.legs[leg - 1], &angles).foot()
}

fn assert_at(foot: [f64; 3], expected: [f64; 3]) {
    for (is, should) in foot.iter().zip(expected) {
        assert!((is - should).abs() < 1e-3, "{foot:?}, not {expected:?}");
    }
}

#[test]
fn every_foot_stands_at_the_height_of_the_belly_at_first() {
    // Out by hip and thigh, 50 + 120 mm, and down by the shank, 140 mm.
    let expected = [
        [-290.0, 260.0, -140.0],
        [290.0, 260.0, -140.0],
        [-330.0, 0.0, -140.0],
        [330.0, 0.0, -140.0],
        [-290.0, -260.0, -140.0],
        [290.0, -260.0, -140.0],
    ];
    for (leg, expected) in (1..).zip(expected) {
        assert_at(foot(leg, HEXAPOD.legs[leg - 1].initial), expected);
    }
    assert_eq!(HEXAPOD.body.map(|body| body.z.min), Some(-140.0));
}

#[test]
fn a_positive_yaw_brings_the_foot_forward_on_either_side() {
    // 170 mm from the yaw axis, 30 deg forward: 147.224 mm out, 85 mm ahead.
    assert_at(foot(1, [30.0, 0.0, 90.0]), [-267.224, 345.0, -140.0]);
    assert_at(foot(6, [30.0, 0.0, 90.0]), [267.224, -175.0, -140.0]);
}

#[test]
fn a_positive_thigh_raises_and_a_positive_knee_lowers() {
    // r = 50 + 120 cos 30 + 140 cos -30 = 275.167; z = 120 sin 30 + 140 sin -30 = -10.
    assert_at(foot(4, [0.0, 30.0, 60.0]), [435.167, 0.0, -10.0]);
    // r = 50 + 120 cos -60 + 140 cos -90 = 110; z = 120 sin -60 - 140 = -243.923.
    assert_at(foot(3, [0.0, -60.0, 30.0]), [-270.0, 0.0, -243.923]);
    // r = 50 + 120 cos 30 + 140 = 293.923, turned back by 30 deg; z = 120 sin 30 = 60.
    assert_at(foot(2, [-30.0, 30.0, 30.0]), [374.545, 113.038, 60.0]);
}
