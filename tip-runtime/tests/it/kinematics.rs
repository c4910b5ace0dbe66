//! Forward and inverse kinematics and Jacobians of TITAN VIII's legs.

use tip_runtime::kinematics::{Chain, LegPoint, frames, inverse, within_limits};
use tip_runtime::model::{Inverse, Leg, Range, titan8};
use tip_runtime::random::Random;

const LEGS: [Leg<3>; 4] = titan8::MODEL.legs;

fn solve(leg: &Leg<3>, foot: [f64; 3]) -> Option<[f64; 3]> {
    inverse(Inverse::YawPitchPitch, leg, foot)
}

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}

/// Returns the side (−1 left) and the end (−1 rear) on which a leg stands.
fn corner(leg: &Leg<3>) -> (f64, f64) {
    (leg.base[0].signum(), leg.base[1].signum())
}

/// Returns r = L1 + L2 cos J2 + L3 cos(J2 − J3), z = L2 sin J2 + L3 sin(J2 − J3); yaw turns
/// forward.
fn closed_form(leg: &Leg<3>, [yaw, thigh, knee]: [f64; 3]) -> [f64; 3] {
    let (side, _) = corner(leg);
    let (thigh, shank) = (thigh.to_radians(), (thigh - knee).to_radians());
    let r = 50.0 + 240.0 * libm::cos(thigh) + 200.0 * libm::cos(shank);
    let z = 240.0 * libm::sin(thigh) + 200.0 * libm::sin(shank);
    let yaw = yaw.to_radians();
    [
        leg.base[0] + side * r * libm::cos(yaw),
        leg.base[1] + r * libm::sin(yaw),
        z,
    ]
}

// clauses: 7.17
#[test]
fn forward_agrees_with_the_written_out_formula() {
    let mut random = Random::new(1);
    for leg in &LEGS {
        for _ in 0..500 {
            let angles = leg
                .joints
                .map(|joint| random.within(joint.limits.min, joint.limits.max));
            let foot = Chain::new(leg, &angles).foot();
            assert!(close(foot, closed_form(leg, angles), 1e-9), "{angles:?}");
        }
    }
}

/// A frame begins at its joint; joint axis and link, given in it, lead to the next one.
#[test]
fn frames_of_links_are_where_the_chain_is() {
    let mut random = Random::new(2);
    for leg in &LEGS {
        for _ in 0..100 {
            let angles = leg
                .joints
                .map(|joint| random.within(joint.limits.min, joint.limits.max));
            let chain = Chain::new(leg, &angles);
            let ends = chain.joints().skip(1).chain([chain.foot()]);
            let links = frames(leg.base, &leg.joints, &angles).zip(&leg.joints);
            let mut before = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            for ((place, end), (frame, joint)) in chain.joints().zip(ends).zip(links) {
                assert_eq!(frame.at, place);
                assert!(close(frame.point(joint.link), end, 1e-9), "{angles:?}");
                // A joint does not move its own axis.
                let axis = [0, 1, 2].map(|i| (0..3).map(|j| before[j][i] * joint.axis[j]).sum());
                assert!(
                    close(frame.direction(joint.axis), axis, 1e-12),
                    "{angles:?}"
                );
                before = frame.axes;
            }
        }
    }
}

#[test]
fn the_initial_posture_puts_the_feet_where_the_robot_stands() {
    let feet = [
        [-391.0, 201.0, -200.0],
        [391.0, 201.0, -200.0],
        [-391.0, -201.0, -200.0],
        [391.0, -201.0, -200.0],
    ];
    for (leg, foot) in LEGS.iter().zip(feet) {
        assert!(close(Chain::new(leg, &leg.initial).foot(), foot, 1e-9));
    }
}

#[test]
fn joints_stand_at_hip_and_at_the_ends_of_the_links() {
    let places: Vec<_> = Chain::new(&LEGS[1], &[0.0, 0.0, 90.0]).joints().collect();
    assert!(close(places[0], [101.0, 201.0, 0.0], 1e-12));
    assert!(close(places[1], [151.0, 201.0, 0.0], 1e-12));
    assert!(close(places[2], [391.0, 201.0, 0.0], 1e-12));
    assert_eq!(Chain::new(&LEGS[1], &[0.0; 3]).joint(3), None);
}

