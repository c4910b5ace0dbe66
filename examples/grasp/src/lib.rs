//! The simulated Hiroshima Hand finds the floor, grasps a cylinder and lifts it: the same program,
//! compiled and interpreted.
#![forbid(unsafe_code)]

pub mod outcome;
pub mod run;

use tip_runtime::plant::{Object, Scene, Shape};

// The whole motion program: `Grasp`, a type like any other.
tip_macros::include_tip!(pub "motions/grasp.prg", robot = hand);

/// The program's text, for the interpreter.
pub const SOURCE: &str = include_str!("../motions/grasp.prg");

/// An upright cylinder, 100 mm across, 60 mm high, 0.2 kg: its side is a box in the hand's plane.
pub const CYLINDER: Object = Object {
    shape: Shape::Box {
        width: 100.0,
        height: 60.0,
    },
    mass: 0.2,
    friction: 0.8,
    x: 0.0,
    y: None,
    angle: 0.0,
};

/// The cylinder on the floor.
pub const SCENE: Scene = {
    let mut scene = Scene::EMPTY;
    scene.objects[0] = Some(CYLINDER);
    scene
};
