//! Body, legs and motors.

use super::parts::Parts;
use super::{SKIN, metres, quaternion};
use crate::model::{Anatomy, Limb};
use crate::robot::InitialState;
use crate::urdf::frame::{self, BASE, BODY};
use crate::urdf::xml::vector;
use crate::urdf::{loadable, rod_moments};
use std::f64::consts::FRAC_1_SQRT_2;
use tip_runtime::model::{Body, Joint};
use tip_runtime::plant::Drives;
use tipc::description::{Form, Shape, Shapes};

/// Radius around a foot or fingertip in which contacts count as its load, m.
const REACH: f64 = 2.0 * SKIN;

/// The shortest rod that is drawn: m. MuJoCo refuses ends less than 1e-6 m apart.
const SHORTEST: f64 = 1e-5;

/// Begins the body that carries all legs.
pub(super) fn base(
    parts: &mut Parts,
    anatomy: &Anatomy,
    initial_state: &InitialState,
    shapes: &[Shape],
) {
    let world = &mut parts.world;
    if let (Some(pose), Some(body)) = (&initial_state.pose, &anatomy.body) {
        let [x, y, z] = metres(pose.position);
        // The skin stands on the floor, not the point in it.
        let (at, attitude) = ([x, y, z + SKIN], quaternion(pose));
        let (shown, turned) = (vector(at), vector(attitude));
        world.open(&format!(
            "body name=\"{BASE}\" pos=\"{shown}\" quat=\"{turned}\""
        ));
        world.add(&format!("freejoint name=\"{BASE}\""));
        trunk(parts, body, shapes);
        parts.places.extend(at.into_iter().chain(attitude));
    } else if initial_state.objects.is_some() {
        // Of the hand y is the height.
        let turned = vector([FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0, 0.0]);
        world.open(&format!("body name=\"{BASE}\" quat=\"{turned}\""));
    } else {
        world.open(&format!("body name=\"{BASE}\""));
    }
}

/// Writes a box, its mass at the origin unless the model says more. With shapes, the box is in the
/// group that viewers hide at first.
fn trunk(parts: &mut Parts, body: &Body, shapes: &[Shape]) {
    let ranges = [body.x, body.y, body.z];
    let half = ranges.map(|range| (range.max - range.min).abs().max(frame::LEAST) / 2000.0);
    let middle = ranges.map(|range| (range.max + range.min) / 2000.0);
    let [xx, yy, zz] = half.map(|half| half * half);
    let inertia = [yy + zz, xx + zz, xx + yy].map(|squares| body.mass * squares / 3.0);
    let (half, middle) = (vector(half), vector(middle));
    let [xx, yy, zz] = inertia;
    let [xx, yy, zz, ..] = loadable([xx, yy, zz, 0.0, 0.0, 0.0]);
    let (centre, inertia) = match &body.spread {
        None => (
            [0.0; 3],
            format!("diaginertia=\"{}\"", vector([xx, yy, zz])),
        ),
        Some(spread) => (spread.centre, full(spread.inertia)),
    };
    let (centre, mass) = (vector(metres(centre)), body.mass);
    let group = if shapes.is_empty() {
        ""
    } else {
        " group=\"3\""
    };
    parts.world.add(&format!(
        "inertial pos=\"{centre}\" mass=\"{mass}\" {inertia}"
    ));
    parts.world.add(&format!(
        "geom name=\"{BODY}\" type=\"box\" size=\"{half}\" pos=\"{middle}\"{group}"
    ));
    draw(parts, shapes);
}

/// Writes shapes that collide with nothing.
fn draw(parts: &mut Parts, shapes: &[Shape]) {
    for shape in shapes {
        let form = match shape.form {
            Form::Block(sides) => {
                let half = vector(sides.map(|side| side / 2000.0));
                format!("type=\"box\" size=\"{half}\"")
            }
            Form::Cylinder { radius, length } => {
                let size = vector([radius / 1000.0, length / 2000.0]);
                format!("type=\"cylinder\" size=\"{size}\"")
            }
            Form::Sphere { radius } => format!("type=\"sphere\" size=\"{}\"", radius / 1000.0),
        };
        let [x, y, _] = shape.axes;
        let (at, axes) = (vector(metres(shape.at)), vector(x.into_iter().chain(y)));
        parts.world.add(&format!(
            "geom class=\"drawn\" {form} pos=\"{at}\" xyaxes=\"{axes}\""
        ));
    }
}

