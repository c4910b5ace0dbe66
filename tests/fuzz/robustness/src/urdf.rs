//! Robots from URDF: what is imported is a description with a sound model, which can be exported again, or there is a
//! reason.

use crate::description;
use tip_sim::Robot;
use tip_sim::import::import;
use tip_sim::urdf::export;

/// Imports the bytes, bad ones replaced as the command line does.
///
/// # Panics
/// An import without description or reason, or an export that is no URDF.
pub fn examine(bytes: &[u8]) {
    match import("random.urdf", &String::from_utf8_lossy(bytes)) {
        Ok(found) => {
            description::examine(found.toml.as_bytes());
            let robot = Robot::from_description(&found.toml).expect("it was examined");
            let again = import("again.urdf", &export(&robot));
            assert!(again.is_ok(), "{again:?}: {}", found.toml);
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}
