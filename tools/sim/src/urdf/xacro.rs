//! Xacro: macros that make URDF. What is left of them in a file says that it was not expanded; their namespace alone does not.

use super::ImportError;
use super::node::{place, start};
use crate::message::Importing;
use crate::message::Place;
use roxmltree::{Document, Node};

/// What elements of xacro are written with.
pub(super) const PREFIX: &str = "xacro";
/// How an expression begins.
const EXPRESSION: &str = "${";

/// Refuses elements of xacro, and attributes that are expressions.
pub(super) fn refuse(document: &Document<'_>) -> Result<(), ImportError> {
    let mut elements = document.descendants().filter(Node::is_element);
    match elements.find_map(found) {
        None => Ok(()),
        Some(at) => Err(ImportError::new(Importing::Xacro { at })),
    }
}

/// Where an element or one of its attributes is of xacro.
fn found(node: Node<'_, '_>) -> Option<Place> {
    let namespace = node.tag_name().namespace();
    if namespace.is_some() && namespace == node.lookup_namespace_uri(Some(PREFIX)) {
        return Some(start(node));
    }
    let mut attributes = node.attributes();
    let expression = attributes.find(|attribute| attribute.value().contains(EXPRESSION))?;
    Some(place(node, expression.range().start))
}
