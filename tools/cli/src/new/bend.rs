//! A motion for any robot: one leg or finger after the other bends its joints.

use super::template::fill;
use tip_runtime::command::Target;
use tip_sim::{Anatomy, Limb};

/// How far a joint turns, if it can: deg.
const TURN: f64 = 15.0;
/// How much of its room to a limit it takes at most.
const SHARE: f64 = 0.8;

/// The text of the program.
pub(super) fn program(anatomy: &Anatomy) -> String {
    let numbered = (1..).zip(&anatomy.legs);
    let legs = numbered.map(|(number, limb)| one(Target::Foot(number), limb));
    let begin = include_str!("../../templates/motions/bend.prg");
    let end = include_str!("../../templates/motions/bend_end.prg");
    format!("{begin}{}{end}", legs.collect::<String>())
}

/// The lines of a leg.
fn one(leg: Target, limb: &Limb) -> String {
    let holes = [
        ("leg", &*leg.to_string()),
        ("bent", &degrees(&bent(limb))),
        ("initial", &degrees(&limb.initial)),
    ];
    fill(include_str!("../../templates/motions/bend_leg.prg"), &holes)
}

fn degrees(angles: &[f64]) -> String {
    let words: Vec<String> = angles.iter().map(f64::to_string).collect();
    words.join(" ")
}

/// Each joint turned from the initial posture: to the side that raises the foot, else to the side with more room.
fn bent(limb: &Limb) -> Vec<f64> {
    let turned = |place: usize, angle: f64| {
        let mut angles = limb.initial.clone();
        angles[place] = angle;
        angles
    };
    let height = |place, angle| limb.foot(&turned(place, angle))[2];
    let joints = limb.joints.iter().zip(&limb.initial).enumerate();
    let bent = joints.map(|(place, (joint, initial))| {
        let [down, up] = [joint.limits.min - initial, joint.limits.max - initial];
        let [down, up] = [down, up].map(|room| room.clamp(-TURN / SHARE, TURN / SHARE) * SHARE);
        let [down, up] = [initial + down, initial + up];
        let gain = height(place, up) - height(place, down);
        let has_room = (up - initial) >= (initial - down);
        let is_up = if gain.abs() > 1e-6 {
            gain > 0.0
        } else {
            has_room
        };
        let angle = if is_up { up } else { down };
        // A program that people read has tenths.
        (angle * 10.0).round() / 10.0
    });
    bent.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tip_sim::Robot;

    fn anatomy(joints: &str, initial: &str) -> Anatomy {
        let text = format!(
            "name = \"ours\"\njoint = [{joints}]\nleg = [{{ base = [0, 100, 0] }}]\ninitial = [{initial}]\n"
        );
        Robot::description(&text).expect("a description").anatomy()
    }

    #[test]
    fn joints_turn_to_where_the_foot_rises() {
        // A positive turn about -y raises what points along x; at the limit of 5 deg there is only the other side.
        let limb = &anatomy(
            "{ axis = \"-y\", link = [100, 0, 0], limits = [-60, 60] },
             { axis = \"y\", link = [100, 0, 0], limits = [-60, 60] },
             { axis = \"z\", link = [100, 0, 0], limits = [-60, 5] }",
            "0, 0, 0",
        )
        .legs[0];
        assert_eq!(bent(limb), [15.0, -15.0, -15.0]);
    }

    #[test]
    fn a_joint_stays_within_its_limits() {
        let limb = &anatomy(
            "{ axis = \"z\", link = [100, 0, 0], limits = [-10, 2] }",
            "0",
        )
        .legs[0];
        assert_eq!(bent(limb), [-8.0]);
    }
}
