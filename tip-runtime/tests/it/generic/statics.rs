//! Forces at the foot and the joint torques that balance them.

use crate::generic::shapes::{Z, every_shape};
use tip_runtime::kinematics::{Chain, LegPoint};
use tip_runtime::model::{Joint, Leg, Model};

const SPACE: [bool; 3] = [true; 3];

#[test]
fn a_force_is_felt_again_in_the_torques_that_make_it() {
    fn feels<const L: usize, const J: usize>(model: &Model<L, J>) {
        for leg in &model.legs {
            let chain = Chain::new(leg, &leg.initial);
            // What the joints feel of any force is a force that needs no more of them.
            let torques = chain.torques_of_force(LegPoint::Tip, [3.0, -2.0, 5.0]);
            let torques = torques.expect("a tip");
            let felt = chain.force_of_torques(LegPoint::Tip, &torques, SPACE);
            let felt = felt.expect("not singular");
            let again = chain.torques_of_force(LegPoint::Tip, felt).expect("a tip");
            for (again, torque) in again.iter().zip(torques) {
                assert!((again - torque).abs() < 1e-9);
            }
            if J >= 3 {
                let off = [felt[0] - 3.0, felt[1] + 2.0, felt[2] - 5.0];
                assert!(length(off) < 1e-6, "{felt:?}");
            } else {
                assert!(length(felt) <= 38.0_f64.sqrt() + 1e-9);
            }
        }
    }
    every_shape!(feels);
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|part| part * part).sum::<f64>().sqrt()
}

#[test]
fn nothing_is_felt_by_a_joint_that_the_foot_does_not_turn_about() {
    let upright = Leg::at([0.0; 3], [Joint::revolute(Z, [0.0, 0.0, 100.0])]);
    let felt = Chain::new(&upright, &[0.0]).force_of_torques(LegPoint::Tip, &[1.0], SPACE);
    assert_eq!(felt, None);
}

/// The Gram determinant of two links of 100 mm that are bent by β is (10⁴ sin β)² mm⁴, that of a
/// sphere of the same trace 25000² mm⁴ as long as β is small: their ratio is 10⁻⁸ at 0.01432 deg.
#[test]
fn two_links_lose_a_direction_of_force_when_they_are_stretched_out() {
    let link = Joint::revolute(Z, [100.0, 0.0, 0.0]);
    let leg = Leg::at([0.0; 3], [link, link]);
    let felt = |bent: f64| {
        Chain::new(&leg, &[0.0, bent]).force_of_torques(LegPoint::Tip, &[1.0; 2], SPACE)
    };
    assert_eq!(felt(0.0142), None);
    assert!(felt(0.0144).is_some());
    assert_eq!(felt(-0.0142), None);
    assert!(felt(-0.0144).is_some());
}
