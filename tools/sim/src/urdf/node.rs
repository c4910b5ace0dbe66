//! What is in an element, and where it is in the file.

use crate::message::Place;
use roxmltree::Node;

/// The elements of a name that an element holds.
pub(super) fn elements<'a, 'i>(
    node: Node<'a, 'i>,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children()
        .filter(move |child| child.has_tag_name(name))
}

/// The place of a byte of the file.
pub(super) fn place(node: Node<'_, '_>, byte: usize) -> Place {
    let at = node.document().text_pos_at(byte);
    Place::At {
        line: at.row,
        column: at.col,
    }
}

/// Where an element begins.
pub(super) fn start(node: Node<'_, '_>) -> Place {
    place(node, node.range().start)
}
