//! Export of robots as MuJoCo models (MJCF), with their motors and surroundings.
//!
//! Lengths are in m, angles in rad. The world is that of a run: z up, the robot starts at the
//! origin, with x to its right and y ahead, in the pose of
//! [`DynamicPlant`](tip_runtime::plant::DynamicPlant). Masses, motors and contacts represent those
//! of this project's plants, so that the same commands lead to the same motion as far as two
//! simulations agree.
//!
//! ```
//! use tip_runtime::plant::Scene;
//! use tip_sim::{Robot, mjcf};
//!
//! let titan = mjcf::export(&Robot::named("titan8")?);
//! assert!(titan.contains("<freejoint name=\"base_link\"/>"), "it walks");
//! assert!(titan.contains("<position name=\"J11\" joint=\"J11\""));
//!
//! let hand = Robot::named("hand")?.with_scene(&Scene::CYLINDER)?;
//! assert!(mjcf::export(&hand).contains("<body name=\"O1\""), "what it grasps");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::import::mjcf::{EXPORTED, OMEGA_MAX, SHAPE_CLASS};
use crate::model::{Limb, RobotDescription};
use crate::robot::{InitialState, Robot};
use crate::urdf::frame::{self, BASE, BODY, FLOOR};
use crate::urdf::xml::{self, vector};
use crate::urdf::{loadable, rod_moments};
use std::f64::consts::FRAC_1_SQRT_2;
use tip_runtime::model::{Body, Inverse, Joint, Point, Range, Slider};
use tip_runtime::plant::{self, Block, Drives, Object, ObjectState, Pose, Scene};
use tipc::description::{Form, Shape, Shapes};

/// Radius of a contact shape around a point or line of the plants, m.
const SKIN: f64 = 1e-3;

/// Returns a robot in its [scene](Robot::with_scene) as MJCF.
///
/// Joints, and the position motors that turn them, are called `J11` to `Jnm`, the bodies that they carry `link11` to `linknm`; feet
/// or fingertips are the sites and touch sensors `F1` to `Fn`. The first keyframe, `initial`, is the initial posture.
#[must_use]
pub fn export(robot: &Robot) -> String {
    let (description, shapes) = (robot.description(), robot.shapes());
    let initial_state = robot.initial_state();
    let mut parts = Parts::default();
    if initial_state.pose.is_some() {
        add_ground(&mut parts, robot.scene());
    }
    open_base(&mut parts, &description, &initial_state, &shapes.body);
    for (number, leg) in (1..).zip(&description.legs) {
        add_leg(
            &mut parts,
            number,
            leg,
            &description,
            shapes,
            initial_state.objects.is_some(),
        );
    }
    if initial_state.pose.is_some() {
        exclude(&mut parts, robot, &description);
    }
    if let Some(slider) = &description.slider {
        add_slider(&mut parts, slider, &description, robot.scene());
    }
    if let Some(objects) = &initial_state.objects {
        add_objects(&mut parts, &description, robot.scene(), objects);
    }
    parts.world.close("body");
    parts.text(robot.name(), description.standards.omega_max)
}

/// Converts a point or vector from mm to m.
fn metres(of: Point) -> [f64; 3] {
    of.map(|mm| mm / 1000.0)
}

/// Returns the attitude of a body: w, x, y, z.
fn quaternion(pose: &Pose) -> [f64; 4] {
    let half = |degrees: f64| libm::sincos(degrees.to_radians() / 2.0);
    let ((sy, cy), (sp, cp), (sr, cr)) = (half(pose.yaw), half(pose.pitch), half(pose.roll));
    // Yaw about z, then pitch about x, then roll about y.
    let [w, x, y, z] = [cy * cp, cy * sp, sy * sp, sy * cp];
    [
        w * cr - y * sr,
        x * cr - z * sr,
        w * sr + y * cr,
        x * sr + z * cr,
    ]
}

const HEAD: &str = r#"<!-- Made by `tip robot export`. m, rad, kg, N·m; z up, x to the robot's right, y ahead.
     J11 to Jnm are the joints of the language, with its signs and zeros, and the position motors that turn them: what is commanded
     goes to their controls. link11 to linknm is what they carry; the sites F1 to Fn are the feet or fingertips, the sensors
     of that name what these carry (N). The keyframe `initial` is the initial posture. -->
"#;

