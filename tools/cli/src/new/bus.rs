//! The bus of a new robot in its description: a servo for each joint, to be changed to what was built.

use crate::input::servos;
use std::fmt::Write as _;
use tip_runtime::model::Range;
use tip_sim::Robot;
use tipc::description;

/// The servo of robots that have no known one.
const SERVO: &str = "STS3215";
/// Published robots with other servos.
const KNOWN: [(&str, &str); 1] = [("phantomx", "AX-12")];

/// Returns a description with a bus, if it has none.
pub(super) fn with_bus(mut text: Vec<u8>) -> Vec<u8> {
    let Some(robot) = description::parse("robot.toml", &text)
        .ok()
        .filter(|description| description.bus().is_none())
        .map(|description| Robot::described(&description))
    else {
        return text;
    };
    let known = KNOWN.iter().find(|(name, _)| *name == robot.name());
    let name = known.map_or(SERVO, |(_, servo)| *servo);
    let travel = servos()
        .iter()
        .find(|servo| servo.name == name)
        .map(|servo| servo.travel);
    text.extend(bus(&robot, name, travel.unwrap_or(Range::new(-180.0, 180.0))).into_bytes());
    text
}

fn bus(robot: &Robot, servo: &str, travel: Range) -> String {
    let mut text = format!(
        "\n# The real robot: docs/drives.md. Replace what is here by what you built; `tip drives id` sets identities,
# `tip drives zero` finds signs and offsets.
[bus]
port = \"simulated\"   # later, for example, \"/dev/ttyUSB0\"
servo = \"{servo}\"
voltage = [9, 13]
"
    );
    let anatomy = robot.anatomy();
    let mut id = 0;
    for (leg, limb) in (1..).zip(&anatomy.legs) {
        for (number, joint) in (1..).zip(&limb.joints) {
            id += 1;
            let Range { min, max } = joint.limits;
            let fits = |offset: f64| travel.contains(min + offset) && travel.contains(max + offset);
            // In the middle of the travel, unless the joint's zero can be there.
            let offset = if fits(0.0) {
                0.0
            } else {
                -((min + max) / 2.0).round()
            };
            // Writing to a String cannot fail.
            let _ = write!(
                text,
                "\n[[drive]]\njoint = \"J{leg}{number}\"\nid = {id}\nsign = 1\noffset = {offset}\n"
            );
            if !fits(offset) {
                let half = (travel.max - travel.min) / 2.0 - 1.0;
                let (min, max) = (-offset - half, -offset + half);
                let _ = writeln!(
                    text,
                    "limits = [{:.0}, {:.0}]   # all that the servo can do",
                    min.ceil(),
                    max.floor()
                );
            }
        }
    }
    text
}
