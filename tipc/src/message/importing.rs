//! What is said of robots from URDF files.

use super::list::{Faults, List};
use super::phrase::{JointKind, Place};

messages! {
    /// What the import of a URDF file says.
    Importing;

    // Why a file is refused.
    NoUrdf { error: String } "this is no URDF: {error}";
    TooDeep { element: String, most: u32 } "element `{element}` is nested deeper than {most} levels: no robot needs that";
    Doctype "the file has a DTD, and entities of its own are not read: leave `<!DOCTYPE …>` out, and write what its entities stand for";
    NoAttribute { at: Place, element: String, attribute: &'static str, example: &'static str } "{at}: element `{element}` has no attribute `{attribute}`: write it, as `{attribute}=\"{example}\"`";
    ElementForAttribute { at: Place, element: String, attribute: &'static str, example: &'static str } "{at}: `{attribute}` is an element in `{element}`: write it as an attribute, as `{attribute}=\"{example}\"`";
    NoElement { at: Place, element: String, child: &'static str, example: &'static str } "{at}: element `{element}` holds no element `{child}`: write it, as `{example}`";
    AttributeForElement { at: Place, element: String, child: &'static str, example: &'static str } "{at}: element `{element}` has `{child}` as an attribute: write it as an element in it, as `{example}`";
    ElementTwice { at: Place, element: String, child: &'static str } "{at}: element `{element}` holds element `{child}` twice: leave one out";
    NotOneShape { at: Place, element: String, known: List } "{at}: element `{element}` holds one shape and nothing else: write one of the elements {known}";
    NotAKindOfJoint { at: Place, element: String, attribute: &'static str, value: String, known: List } "{at}: attribute `{attribute}` of element `{element}` is `{value}`, which is not a kind of joint: write one of {known}";
    NotANumber { at: Place, element: String, attribute: &'static str, value: String, example: &'static str } "{at}: attribute `{attribute}` of element `{element}` is `{value}`, which is not a number: write one, as `{attribute}=\"{example}\"`";
    NotSoManyNumbers { at: Place, element: String, attribute: &'static str, value: String, wanted: usize, example: &'static str } "{at}: attribute `{attribute}` of element `{element}` is `{value}`, which is not {wanted} numbers: write them with blanks between, as `{attribute}=\"{example}\"`";
    NotALength { at: Place, element: String, attribute: &'static str, value: String, example: &'static str } "{at}: attribute `{attribute}` of element `{element}` is `{value}`, and URDF 1.2 takes lengths above 0: write such, as `{attribute}=\"{example}\"`";
    Negative { at: Place, element: String, attribute: &'static str, value: String, example: &'static str } "{at}: attribute `{attribute}` of element `{element}` is `{value}`, and URDF 1.2 takes 0 or more: write such, as `{attribute}=\"{example}\"`";
    BoundsSwapped { at: Place, lower: f64, upper: f64 } "{at}: attribute `upper` of element `limit` is {upper}, less than attribute `lower`, {lower}: write the smaller as `lower`";
    TwoTurns { at: Place } "{at}: attributes `rpy` and `quat_xyzw` of element `origin` both say how it is turned: leave one out";
    NoTurningJoint { link: String } "no joint turns on link `{link}`: a robot needs one chain of revolute joints at least";
    NoRobot { faults: Faults } "its numbers describe no robot: {faults}";
    TooManyChains { chains: usize, most: usize } "{chains} chains begin on the body, and a robot has {most} legs at most: make joints that are no leg fixed";
    TooManyJoints { leg: String, joints: usize, most: usize } "the leg of joint `{leg}` has {joints} joints, and {most} are the most: make some of them fixed";
    OtherNumberOfJoints { leg: String, joints: usize, first: String, wanted: usize } "the leg of joint `{leg}` has {joints} joints, that of joint `{first}` has {wanted}: every leg needs the same number, so make the others fixed";
    LinkTwice { link: String } "link `{link}` stands there twice";
    NoSuchLink { joint: String, link: String } "joint `{joint}` names link `{link}`, which is not there";
    OnTwoJoints { link: String } "link `{link}` hangs on two joints: a loop cannot be imported";
    NoBase "no link is the base: every one hangs on a joint";
    TwoBases { one: String, other: String } "links `{one}` and `{other}` hang on no joint: one link must be the base of all others";
    Circle { link: String, base: String } "link `{link}` does not hang on the base `{base}`: its joints make a circle";
    Branches { leg: String, link: String, one: String, other: String } "the leg of joint `{leg}` branches at link `{link}` into the joints `{one}` and `{other}`: a leg is one chain, so make one of them fixed";
    DoesNotTurn { joint: String, link: String, kind: JointKind } "joint `{joint}` on link `{link}` is {kind}: legs have joints that turn about one axis, so make it fixed, revolute or continuous";
    Mimics { joint: String, link: String, other: String } "joint `{joint}` on link `{link}` mimics joint `{other}`: every joint of a leg moves by itself, so make it fixed";
    NoAxis { joint: String, link: String } "joint `{joint}` on link `{link}` turns about an axis of length 0";
    NoFoot { link: String, joint: String } "link `{link}` behind joint `{joint}` is the last of its leg, and nothing says where its foot is: add a link there, on a fixed joint";
    TwoFeet { link: String, joint: String, one: String, other: String } "link `{link}` behind joint `{joint}` ends in the links `{one}` and `{other}`: leave the one that is the foot";

    // What is reported of one that is not.
    Frames "frames: x forward and y left (REP 103) became x right and y forward";
    Dropped "dropped: inertia tensors, centres of mass, geometry, damping, friction, safety limits";
    NoSensors "assumed: no torque sensors; add [forces] if there are some";
    InitialPosture "assumed: the initial posture is the middle of the limits; set `initial`";
    Leg { number: usize, joint: String, link: String } "F{number}: joint {joint} to link {link}";
    OmegaMax "OMEGA_MAX is the velocity of the slowest joint";
    TurnsAllRound { joint: String } "assumed: joint {joint} turns from -180 to 180 deg";
    Motor { joint: String } "assumed: joint {joint} has a motor of 10 N·m";
    TookIn { link: String, merged: List } "link {link} took in the links fixed to it: {merged}";
    BoltedDown "assumed: the robot is bolted down; add [body] if it walks";
    Walks "assumed: the robot walks; its body is a box around the first joints, 100 mm high: measure it";
    BodyMass "assumed: the body weighs 1 kg";
}
