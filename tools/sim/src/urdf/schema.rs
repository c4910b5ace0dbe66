//! What URDF's elements hold, a table for each of those that a description is made of.

use super::version::Version;

/// An element, its attributes and the elements in it.
pub(super) struct Element {
    pub(super) name: &'static str,
    pub(super) attributes: &'static [Attribute],
    pub(super) children: &'static [Child],
    /// Whether it holds one of its children, and nothing else.
    pub(super) is_choice: bool,
}

/// An attribute: its name, what it holds, whether it has to be there, and an example.
pub(super) struct Attribute {
    pub(super) name: &'static str,
    pub(super) value: Value,
    pub(super) presence: Presence,
    pub(super) example: &'static str,
}

/// An element in another one, how often it may be there, and an example.
pub(super) struct Child {
    pub(super) element: &'static Element,
    pub(super) count: Count,
    pub(super) example: &'static str,
}

/// Whether an attribute has to be there.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Presence {
    Needed,
    /// Since this version it may be left out.
    NeededBefore(Version),
    Optional,
}

/// How often an element may occur in another one.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Count {
    One,
    AtMostOne,
    Any,
}

/// What an attribute holds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Value {
    Text,
    JointKind,
    /// So many numbers.
    Numbers(usize),
    /// So many numbers; since 1.2 above 0.
    Lengths(usize),
    /// A number; not NaN.
    Bound,
    /// A number; not NaN, and since 1.2 not negative.
    Most,
    /// What 1.2 has brought: a number that is not negative.
    MostSince12,
    /// What 1.1 has brought: four numbers.
    Quaternion,
}

const fn holding(
    name: &'static str,
    attributes: &'static [Attribute],
    children: &'static [Child],
) -> Element {
    Element {
        name,
        attributes,
        children,
        is_choice: false,
    }
}

const fn attribute(
    name: &'static str,
    value: Value,
    presence: Presence,
    example: &'static str,
) -> Attribute {
    Attribute {
        name,
        value,
        presence,
        example,
    }
}

const fn needed(name: &'static str, value: Value, example: &'static str) -> Attribute {
    attribute(name, value, Presence::Needed, example)
}

const fn optional(name: &'static str, value: Value, example: &'static str) -> Attribute {
    attribute(name, value, Presence::Optional, example)
}

const fn child(count: Count, element: &'static Element, example: &'static str) -> Child {
    Child {
        element,
        count,
        example,
    }
}

const NAME: Attribute = optional("name", Value::Text, "a");

pub(super) const ROBOT: Element = holding(
    "robot",
    // It may have a name, of any text.
    &[],
    &[
        child(Count::Any, &LINK, "<link name=\"a\"/>"),
        child(
            Count::Any,
            &JOINT,
            "<joint name=\"a\" type=\"fixed\"> … </joint>",
        ),
    ],
);

const LINK: Element = holding(
    "link",
    &[needed("name", Value::Text, "foot")],
    &[
        child(Count::AtMostOne, &INERTIAL, "<inertial> … </inertial>"),
        child(Count::Any, &VISUAL, "<visual> … </visual>"),
        child(Count::Any, &COLLISION, "<collision> … </collision>"),
    ],
);

const JOINT: Element = holding(
    "joint",
    &[
        needed("name", Value::Text, "knee"),
        needed("type", Value::JointKind, "revolute"),
    ],
    &[
        child(Count::AtMostOne, &ORIGIN, "<origin xyz=\"0 0 0\"/>"),
        child(Count::One, &PARENT, "<parent link=\"thigh\"/>"),
        child(Count::One, &CHILD, "<child link=\"shank\"/>"),
        child(Count::AtMostOne, &AXIS, "<axis xyz=\"1 0 0\"/>"),
        child(
            Count::AtMostOne,
            &LIMIT,
            "<limit lower=\"-1\" upper=\"1\" effort=\"5\" velocity=\"2\"/>",
        ),
        child(Count::AtMostOne, &MIMIC, "<mimic joint=\"knee\"/>"),
    ],
);

