//! The one table of every key of a description, a scene or `tip.toml`. Unknown keys, suggestions, help texts and the table in docs/robots.md come from it.

use crate::code::Code;
use crate::message::phrase::Table;

/// A table of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Keys above the first table.
    Robot,
    /// `[[joint]]`, or `[[leg.joint]]`.
    Joint,
    /// `[[leg]]`.
    Leg,
    /// `[body]`.
    Body,
    /// `[standards]`.
    Standards,
    /// `[forces]`.
    Forces,
    /// `[slider]`.
    Slider,
    /// Keys above the first table of a scene.
    Scene,
    /// `[floor]` of a scene.
    Floor,
    /// `[[object]]` of a scene.
    Object,
    /// `[[block]]` of a scene.
    Block,
    /// Keys above the first table of `tip.toml`.
    Project,
    /// `[[programs]]` of `tip.toml`.
    Programs,
}

impl Part {
    /// Every table of a description, in the order of the documentation.
    pub const ALL: &'static [Part] = &[
        Part::Robot,
        Part::Joint,
        Part::Leg,
        Part::Body,
        Part::Standards,
        Part::Forces,
        Part::Slider,
    ];

    /// Every table of a scene, in the order of the documentation.
    pub const SCENE: &'static [Part] = &[Part::Scene, Part::Floor, Part::Object, Part::Block];

    /// Every table of `tip.toml`, in the order of the documentation.
    pub const PROJECT: &'static [Part] = &[Part::Project, Part::Programs];

    /// The tables of the same file.
    pub(super) fn beside(self) -> &'static [Part] {
        if Part::SCENE.contains(&self) {
            Part::SCENE
        } else if Part::PROJECT.contains(&self) {
            Part::PROJECT
        } else {
            Part::ALL
        }
    }

    /// The code of what is wrong with its file.
    pub(super) fn code(self) -> Code {
        if Part::SCENE.contains(&self) {
            Code::Scene
        } else if Part::PROJECT.contains(&self) {
            Code::Project
        } else {
            Code::Description
        }
    }

    /// What messages call it.
    pub(super) fn table(self) -> Table {
        match self {
            Part::Robot => Table::Robot,
            Part::Scene => Table::Scene,
            Part::Project => Table::Project,
            part => Table::Named { name: part.name() },
        }
    }

    /// How the file spells it; nothing for what is above the first table.
    pub const fn name(self) -> &'static str {
        match self {
            Part::Robot | Part::Scene | Part::Project => "",
            Part::Joint => "[[joint]]",
            Part::Leg => "[[leg]]",
            Part::Body => "[body]",
            Part::Standards => "[standards]",
            Part::Forces => "[forces]",
            Part::Slider => "[slider]",
            Part::Floor => "[floor]",
            Part::Object => "[[object]]",
            Part::Block => "[[block]]",
            Part::Programs => "[[programs]]",
        }
    }

    /// Its keys.
    pub fn keys(self) -> impl Iterator<Item = &'static Key> {
        KEYS.iter().filter(move |key| key.part == self)
    }

    /// The key of that name.
    pub(super) fn key(self, name: &str) -> Option<&'static Key> {
        self.keys().find(|key| key.name == name)
    }
}

/// A key of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// Where it may appear.
    pub part: Part,
    /// Its name.
    pub name: &'static str,
    /// How its value is written.
    pub form: &'static str,
    /// What it is without the key; `None` if it is required.
    pub default: Option<&'static str>,
    /// What it says.
    pub meaning: &'static str,
}

macro_rules! keys {
    ($( $part:ident $name:literal, $form:literal, $default:expr, $meaning:literal; )*) => {
        /// Every key.
        pub const KEYS: &[Key] = &[$( Key {
            part: Part::$part,
            name: $name,
            form: $form,
            default: $default,
            meaning: $meaning,
        }, )*];
    };
}