#[test]
fn inverse_gives_the_known_angles() {
    let right = &LEGS[1];
    let known = [
        ([391.0, 201.0, -200.0], [0.0, 0.0, 90.0]),
        ([391.0, 301.0, -250.0], [19.0, -12.3, 71.3]),
        ([301.0, 201.0, -200.0], [0.0, -5.0, 111.4]),
    ];
    for (foot, angles) in known {
        let solved = solve(right, foot).expect("reachable");
        assert!(close(solved, angles, 0.05), "{foot:?}: {solved:?}");
    }
}

#[test]
fn every_foot_of_the_gait_is_reachable_within_its_known_angles() {
    let ranges = [
        Range::new(-19.05, 19.05),
        Range::new(-12.35, 12.05),
        Range::new(71.25, 100.55),
    ];
    for leg in &LEGS {
        let (side, end) = corner(leg);
        for y in 0..=20 {
            for z in 0..=10 {
                let y = end * (101.0 + 10.0 * f64::from(y));
                let foot = [side * 391.0, y, -250.0 + 10.0 * f64::from(z)];
                let angles = solve(leg, foot).expect("reachable");
                assert!(within_limits(leg, &angles));
                for (range, angle) in ranges.iter().zip(angles) {
                    assert!(range.contains(angle), "{foot:?}: {angles:?}");
                }
            }
        }
    }
}

#[test]
fn inverse_undoes_forward_over_the_workspace() {
    let mut random = Random::new(2);
    for leg in &LEGS {
        let mut solved = 0;
        for _ in 0..5000 {
            let angles = leg
                .joints
                .map(|joint| random.within(joint.limits.min, joint.limits.max));
            // Behind its own hip the foot looks like that of a leg turned round.
            let [_, thigh, knee] = angles.map(f64::to_radians);
            if 50.0 + 240.0 * libm::cos(thigh) + 200.0 * libm::cos(thigh - knee) < 1.0 {
                continue;
            }
            let foot = Chain::new(leg, &angles).foot();
            let back = solve(leg, foot).expect("a foot that is there is reachable");
            assert!(close(back, angles, 1e-6), "{angles:?} became {back:?}");
            solved += 1;
        }
        assert!(solved > 4000);
    }
}

#[test]
fn forward_undoes_inverse_and_the_reach_ends_where_the_links_do() {
    let mut random = Random::new(3);
    let leg = &LEGS[1];
    let (mut near, mut far) = (0, 0);
    for _ in 0..5000 {
        let foot = [
            random.within(0.0, 700.0),
            random.within(-300.0, 700.0),
            random.within(-500.0, 500.0),
        ];
        let level = libm::hypot(foot[0] - 101.0, foot[1] - 201.0) - 50.0;
        let reach = libm::hypot(level, foot[2]);
        match solve(leg, foot) {
            Some(angles) => {
                assert!((40.0 - 1e-6..=440.0 + 1e-6).contains(&reach));
                assert!(close(Chain::new(leg, &angles).foot(), foot, 1e-8));
                near += 1;
            }
            None => {
                assert!(!(40.0 + 1e-6..=440.0 - 1e-6).contains(&reach));
                far += 1;
            }
        }
    }
    assert!(near > 500 && far > 500);
}

#[test]
fn nonsense_has_no_inverse() {
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        assert_eq!(solve(&LEGS[0], [bad, 0.0, -200.0]), None);
        assert_eq!(solve(&LEGS[0], [-391.0, 201.0, bad]), None);
    }
}

#[test]
fn a_foot_under_the_body_takes_more_yaw_than_there_is() {
    let leg = &LEGS[0];
    let angles = solve(leg, [100.0, -100.0, 0.0]).expect("the links are long enough");
    assert!(!within_limits(leg, &angles));
}