/// Common settings of the plants: steps of 0.5 ms, friction of the touched surface, links of legs that push each other apart.
/// MuJoCo does not allow links without mass or thickness.
const SETTINGS: &str = r#"  <compiler angle="radian" autolimits="true" boundmass="1e-9" boundinertia="1e-12"/>
  <option timestep="0.0005" integrator="implicitfast" cone="elliptic" impratio="10" gravity="0 0 -9.80665"/>
  <default>
    <geom condim="3" friction="0 0 0" solref="0.004 1" contype="1" conaffinity="0" rgba="0.35 0.4 0.45 1"/>
    <pair condim="3" solref="0.004 1"/>
    <default class="ground"><geom contype="0" conaffinity="1" rgba="0.7 0.7 0.7 1"/></default>
    <default class="capsule"><geom contype="2" conaffinity="2" friction="0.5 0 0" group="3"/></default>
    <default class="drawn"><geom contype="0" conaffinity="0" group="2" rgba="0.9 0.55 0.15 1"/></default>
    <default class="tip_shape"><geom contype="0" conaffinity="0" group="2" rgba="0.9 0.55 0.15 1"/></default>
  </default>
"#;

/// A MuJoCo model.
#[derive(Default)]
struct Parts {
    world: Lines,
    /// Contact pairs whose friction differs from that of both geometries.
    pairs: Lines,
    motors: Lines,
    sensors: Lines,
    /// The initial values of all joints, in the order of the file.
    places: Vec<f64>,
    /// The initial values of all motors.
    controls: Vec<f64>,
}

impl Parts {
    /// Returns the text of the file. The custom elements are for the importer.
    fn text(&self, name: &str, omega_max: f64) -> String {
        let name = xml::escaped(name);
        let (key, frame) = EXPORTED;
        let mut text = format!(
            "{HEAD}<mujoco model=\"{name}\">\n{SETTINGS}  <custom>\n    <text name=\"{key}\" data=\"{frame}\"/>\n    <numeric name=\"{OMEGA_MAX}\" data=\"{omega_max}\"/>\n  </custom>\n"
        );
        let sections = [
            ("worldbody", &self.world),
            ("contact", &self.pairs),
            ("actuator", &self.motors),
            ("sensor", &self.sensors),
        ];
        for (section, lines) in sections {
            text.push_str(&format!("  <{section}>\n{}  </{section}>\n", lines.text));
        }
        let [places, controls] =
            [&self.places, &self.controls].map(|of| xml::vector(of.iter().copied()));
        text.push_str(&format!(
            "  <keyframe>\n    <key name=\"initial\" qpos=\"{places}\" ctrl=\"{controls}\"/>\n  </keyframe>\n</mujoco>\n"
        ));
        text
    }
}

/// Lines of a section, indented by the number of open elements.
#[derive(Default)]
struct Lines {
    text: String,
    open: usize,
}

impl Lines {
    /// Adds an element without children: its name and attributes.
    fn add(&mut self, element: &str) {
        self.line(&format!("<{element}/>"));
    }

    /// Begins an element with children.
    fn open(&mut self, element: &str) {
        self.line(&format!("<{element}>"));
        self.open += 1;
    }

    /// Ends an element with children.
    fn close(&mut self, name: &str) {
        self.open = self.open.saturating_sub(1);
        self.line(&format!("</{name}>"));
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(&"  ".repeat(2 + self.open));
        self.text.push_str(line);
        self.text.push('\n');
    }
}

/// Radius around a foot or fingertip in which contacts count as its load, m.
const REACH: f64 = 2.0 * SKIN;

/// The shortest rod that is drawn: m. MuJoCo refuses ends less than 1e-6 m apart.
const SHORTEST: f64 = 1e-5;

