//! The motion of robots that cannot walk: legs that bend their joints in turn.

use crate::new::fill;
use tip_runtime::command::Target;
use tip_sim::{Limb, Limit, Robot, RobotDescription, Run, load};

/// Angle that joints turn, if they can, deg.
pub(super) const BEND_ANGLE: f64 = 15.0;
/// Angles that are tried on a robot that may fall, deg.
pub(super) const BEND_ANGLES: [f64; 3] = [BEND_ANGLE, 6.0, 3.0];
/// Maximum share of the way to a limit.
const SHARE: f64 = 0.8;

/// Returns a program that turns each joint by an angle, deg.
pub(super) fn program(description: &RobotDescription, turn: f64) -> String {
    let numbered = (1..).zip(&description.legs);
    let legs = numbered.map(|(number, limb)| bend_leg(Target::Foot(number), limb, turn));
    let begin = include_str!("../../templates/motions/bend.prg");
    let end = include_str!("../../templates/motions/bend_end.prg");
    format!("{begin}{}{end}", legs.collect::<String>())
}

/// Runs the program; returns the number of falls.
pub(super) fn count_falls(program: &str, robot: &Robot) -> u32 {
    /// Maximum number of control cycles.
    const LONGEST: u64 = 20_000;
    let Ok(loaded) = load("bend.prg", program, robot) else {
        return 0;
    };
    let Ok(mut run) = Run::new(loaded, robot.clone()) else {
        return 0;
    };
    run.to_end(Limit::cycles(LONGEST));
    run.motion().map_or(0, |motion| motion.falls)
}

/// Returns the lines for a leg.
fn bend_leg(leg: Target, limb: &Limb, turn: f64) -> String {
    let placeholders = [
        ("leg", &*leg.to_string()),
        ("bent", &degrees(&bent_angles(limb, turn))),
        ("initial", &degrees(&limb.initial)),
    ];
    fill(
        include_str!("../../templates/motions/bend_leg.prg"),
        &placeholders,
    )
}

fn degrees(angles: &[f64]) -> String {
    // A program that people read has hundredths.
    let rounded = angles.iter().map(|angle| (angle * 100.0).round() / 100.0);
    let words: Vec<String> = rounded.map(|angle| angle.to_string()).collect();
    words.join(" ")
}

/// Returns the bent angles of a leg: each joint turns to the side that raises the foot, else to the side with more room.
fn bent_angles(limb: &Limb, turn: f64) -> Vec<f64> {
    let turned = |place: usize, angle: f64| {
        let mut angles = limb.initial.clone();
        angles[place] = angle;
        angles
    };
    let height = |place, angle| limb.foot(&turned(place, angle))[2];
    let joints = limb.joints.iter().zip(&limb.initial).enumerate();
    let bent = joints.map(|(place, (joint, initial))| {
        let [down, up] = [joint.limits.min - initial, joint.limits.max - initial];
        let [down, up] = [down, up].map(|room| room.clamp(-turn / SHARE, turn / SHARE) * SHARE);
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

    fn description(joints: &str, initial: &str) -> RobotDescription {
        let text = format!(
            "name = \"ours\"\njoint = [{joints}]\nleg = [{{ base = [0, 100, 0] }}]\ninitial = [{initial}]\n"
        );
        Robot::from_description(&text)
            .expect("a description")
            .description()
    }

    #[test]
    fn joints_turn_to_where_the_foot_rises() {
        // A positive turn about -y raises what points along x; at the limit of 5 deg there is only the other side.
        let limb = &description(
            "{ axis = \"-y\", link = [100, 0, 0], limits = [-60, 60] },
             { axis = \"y\", link = [100, 0, 0], limits = [-60, 60] },
             { axis = \"z\", link = [100, 0, 0], limits = [-60, 5] }",
            "0, 0, 0",
        )
        .legs[0];
        assert_eq!(bent_angles(limb, 15.0), [15.0, -15.0, -15.0]);
        assert_eq!(bent_angles(limb, 2.0), [2.0, -2.0, 2.0]);
    }

    #[test]
    fn a_joint_stays_within_its_limits() {
        let limb = &description(
            "{ axis = \"z\", link = [100, 0, 0], limits = [-10, 2] }",
            "0",
        )
        .legs[0];
        assert_eq!(bent_angles(limb, 15.0), [-8.0]);
    }
}