/// Writes a chain of links. Links of a `hand` are counterbalanced, and collide along their length;
/// those of other robots at their ends.
pub(super) fn leg(
    parts: &mut Parts,
    number: u8,
    leg: &Limb,
    anatomy: &Anatomy,
    shapes: &Shapes,
    hand: bool,
) {
    let radius = frame::thickness(&anatomy.legs) / 1000.0;
    let foot = frame::foot(number);
    let mut at = leg.base;
    let postures = leg.initial.iter().copied();
    for ((count, joint), posture) in (1_u8..).zip(&leg.joints).zip(postures) {
        let (name, link) = (frame::joint(number, count), frame::link(number, count));
        let is_last = usize::from(count) == leg.joints.len();
        let weightless = if hand { " gravcomp=\"1\"" } else { "" };
        let place = vector(metres(at));
        parts
            .world
            .open(&format!("body name=\"{link}\" pos=\"{place}\"{weightless}"));
        hinge(parts, &name, joint, posture.to_radians());
        let touching = if is_last { &foot } else { &link };
        let shapes = shapes.of(number, count);
        carried(parts, joint, radius, shapes, touching, hand);
        at = joint.link;
    }
    let end = vector(metres(at));
    parts.world.add(&format!(
        "site name=\"{foot}\" pos=\"{end}\" size=\"{REACH}\""
    ));
    parts
        .sensors
        .add(&format!("touch name=\"{foot}\" site=\"{foot}\""));
    for _ in &leg.joints {
        parts.world.close("body");
    }
}

/// Writes a joint and its motor. The damping-to-stiffness ratio of the plants' motors equals the
/// lag of their servos, so a motor whose set point follows its command with that lag, and whose
/// rate it tracks, is this motor on the command itself.
fn hinge(parts: &mut Parts, name: &str, joint: &Joint, posture: f64) {
    let drives = Drives::default();
    let [axis, range] = [
        vector(joint.axis),
        vector([joint.outer.min, joint.outer.max].map(f64::to_radians)),
    ];
    let [rotor, friction, stiffness, damping] = [
        drives.rotor,
        drives.friction,
        drives.stiffness,
        drives.damping,
    ]
    .map(|of| of * joint.torque);
    parts.world.add(&format!(
        "joint name=\"{name}\" axis=\"{axis}\" range=\"{range}\" armature=\"{rotor}\" damping=\"{friction}\""
    ));
    let force = vector([-joint.torque, joint.torque]);
    parts.motors.add(&format!(
        "position name=\"{name}\" joint=\"{name}\" kp=\"{stiffness}\" kv=\"{damping}\" forcerange=\"{force}\" ctrlrange=\"{range}\""
    ));
    parts.places.push(posture);
    parts.controls.push(posture);
}

/// Writes the load of a joint: its shapes or a rod (its radius in m), and its contact shapes.
fn carried(
    parts: &mut Parts,
    joint: &Joint,
    radius: f64,
    shapes: &[Shape],
    touching: &str,
    hand: bool,
) {
    let end = metres(joint.link);
    let length = frame::length(end);
    let mass = joint.mass;
    let centre = joint.spread.map(|spread| metres(spread.centre));
    let centre = vector(centre.unwrap_or(end.map(|part| part / 2.0)));
    // MuJoCo takes no full inertia of 0; its bounds stand for what weighs nothing.
    let inertia = match (mass > 0.0, &joint.spread) {
        (false, _) => "diaginertia=\"0 0 0\"".to_owned(),
        (true, Some(spread)) => full(spread.inertia),
        (true, None) => full(inertia(mass, end, radius)),
    };
    let end = vector(end);
    let world = &mut parts.world;
    world.add(&format!(
        "inertial pos=\"{centre}\" mass=\"{mass}\" {inertia}"
    ));
    let rod = |size: f64| format!("type=\"capsule\" fromto=\"0 0 0 {end}\" size=\"{size}\"");
    let has_length = length >= SHORTEST;
    if has_length && shapes.is_empty() {
        world.add(&format!("geom class=\"drawn\" {}", rod(radius)));
    }
    let shape = match hand && has_length {
        true => rod(SKIN),
        false => format!("type=\"sphere\" pos=\"{end}\" size=\"{SKIN}\""),
    };
    world.add(&format!("geom name=\"{touching}\" {shape}"));
    draw(parts, shapes);
}

/// Formats xx, yy, zz, xy, xz and yz of a tensor.
fn full(inertia: [f64; 6]) -> String {
    format!("fullinertia=\"{}\"", vector(loadable(inertia)))
}

/// Returns xx, yy, zz, xy, xz and yz of a rod (kg, m) that ends at a point, about its middle.
fn inertia(mass: f64, end: [f64; 3], radius: f64) -> [f64; 6] {
    let length = frame::length(end);
    let [x, y, z] = match length > 0.0 {
        true => end.map(|part| part / length),
        false => [0.0, 0.0, 1.0],
    };
    let [across, along] = rod_moments(mass, length, radius);
    let less = across - along;
    [
        across - less * x * x,
        across - less * y * y,
        across - less * z * z,
        -less * x * y,
        -less * x * z,
        -less * y * z,
    ]
}