#[test]
fn full_stretch_is_still_reachable() {
    let leg = &LEGS[1];
    let angles = solve(leg, [101.0 + 490.0, 201.0, 0.0]).expect("just reachable");
    assert!(close(angles, [0.0; 3], 1e-4));
    assert!(!within_limits(leg, &angles), "the knee does not straighten");
    assert_eq!(solve(leg, [101.0 + 490.001, 201.0, 0.0]), None);
}

#[test]
fn a_leg_folded_together_is_still_reachable() {
    let leg = &LEGS[1];
    for thigh in -9..=9 {
        for yaw in -3..=3 {
            let posture = [20.0 * f64::from(yaw), 10.0 * f64::from(thigh), 180.0];
            let foot = closed_form(leg, posture);
            let angles = solve(leg, foot).expect("just reachable");
            assert!(close(Chain::new(leg, &angles).foot(), foot, 1e-5));
        }
    }
    assert_eq!(solve(leg, [101.0 + 50.0 + 39.999, 201.0, 0.0]), None);
}

#[test]
fn a_thigh_that_points_backwards_is_told_within_half_a_turn() {
    // Thigh back over the hip, shank forward again: the foot is 7 mm away from the yaw axis.
    let posture = [0.0, -170.0, 175.0];
    let angles = solve(&LEGS[1], closed_form(&LEGS[1], posture));
    assert!(close(angles.expect("reachable"), posture, 1e-9));
}

#[test]
fn limits_include_their_ends() {
    let leg = &LEGS[0];
    assert!(within_limits(leg, &[60.0, -60.0, 150.0]));
    assert!(within_limits(leg, &[-60.0, 75.0, 5.0]));
    assert!(!within_limits(leg, &[60.1, 0.0, 90.0]));
    assert!(!within_limits(leg, &[0.0, -60.1, 90.0]));
    assert!(!within_limits(leg, &[0.0, 0.0, 4.9]));
    assert!(!within_limits(leg, &[f64::NAN, 0.0, 90.0]));
}

#[test]
fn jacobians_agree_with_differences() {
    let mut random = Random::new(4);
    let h = 1e-4_f64;
    for leg in &LEGS {
        for _ in 0..200 {
            let angles = leg
                .joints
                .map(|joint| random.within(joint.limits.min, joint.limits.max));
            let chain = Chain::new(leg, &angles);
            for j in 0..3 {
                let (mut more, mut less) = (angles, angles);
                more[j] += h;
                less[j] -= h;
                let (more, less) = (Chain::new(leg, &more), Chain::new(leg, &less));
                let step = 2.0 * h.to_radians();
                let foot = chain.foot_jacobian();
                for (i, (a, b)) in more.foot().iter().zip(less.foot()).enumerate() {
                    assert!((foot[j][i] - (a - b) / step).abs() < 1e-4);
                }
                for m in 0..3 {
                    let jacobian = chain
                        .point_jacobian(LegPoint::Joint(m))
                        .expect("such a joint");
                    let (more, less) = (more.joint(m).unwrap(), less.joint(m).unwrap());
                    for (i, (a, b)) in more.iter().zip(less).enumerate() {
                        assert!((jacobian[j][i] - (a - b) / step).abs() < 1e-4);
                    }
                }
            }
            assert_eq!(chain.point_jacobian(LegPoint::Joint(3)), None);
        }
    }
}

#[test]
fn joint_rates_give_the_foot_its_velocity() {
    let leg = &LEGS[2];
    let chain = Chain::new(leg, &[10.0, -5.0, 80.0]);
    let wanted = [30.0, -20.0, 50.0];
    let rates = chain
        .point_rates(LegPoint::Tip, wanted, [true; 3])
        .expect("not singular");
    assert!(close(
        chain.point_velocity(LegPoint::Tip, &rates).expect("a foot"),
        wanted,
        1e-9
    ));
    let stretched = Chain::new(leg, &[0.0, 0.0, 0.0]);
    assert_eq!(
        stretched.point_rates(LegPoint::Tip, [1.0, 0.0, 0.0], [true; 3]),
        None
    );
}
