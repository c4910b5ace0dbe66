//! Robots from URDF: what is imported is a description with a sound model, or there is a reason.

use crate::description;
use tip_sim::urdf::import;

/// Imports the bytes, bad ones replaced as the command line does.
///
/// # Panics
/// What comes of them is no description, or there is no reason.
pub fn examine(bytes: &[u8]) {
    match import("random.urdf", &String::from_utf8_lossy(bytes)) {
        Ok(import) => description::examine(import.toml.as_bytes()),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}
