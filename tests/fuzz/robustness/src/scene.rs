//! Scenes: a hand can stand in each that is taken, or there are findings at places inside the text.

use tip_runtime::hardware::{Hardware, Sensors};
use tip_runtime::model::hand;
use tip_runtime::plant::SimulatedHand;
use tipc::description::parse_scene;

/// Reads the bytes as a scene and lets a hand measure in it.
///
/// # Panics
/// It is refused without a reason, or the hand measures no numbers in it.
pub fn examine(bytes: &[u8]) {
    let seen = String::from_utf8_lossy(bytes);
    match parse_scene("random.toml", bytes) {
        Ok(scene) => {
            let mut plant = SimulatedHand::new(&hand::MODEL).with_scene(&scene);
            let mut sensors = Sensors::ZERO;
            assert!(plant.read(&mut sensors).is_ok(), "{seen}");
            let angles = sensors.angles.iter().chain(&sensors.torques).flatten();
            assert!(angles.copied().all(f64::is_finite), "{seen}");
        }
        Err(loaded) => assert!(!loaded.diagnostics.is_empty(), "{seen}"),
    }
}
