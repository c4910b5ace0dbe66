//! How deep elements are nested: what reads URDF calls itself once a level.

use super::ImportError;
use tipc::message::Importing;
use xml::reader::{EventReader, XmlEvent};

/// URDF needs six levels; what simulators add to it, a few more.
const DEEPEST: u32 = 100;

/// Refuses text that is nested too deep to be read, or no XML.
pub(super) fn check(text: &str) -> Result<(), ImportError> {
    let mut depth: u32 = 0;
    for event in EventReader::from_str(text) {
        match event {
            Ok(XmlEvent::StartElement { name, .. }) if depth == DEEPEST => {
                return Err(ImportError::new(Importing::TooDeep {
                    element: name.local_name,
                    most: DEEPEST,
                }));
            }
            Ok(XmlEvent::StartElement { .. }) => depth += 1,
            Ok(XmlEvent::EndElement { .. }) => depth = depth.saturating_sub(1),
            Ok(_) => {}
            Err(error) => {
                return Err(ImportError::new(Importing::NoUrdf {
                    error: error.to_string(),
                }));
            }
        }
    }
    Ok(())
}
