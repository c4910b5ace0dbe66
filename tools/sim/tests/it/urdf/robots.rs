//! Test robots, as numbers and as the URDF text that holds them.

use std::fmt::Write as _;

/// A joint of a test robot: `fixed` or `revolute`, and the numbers of its origin and axis.
pub(crate) struct Joint {
    pub(crate) name: &'static str,
    pub(crate) kind: &'static str,
    pub(crate) parent: &'static str,
    pub(crate) child: &'static str,
    pub(crate) xyz: [f64; 3],
    pub(crate) rpy: [f64; 3],
    pub(crate) axis: [f64; 3],
}

pub(crate) const fn revolute(
    name: &'static str,
    parent: &'static str,
    child: &'static str,
    [xyz, rpy, axis]: [[f64; 3]; 3],
) -> Joint {
    Joint {
        name,
        kind: "revolute",
        parent,
        child,
        xyz,
        rpy,
        axis,
    }
}

pub(crate) const fn fixed(
    parent: &'static str,
    child: &'static str,
    [xyz, rpy]: [[f64; 3]; 2],
) -> Joint {
    Joint {
        name: child,
        kind: "fixed",
        parent,
        child,
        xyz,
        rpy,
        axis: [1.0, 0.0, 0.0],
    }
}

/// An arm whose every frame is turned against the one before, about axes that are none of the frame's.
pub(crate) const ARM: &[Joint] = &[
    fixed("base", "mount", [[0.1, -0.2, 0.3], [0.2, -0.4, 1.1]]),
    revolute(
        "shoulder",
        "mount",
        "upper",
        [[0.0, 0.1, 0.2], [1.2, 0.3, -0.7], [0.0, 0.0, 1.0]],
    ),
    fixed("upper", "flange", [[0.25, 0.0, 0.05], [0.0, 1.5, 0.4]]),
    revolute(
        "elbow",
        "flange",
        "lower",
        [[0.01, 0.02, 0.03], [-0.5, 0.9, 2.0], [1.0, 2.0, -2.0]],
    ),
    revolute(
        "wrist",
        "lower",
        "hand",
        [[0.0, 0.2, 0.0], [3.0, -1.0, 0.1], [0.0, -3.0, 4.0]],
    ),
    fixed("hand", "tool", [[0.05, 0.06, 0.07], [0.3, 0.2, 0.1]]),
];

/// URDF text of a robot whose links weigh 1, 2, 3 … kg in the order of the joints' children.
pub(crate) fn urdf(joints: &[Joint]) -> String {
    let mut text =
        String::from("<?xml version=\"1.0\"?>\n<robot name=\"test arm\">\n<link name=\"base\"/>\n");
    for (mass, joint) in (1..).zip(joints) {
        let (name, kind, parent, child) = (joint.name, joint.kind, joint.parent, joint.child);
        let [xyz, rpy, axis] =
            [joint.xyz, joint.rpy, joint.axis].map(|[x, y, z]| format!("{x} {y} {z}"));
        write!(
            text,
            "<link name=\"{child}\"><inertial><mass value=\"{mass}\"/><inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/></inertial></link>
<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>
<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><axis xyz=\"{axis}\"/><limit lower=\"-1.5\" upper=\"2\" effort=\"7\" velocity=\"3\"/></joint>\n"
        )
        .unwrap();
    }
    text + "</robot>\n"
}

pub(crate) const PLAIN: [[f64; 3]; 3] = [[0.1, 0.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]];
pub(crate) const TIP: [[f64; 3]; 2] = [[0.1, 0.0, 0.0], [0.0; 3]];

const FRONT: [f64; 3] = [0.2, 0.1, 0.0];
const REAR: [f64; 3] = [-0.2, 0.1, 0.0];
/// A yaw that points the leg's x axis to the left (rad).
const LEFT: f64 = std::f64::consts::FRAC_PI_2;

const fn mirrored([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, -y, z]
}

/// A quadruped as a URDF author writes it: all pitch joints about y of frames that point outward.
const fn leg(names: [&'static str; 7], at: [f64; 3], yaw: f64) -> [Joint; 4] {
    let [hip, thigh, knee, coxa, femur, tibia, foot] = names;
    let none = [0.0; 3];
    [
        revolute(hip, "base", coxa, [at, [0.0, 0.0, yaw], [0.0, 0.0, 1.0]]),
        revolute(
            thigh,
            coxa,
            femur,
            [[0.05, 0.0, 0.0], none, [0.0, 1.0, 0.0]],
        ),
        revolute(knee, femur, tibia, [[0.1, 0.0, 0.0], none, [0.0, 1.0, 0.0]]),
        fixed(tibia, foot, [[0.12, 0.0, 0.0], none]),
    ]
}

pub(crate) fn quadruped() -> Vec<Joint> {
    [
        leg(["h1", "t1", "k1", "c1", "f1", "s1", "e1"], FRONT, LEFT),
        leg(
            ["h2", "t2", "k2", "c2", "f2", "s2", "e2"],
            mirrored(FRONT),
            -LEFT,
        ),
        leg(["h3", "t3", "k3", "c3", "f3", "s3", "e3"], REAR, LEFT),
        leg(
            ["h4", "t4", "k4", "c4", "f4", "s4", "e4"],
            mirrored(REAR),
            -LEFT,
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}