keys! {
    Robot "name", "a text", None, "what programs, messages and traces call the robot: letters, digits, blanks, `-`, `_`, `.`";
    Robot "joint", "a list of [[joint]] tables", Some("none"), "the joints of every leg that has none of its own, from base to foot";
    Robot "leg", "a list of [[leg]] tables", None, "the legs, F1 first: 1 to 9, each with the same number of joints";
    Robot "initial", "[deg, …], a number for each joint", Some("the middle of each joint's limits"), "the initial posture of every leg that has none of its own";
    Robot "inverse", "\"yaw-pitch-pitch\", \"roll-pitch-pitch\", \"planar\" or \"least-squares\"", Some("the first of the four that fits the legs"), "how joint angles follow from a foot's position";
    Robot "body", "a [body] table", Some("none: the robot is bolted down"), "the body of a robot that walks";
    Robot "standards", "a [standards] table", Some("the values below"), "what parameter commands set, at its standard value";
    Robot "forces", "a [forces] table", Some("none: no command of torque, force or compliance"), "that the robot senses and gives torques";
    Robot "slider", "a [slider] table", Some("none: no `FLOOR`"), "a slider that carries the floor";
    Robot "periods", "[min, max] in ms", Some("[1, 1000]"), "the sampling times that it accepts";
    Robot "contact", "a number in V", Some("0.25"), "the reading of a sole from which its foot stands on something";
    Robot "lamps", "a whole number, 0 to 255", Some("16"), "how many lamps and relays it has";

    Joint "axis", "\"x\", \"-y\", … or [x, y, z]", None, "the axis of the joint, right-handed, in the frame of the link before";
    Joint "link", "[x, y, z] in mm", None, "from this joint to the next, or to the foot, at angle 0";
    Joint "limits", "[min, max] in deg", Some("[-180, 180]"), "the working limits";
    Joint "outer", "[min, max] in deg", Some("5 beyond the limits"), "the limits of the potentiometer, beyond which nothing may move";
    Joint "mass", "a number in kg", Some("0.1"), "the mass of the link";
    Joint "centre", "[x, y, z] in mm", Some("the middle of the link"), "the link's centre of mass, from the joint, at angle 0";
    Joint "inertia", "[xx, yy, zz, xy, xz, yz] in kg·m²", Some("a uniform rod's"), "the link's tensor of inertia about its centre of mass, at angle 0, along x, y and z of the robot frame; elements and signs are those of URDF";
    Joint "torque", "a number in N·m", Some("10"), "the most that the motor gives";

    Leg "base", "[x, y, z] in mm", None, "the first joint in the robot frame";
    Leg "turn", "a number in deg", Some("0"), "turns the joints about z, counterclockwise seen from above";
    Leg "mirror", "letters of \"x\", \"y\", \"z\"", Some("\"\""), "then mirrors them: \"x\" makes a right leg a left one; equal angles are mirrored postures";
    Leg "initial", "[deg, …], a number for each joint", Some("that of the robot"), "the initial posture";
    Leg "joint", "a list of [[leg.joint]] tables", Some("the [[joint]] tables of the robot"), "the joints of this leg, from base to foot";

    Body "x", "[min, max] in mm", None, "the extent of the body along x";
    Body "y", "[min, max] in mm", None, "along y";
    Body "z", "[min, max] in mm", None, "along z; the lower end is the belly";
    Body "mass", "a number in kg", Some("1"), "the mass without legs";
    Body "centre", "[x, y, z] in mm", Some("the origin"), "the centre of mass without legs";
    Body "inertia", "[xx, yy, zz, xy, xz, yz] in kg·m²", Some("a uniform box's"), "the tensor of inertia without legs, about the centre of mass";

    Standards "v_max", "a number in mm/s", Some("300"), "`V_MAX`";
    Standards "a_max", "a number in mm/s²", Some("600"), "`A_MAX`";
    Standards "omega_max", "a number in deg/s", Some("90"), "`OMEGA_MAX`";
    Standards "omega_dot_max", "a number in deg/s²", Some("360"), "`OMEGA_DOT_MAX`";
    Standards "just_position", "a number in mm", Some("2"), "`JUST_POSITION`";
    Standards "just_angle", "a number in deg", Some("1"), "`JUST_ANGLE`";
    Standards "near_position", "a number in mm", Some("10"), "`NEAR_POSITION`";
    Standards "near_angle", "a number in deg", Some("5"), "`NEAR_ANGLE`";
    Standards "period", "a number in ms", Some("20"), "the sampling time";

    Forces "unit", "\"N·m\" or \"mN·m\"", Some("\"N·m\""), "the unit of every torque that is commanded or sensed";
    Forces "torque_max", "a torque, a number", Some("the torque of the strongest joint"), "`TORQUE_MAX`";
    Forces "angle_stiffness", "torque per deg, a number", Some("2 N·m/deg"), "`ANGLE_STIFFNESS`";
    Forces "position_stiffness", "a number in N/mm", Some("1"), "`POSITION_STIFFNESS`, along each axis";

    Slider "initial", "[x, y, z] in mm", None, "where it stands at first";
    Slider "x", "[min, max] in mm", Some("it stays"), "how far it goes along x";
    Slider "y", "[min, max] in mm", Some("it stays"), "along y";
    Slider "z", "[min, max] in mm", Some("it stays"), "along z";

    Scene "plant", "\"quasi-static\" or \"dynamic\"", Some("quasi-static"), "how a walking robot is simulated; the option `--plant` wins";
    Scene "floor", "a [floor] table", Some("level, friction 0.5"), "what carries the objects, or a walking robot";
    Scene "object", "a list of [[object]] tables", Some("none"), "what a hand may grasp: 4 at most";

    Scene "block", "a list of [[block]] tables", Some("none"), "steps and obstacles for a walking robot with mass: 8 at most; with one it has mass, unless `plant` says otherwise";

    Floor "height", "a number in mm", Some("0"), "above the slider of a hand";
    Floor "slope", "[x, y], mm for each mm", Some("[0, 0]"), "how it rises; under a hand along x only";
    Floor "friction", "a number", Some("0.5"), "its coefficient of friction; feet of quasi-static robots do not slip";

    Object "size", "[width, height] in mm", Some("`radius` must be there"), "that it is a box, or an upright cylinder";
    Object "radius", "a number in mm", Some("`size` must be there"), "that it is a disc: a cylinder that lies along z";
    Object "mass", "a number in kg, 0.001 or more", None, "its mass";
    Object "friction", "a number", Some("0.5"), "its coefficient of friction; where two things touch the smaller one counts";
    Object "x", "a number in mm", Some("0"), "where its centre is at first";
    Object "y", "a number in mm", Some("it stands on the floor"), "where its centre is at first";
    Object "angle", "a number in deg", Some("0"), "how far it is turned at first, from x to y";

    Block "x", "[min, max] in mm", None, "from where to where it goes along x, in the world";
    Block "y", "[min, max] in mm", None, "along y";
    Block "height", "a number in mm", None, "its upper side, above the world's origin";

    Project "robot", "a robot's name, or a description's \"FILE.toml\"", Some("titan8"), "the robot of the programs in this folder and below";
    Project "encoding", "\"auto\", \"utf-8\" or \"shift_jis\"", Some("auto"), "how their files spell text";
    Project "scene", "\"cylinder\", or a scene's \"FILE.toml\"", Some("a level floor"), "what surrounds the robot when they run";
    Project "programs", "a list of [[programs]] tables", Some("none"), "programs with settings of their own; of several that mean a program the last one counts";

    Programs "files", "a pattern: `*` is any name, `**` any folders", None, "which programs, by their paths from this folder on";
    Programs "robot", "a robot's name, or a description's \"FILE.toml\"", Some("that of all programs"), "their robot";
    Programs "encoding", "\"auto\", \"utf-8\" or \"shift_jis\"", Some("that of all programs"), "how their files spell text";
    Programs "scene", "\"cylinder\", or a scene's \"FILE.toml\"", Some("that of all programs"), "what surrounds the robot when they run";
}
