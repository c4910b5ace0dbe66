//! The surroundings of the robot: a floor and blocks, or a slider that carries a floor, and
//! objects.

use super::metres;
use super::parts::Parts;
use crate::model::Anatomy;
use crate::urdf::frame::{self, FLOOR};
use crate::urdf::xml::vector;
use tip_runtime::model::{Inverse, Slider};
use tip_runtime::plant::{Block, Object, ObjectState, Scene, Shape};

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
pub(super) fn ground(parts: &mut Parts, scene: &Scene) {
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
pub(super) fn slider(parts: &mut Parts, slider: &Slider, anatomy: &Anatomy, scene: &Scene) {
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
    plate(parts, anatomy.inverse == Inverse::Planar, scene);
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
pub(super) fn objects(parts: &mut Parts, anatomy: &Anatomy, scene: &Scene, states: &[ObjectState]) {
    let [x, y, z] = frame::around(&anatomy.legs, 0.0);
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
        Shape::Disc { radius } => {
            let radius = radius / 1000.0;
            (
                format!("type=\"cylinder\" size=\"{radius} {half}\""),
                radius * radius / 2.0,
            )
        }
        Shape::Box { width, height } => {
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