/// Begins the body that carries all legs.
fn open_base(
    parts: &mut Parts,
    description: &RobotDescription,
    initial_state: &InitialState,
    shapes: &[Shape],
) {
    let world = &mut parts.world;
    if let (Some(pose), Some(body)) = (&initial_state.pose, &description.body) {
        let [x, y, z] = metres(pose.position);
        // The contact shape around the foot stands on the floor.
        let (at, attitude) = ([x, y, z + SKIN], quaternion(pose));
        let (shown, turned) = (vector(at), vector(attitude));
        world.open(&format!(
            "body name=\"{BASE}\" pos=\"{shown}\" quat=\"{turned}\""
        ));
        world.add(&format!("freejoint name=\"{BASE}\""));
        trunk(parts, body, shapes);
        parts.places.extend(at.into_iter().chain(attitude));
    } else if initial_state.objects.is_some() {
        // For the hand, y is the height.
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
    let half = ranges.map(|range| (range.max - range.min).abs().max(frame::MIN_SIZE) / 2000.0);
    let middle = ranges.map(|range| (range.max + range.min) / 2000.0);
    let [xx, yy, zz] = half.map(|half| half * half);
    let inertia = [yy + zz, xx + zz, xx + yy].map(|squares| body.mass * squares / 3.0);
    let (half, middle) = (vector(half), vector(middle));
    let [xx, yy, zz] = inertia;
    let [xx, yy, zz, ..] = loadable([xx, yy, zz, 0.0, 0.0, 0.0]);
    let (centre, inertia) = match &body.inertial {
        None => (
            [0.0; 3],
            format!("diaginertia=\"{}\"", vector([xx, yy, zz])),
        ),
        Some(inertial) => (inertial.centre, full(inertial.inertia)),
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

/// Writes shapes that collide with nothing. Their class tells the importer that they are shapes of the
/// description.
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
            "geom class=\"{SHAPE_CLASS}\" {form} pos=\"{at}\" xyaxes=\"{axes}\""
        ));
    }
}

