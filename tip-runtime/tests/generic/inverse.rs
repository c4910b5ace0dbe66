//! Damped least squares on any chain.

use crate::shapes::{ARM, PENDULUM};
use tip_runtime::kinematics::{Chain, inverse, within_limits};
use tip_runtime::model::Inverse;

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

#[test]
fn an_arm_of_six_joints_reaches_points_in_space_within_its_limits() {
    let arm = &ARM.legs[0];
    for angles in [
        [10.0, -20.0, 30.0, 5.0, 30.0, 0.0],
        [-90.0, -60.0, 60.0, 40.0, -20.0, 90.0],
        [150.0, 20.0, -40.0, -100.0, 80.0, -120.0],
    ] {
        let target = Chain::new(arm, &angles).foot();
        let found = inverse(Inverse::LeastSquares, arm, target).expect("reachable");
        assert!(distance(Chain::new(arm, &found).foot(), target) < 1e-6);
        assert!(within_limits(arm, &found));
    }
}

#[test]
fn a_single_joint_reaches_its_arc_and_nothing_else() {
    let leg = &PENDULUM.legs[0];
    let on_arc = Chain::new(leg, &[-35.0]).foot();
    let [found] = inverse(Inverse::LeastSquares, leg, on_arc).expect("on the arc");
    assert!((found + 35.0).abs() < 1e-6, "{found}");
    let [x, y, z] = on_arc;
    for beside in [[x + 1.0, y, z], [x, y, z + 1.0], [x, y - 1.0, z]] {
        assert_eq!(inverse(Inverse::LeastSquares, leg, beside), None);
    }
}
