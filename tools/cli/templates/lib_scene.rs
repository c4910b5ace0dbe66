
use tip_runtime::plant::{Object, Scene, Shape};

/// The object that the hand grasps, as scene.toml has it: a cylinder, upright, 100 mm across, 60 mm high, 0.2 kg.
pub const SCENE: Scene = {
    let mut scene = Scene::EMPTY;
    scene.objects[0] = Some(Object {
        shape: Shape::Box {
            width: 100.0,
            height: 60.0,
        },
        mass: 0.2,
        friction: 0.8,
        x: 0.0,
        y: None,
        angle: 0.0,
    });
    scene
};