/// Writes a chain of links. Links of a `hand` are counterbalanced, and collide along their length;
/// those of other robots at their ends.
fn add_leg(
    parts: &mut Parts,
    number: u8,
    leg: &Limb,
    description: &RobotDescription,
    shapes: &Shapes,
    hand: bool,
) {
    let radius = frame::thickness(&description.legs) / 1000.0;
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
        let length = frame::length(metres(joint.link));
        if length >= SHORTEST {
            let touches = match description.body {
                Some(_) => "",
                None => " contype=\"0\" conaffinity=\"0\"",
            };
            let (end, radius) = (vector(metres(joint.link)), joint.thickness() / 1000.0);
            parts.world.add(&format!(
                "geom name=\"{link}_capsule\" class=\"capsule\" type=\"capsule\" fromto=\"0 0 0 {end}\" size=\"{radius}\"{touches}"
            ));
        }
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
    let ends = |range: Range| vector([range.min, range.max].map(f64::to_radians));
    let (axis, range) = (vector(joint.axis), ends(joint.outer));
    // MuJoCo has no soft limits; the importer reads them here.
    let soft = match joint.limits == joint.outer {
        true => String::new(),
        false => format!(" user=\"{}\"", ends(joint.limits)),
    };
    let [rotor, friction, stiffness, damping] = [
        drives.rotor,
        drives.friction,
        drives.stiffness,
        drives.damping,
    ]
    .map(|of| of * joint.torque);
    parts.world.add(&format!(
        "joint name=\"{name}\" axis=\"{axis}\" range=\"{range}\" armature=\"{rotor}\" damping=\"{friction}\"{soft}"
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
    let centre = joint.inertial.map(|inertial| metres(inertial.centre));
    let centre = vector(centre.unwrap_or(end.map(|part| part / 2.0)));
    // MuJoCo takes no full inertia of 0; its bounds stand for what weighs nothing.
    let inertia = match (mass > 0.0, &joint.inertial) {
        (false, _) => "diaginertia=\"0 0 0\"".to_owned(),
        (true, Some(inertial)) => full(inertial.inertia),
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

/// Excludes the pairs of links that do not push each other in the plant with mass: those of one leg, and those that are not compared.
fn exclude(parts: &mut Parts, robot: &Robot, description: &RobotDescription) {
    let links: Vec<(usize, usize)> = (description.legs.iter().enumerate())
        .flat_map(|(n, leg)| (0..leg.joints.len()).map(move |j| (n, j)))
        .collect();
    let name = |(n, j): (usize, usize)| frame::link(n as u8 + 1, j as u8 + 1);
    for (count, one) in links.iter().enumerate() {
        for other in &links[..count] {
            if one.0 == other.0 || !robot.compares(*one, *other) {
                let (one, other) = (name(*one), name(*other));
                let pair = format!("exclude body1=\"{other}\" body2=\"{one}\"");
                parts.pairs.add(&pair);
            }
        }
    }
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

/// Depth of blocks below the floor, m.
const DEEP: f64 = 0.1;
/// Half of the slider's plate along x and across, and its thickness, m.
const PLATE: [f64; 2] = [0.5, 0.02];
/// Mass of a slider, and stiffness and damping of its position servo: kg, N/m, N·s/m.
const CARRIAGE: [f64; 3] = [10.0, 1e6, 6e3];
/// Extent of objects and the palm beyond the outer fingers, m.
const BESIDE: f64 = 0.02;
/// Friction coefficient of the palm, and its thickness, m.
const PALM: (f64, f64) = (0.5, 0.02);

/// Writes a static floor, and the blocks on it.
fn add_ground(parts: &mut Parts, scene: &Scene) {
    let [x, y] = scene.floor.slope;
    let (up, height) = (vector([-x, -y, 1.0]), scene.floor.height / 1000.0);
    let friction = scene.friction;
    parts.world.add(&format!(
        "geom name=\"{FLOOR}\" class=\"ground\" type=\"plane\" size=\"0 0 1\" pos=\"0 0 {height}\" zaxis=\"{up}\" friction=\"{friction} 0 0\""
    ));
    for (number, block) in (1..).zip(scene.blocks.iter().flatten()) {
        let (middle, half) = block_of(block, scene);
        let (middle, half) = (vector(middle), vector(half));
        parts.world.add(&format!(
            "geom name=\"block{number}\" class=\"ground\" type=\"box\" pos=\"{middle}\" size=\"{half}\" friction=\"{friction} 0 0\""
        ));
    }
}

/// Returns the middle of a block, and half of its sides, m.
fn block_of(block: &Block, scene: &Scene) -> ([f64; 3], [f64; 3]) {
    let corners = block
        .x
        .iter()
        .flat_map(|x| block.y.iter().map(move |y| (x, y)));
    let floors = corners.map(|(x, y)| {
        let [along_x, along_y] = scene.floor.slope;
        scene.floor.height + along_x * x + along_y * y
    });
    let low = floors.fold(block.height, f64::min) / 1000.0 - DEEP;
    let ranges = [
        metres_of(block.x),
        metres_of(block.y),
        [low, block.height / 1000.0],
    ];
    (
        ranges.map(|[from, to]| (from + to) / 2.0),
        ranges.map(|[from, to]| (to - from) / 2.0),
    )
}

fn metres_of(range: [f64; 2]) -> [f64; 2] {
    range.map(|mm| mm / 1000.0)
}

/// Writes a slider: it hangs on joints that are at 0 in its initial position, as in URDF.
fn add_slider(parts: &mut Parts, slider: &Slider, description: &RobotDescription, scene: &Scene) {
    let at = vector(metres(slider.initial));
    parts.world.open(&format!(
        "body name=\"{FLOOR}\" pos=\"{at}\" gravcomp=\"1\""
    ));
    let [mass, stiffness, damping] = CARRIAGE;
    for axis in frame::ways(slider) {
        let name = frame::carriage(axis);
        let mut along = [0.0; 3];
        along[axis] = 1.0;
        let (travel, initial) = (slider.travel[axis], slider.initial[axis]);
        let range = vector([travel.min - initial, travel.max - initial].map(|mm| mm / 1000.0));
        let along = vector(along);
        parts.world.add(&format!(
            "joint name=\"{name}\" type=\"slide\" axis=\"{along}\" range=\"{range}\""
        ));
        parts.motors.add(&format!(
            "position name=\"{name}\" joint=\"{name}\" kp=\"{stiffness}\" kv=\"{damping}\" ctrlrange=\"{range}\""
        ));
        parts.places.push(0.0);
        parts.controls.push(0.0);
    }
    parts.world.add(&format!(
        "inertial pos=\"0 0 0\" mass=\"{mass}\" diaginertia=\"1 1 1\""
    ));
    plate(parts, description.inverse == Inverse::Planar, scene);
    parts.world.close("body");
}

/// Writes the slider's plate, whose upper side is the floor; under a hand it rises along x.
fn plate(parts: &mut Parts, is_planar: bool, scene: &Scene) {
    let ([half, thick], height) = (PLATE, scene.floor.height / 1000.0);
    let turn = match is_planar {
        true => libm::atan(scene.floor.slope[0]),
        false => 0.0,
    };
    let (sin, cos) = libm::sincos(turn);
    let below = thick / 2.0;
    let (size, at) = match is_planar {
        true => (
            [half, below, half],
            [sin * below, height - cos * below, 0.0],
        ),
        false => ([half, half, below], [0.0, 0.0, height - below]),
    };
    let (size, at, friction) = (vector(size), vector(at), scene.friction);
    parts.world.add(&format!(
        "geom name=\"{FLOOR}\" class=\"ground\" type=\"box\" size=\"{size}\" pos=\"{at}\" euler=\"0 0 {turn}\" friction=\"{friction} 0 0\""
    ));
}

/// Writes the objects under a hand, which move in its plane, and the palm above them. Where two of
/// these touch, the smaller friction counts.
fn add_objects(
    parts: &mut Parts,
    description: &RobotDescription,
    scene: &Scene,
    states: &[ObjectState],
) {
    let [x, y, z] = frame::around(&description.legs, 0.0);
    let (middle, half) = ((z.min + z.max) / 2000.0, (z.max - z.min) / 2000.0 + BESIDE);
    let thick = PALM.1 / 2.0;
    let size = vector([((x.max - x.min) / 2000.0).max(BESIDE), thick, half]);
    let at = vector([(x.max + x.min) / 2000.0, y.min / 1000.0 + thick, middle]);
    parts.world.add(&format!(
        "geom name=\"palm\" class=\"drawn\" type=\"box\" size=\"{size}\" pos=\"{at}\""
    ));
    let mut before: Vec<(String, f64)> = vec![
        (FLOOR.to_owned(), scene.friction),
        ("palm".to_owned(), PALM.0),
    ];
    let objects = (1_u8..).zip(&scene.objects);
    let objects = objects.filter_map(|(number, object)| Some((number, object.as_ref()?)));
    for ((number, object), state) in objects.zip(states) {
        let name = format!("O{number}");
        thing(parts, &name, object, state, [middle, half]);
        for (other, friction) in &before {
            let friction = friction.min(object.friction);
            parts.pairs.add(&format!(
                "pair geom1=\"{other}\" geom2=\"{name}\" friction=\"{friction} {friction} 0 0 0\""
            ));
        }
        before.push((name, object.friction));
    }
}

/// Writes an object whose joints give its state: x and y of its centre, and its turn.
fn thing(parts: &mut Parts, name: &str, object: &Object, state: &ObjectState, [z, half]: [f64; 2]) {
    let [x, y, _] = metres(state.position);
    let turn = state.angle.to_radians();
    let (sin, cos) = libm::sincos(turn);
    let at = vector([x, y, z]);
    let world = &mut parts.world;
    world.open(&format!(
        "body name=\"{name}\" pos=\"{at}\" euler=\"0 0 {turn}\""
    ));
    // Axes are given in the object's frame, which is turned.
    let along = [("x", [cos, -sin, 0.0], x), ("y", [sin, cos, 0.0], y)];
    for (axis, direction, at) in along {
        let direction = vector(direction);
        world.add(&format!(
            "joint name=\"{name}_{axis}\" type=\"slide\" axis=\"{direction}\" ref=\"{at}\""
        ));
    }
    world.add(&format!(
        "joint name=\"{name}_angle\" axis=\"0 0 1\" ref=\"{turn}\""
    ));
    let (shape, square) = match object.shape {
        plant::Shape::Disc { radius } => {
            let radius = radius / 1000.0;
            (
                format!("type=\"cylinder\" size=\"{radius} {half}\""),
                radius * radius / 2.0,
            )
        }
        plant::Shape::Box { width, height } => {
            let [w, h] = [width, height].map(|side| side / 2000.0);
            (
                format!("type=\"box\" size=\"{w} {h} {half}\""),
                (w * w + h * h) / 3.0,
            )
        }
    };
    let (mass, friction) = (object.mass, object.friction);
    // It only turns about z.
    let inertia = vector([mass * square; 3]);
    world.add(&format!(
        "inertial pos=\"0 0 0\" mass=\"{mass}\" diaginertia=\"{inertia}\""
    ));
    world.add(&format!(
        "geom name=\"{name}\" class=\"ground\" {shape} friction=\"{friction} 0 0\" rgba=\"0.2 0.5 0.8 1\""
    ));
    world.close("body");
    parts.places.extend([x, y, turn]);
}
