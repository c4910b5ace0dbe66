//! The targets, flags and inputs of a robot, by their names.

use tip_runtime::command::{Flag, Port, Target};
use tipc::Robot;
use tipc::language::Bilingual;
use tipc::language::commands::{Joints, Targets};
use tipc::language::flags::{self, FLAGS};
use tipc::language::inputs::INPUTS;

/// The targets of a robot that a command can have.
pub(crate) fn targets(of: Targets, robot: Robot) -> Vec<Target> {
    let facts = robot.facts();
    let signature = facts.signature;
    let feet = (1..=signature.legs).map(Target::Foot);
    let mut found: Vec<Target> = if of.foot { feet.collect() } else { Vec::new() };
    let joint = match of.joints {
        Joints::None => None,
        Joints::Every => Some(1..=signature.joints),
        Joints::Second => Some(2..=2),
        Joints::Third => Some(3..=3),
        Joints::ThirdOfHand => facts.has_slider.then_some(3..=3),
    };
    for leg in 1..=signature.legs {
        let joints = joint.clone().into_iter().flatten();
        let joints = joints.filter(|joint| *joint <= signature.joints);
        found.extend(joints.map(|joint| Target::Joint(leg, joint)));
    }
    found.extend((of.floor && facts.has_slider).then_some(Target::Floor));
    found.extend(of.all.then_some(Target::All));
    found
}

/// The flags of a robot, each with its row.
pub(crate) fn robot_flags(robot: Robot) -> Vec<(Flag, &'static flags::Row)> {
    let rows = FLAGS.iter().filter(|row| row.robots.contains(robot));
    let all = || targets(Targets::ANY, robot).into_iter();
    let each = |row: &'static flags::Row| -> Vec<(Flag, &'static flags::Row)> {
        let flags: Vec<Flag> = match row.flag {
            Flag::Inpos(_) => all().map(Flag::Inpos).collect(),
            Flag::Near(_) => all().map(Flag::Near).collect(),
            Flag::Special(_) => (0..10).map(Flag::Special).collect(),
            flag => vec![flag],
        };
        flags.into_iter().map(|flag| (flag, row)).collect()
    };
    rows.flat_map(each).collect()
}

/// The inputs of a robot, each with what it is.
pub(crate) fn robot_inputs(robot: Robot) -> Vec<(String, Bilingual)> {
    let rows = INPUTS.iter().filter(|row| row.robots.contains(robot));
    let mut found = Vec::new();
    for row in rows {
        let joints = Targets {
            joints: Joints::Every,
            ..Targets::NONE
        };
        let names: Vec<String> = match row.port {
            Port::Joint(..) => targets(joints, robot)
                .iter()
                .map(Target::to_string)
                .collect(),
            port => port.named().map(|port| port.to_string()).collect(),
        };
        found.extend(names.into_iter().map(|name| (name, row.description)));
    }
    found
}