const ORIGIN: Element = holding(
    "origin",
    &[
        optional("xyz", Value::Numbers(3), "0 0 0"),
        optional("rpy", Value::Numbers(3), "0 0 0"),
        optional("quat_xyzw", Value::Quaternion, "0 0 0 1"),
    ],
    &[],
);

const PARENT: Element = holding("parent", &[needed("link", Value::Text, "thigh")], &[]);
const CHILD: Element = holding("child", &[needed("link", Value::Text, "shank")], &[]);
const AXIS: Element = holding("axis", &[needed("xyz", Value::Numbers(3), "1 0 0")], &[]);
const MIMIC: Element = holding("mimic", &[needed("joint", Value::Text, "knee")], &[]);

const LIMIT: Element = holding(
    "limit",
    &[
        optional("lower", Value::Bound, "-1"),
        optional("upper", Value::Bound, "1"),
        optional("effort", Value::Most, "5"),
        attribute(
            "velocity",
            Value::Most,
            Presence::NeededBefore(Version::V1_2),
            "2",
        ),
        optional("acceleration", Value::MostSince12, "10"),
        optional("deceleration", Value::MostSince12, "10"),
        optional("jerk", Value::MostSince12, "100"),
    ],
    &[],
);

const INERTIAL: Element = holding(
    "inertial",
    &[],
    &[
        child(Count::AtMostOne, &ORIGIN, "<origin xyz=\"0 0 0\"/>"),
        child(Count::One, &MASS, "<mass value=\"1\"/>"),
        child(
            Count::One,
            &INERTIA,
            "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>",
        ),
    ],
);

const MASS: Element = holding("mass", &[needed("value", Value::Numbers(1), "1")], &[]);
const INERTIA: Element = holding(
    "inertia",
    &[
        needed("ixx", Value::Numbers(1), "1"),
        needed("ixy", Value::Numbers(1), "0"),
        needed("ixz", Value::Numbers(1), "0"),
        needed("iyy", Value::Numbers(1), "1"),
        needed("iyz", Value::Numbers(1), "0"),
        needed("izz", Value::Numbers(1), "1"),
    ],
    &[],
);

const VISUAL: Element = holding(
    "visual",
    &[NAME],
    &[
        child(Count::AtMostOne, &ORIGIN, "<origin xyz=\"0 0 0\"/>"),
        GEOMETRY_CHILD,
    ],
);

const COLLISION: Element = holding(
    "collision",
    &[NAME],
    &[
        child(Count::AtMostOne, &ORIGIN, "<origin xyz=\"0 0 0\"/>"),
        GEOMETRY_CHILD,
    ],
);

const GEOMETRY_CHILD: Child = child(
    Count::One,
    &GEOMETRY,
    "<geometry><sphere radius=\"1\"/></geometry>",
);

const GEOMETRY: Element = Element {
    name: "geometry",
    attributes: &[],
    children: &[
        child(Count::AtMostOne, &BOX, "<box size=\"1 1 1\"/>"),
        child(
            Count::AtMostOne,
            &CYLINDER,
            "<cylinder radius=\"1\" length=\"1\"/>",
        ),
        child(
            Count::AtMostOne,
            &CAPSULE,
            "<capsule radius=\"1\" length=\"1\"/>",
        ),
        child(Count::AtMostOne, &SPHERE, "<sphere radius=\"1\"/>"),
        child(Count::AtMostOne, &MESH, "<mesh filename=\"a.stl\"/>"),
    ],
    is_choice: true,
};

const BOX: Element = holding("box", &[needed("size", Value::Lengths(3), "1 1 1")], &[]);
const CYLINDER: Element = holding("cylinder", ROUND, &[]);
const CAPSULE: Element = holding("capsule", ROUND, &[]);
const ROUND: &[Attribute] = &[
    needed("radius", Value::Lengths(1), "1"),
    needed("length", Value::Lengths(1), "1"),
];
const SPHERE: Element = holding("sphere", &[needed("radius", Value::Lengths(1), "1")], &[]);
const MESH: Element = holding("mesh", &[], &[]);
