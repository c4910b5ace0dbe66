//! Holds a file's elements against the tables of URDF. What they do not name is passed over: simulators and ROS add their own.

use super::ImportError;
use super::given::Given;
use super::node::{elements, place, start};
use super::schema::{Attribute, Child, Count, Element, Presence};
use super::values::number;
use super::version::Version;
use crate::message::Importing;
use roxmltree::Node;
use tipc::message::list::List;

type Checked = Result<(), ImportError>;

/// Refuses an element that is not as its table says, or holds one that is not.
pub(super) fn element(node: Node<'_, '_>, table: &Element, version: Version) -> Checked {
    for attribute in table.attributes {
        match node.attribute_node(attribute.name) {
            Some(found) => {
                let given = Given {
                    node,
                    found,
                    attribute,
                };
                given.fault(version).map_or(Ok(()), refuse)?;
            }
            None => missing(node, attribute, version)?,
        }
    }
    match table.is_choice {
        true => choice(node, table)?,
        false => {
            for child in table.children {
                count(node, child)?;
            }
        }
    }
    for child in table.children {
        for inner in elements(node, child.element.name) {
            element(inner, child.element, version)?;
        }
    }
    contradiction(node, table, version)
}

fn refuse(message: Importing) -> Checked {
    Err(ImportError::new(message))
}

/// An attribute that is not there.
fn missing(node: Node<'_, '_>, attribute: &Attribute, version: Version) -> Checked {
    let (element, name) = (node.tag_name().name().to_owned(), attribute.name);
    if let Some(inner) = elements(node, name).next() {
        return refuse(Importing::ElementForAttribute {
            at: start(inner),
            element,
            attribute: name,
            example: attribute.example,
        });
    }
    let is_needed = match attribute.presence {
        Presence::Needed => true,
        Presence::NeededBefore(other) => version < other,
        Presence::Optional => false,
    };
    match is_needed {
        false => Ok(()),
        true => refuse(Importing::NoAttribute {
            at: start(node),
            element,
            attribute: name,
            example: attribute.example,
        }),
    }
}

/// How often an element occurs in another one.
fn count(node: Node<'_, '_>, child: &Child) -> Checked {
    let (element, name) = (node.tag_name().name().to_owned(), child.element.name);
    if let Some(attribute) = node.attribute_node(name) {
        return refuse(Importing::AttributeForElement {
            at: place(node, attribute.range().start),
            element,
            child: name,
            example: child.example,
        });
    }
    let mut found = elements(node, name);
    let (first, second) = (found.next(), found.next());
    match (child.count, first, second) {
        (Count::One, None, _) => refuse(Importing::NoElement {
            at: start(node),
            element,
            child: name,
            example: child.example,
        }),
        (Count::One | Count::AtMostOne, _, Some(second)) => refuse(Importing::ElementTwice {
            at: start(second),
            element,
            child: name,
        }),
        _ => Ok(()),
    }
}

/// One of several elements, and no other.
fn choice(node: Node<'_, '_>, table: &Element) -> Checked {
    let known = || table.children.iter().map(|child| child.element.name);
    let is_blank = |text: &str| text.trim().is_empty();
    let is_content = |one: &Node<'_, '_>| match one.is_text() {
        true => !one.text().is_none_or(is_blank),
        false => one.is_element(),
    };
    let mut inner = node.children().filter(is_content);
    let (first, second) = (inner.next(), inner.next());
    let is_known = |one: Node<'_, '_>| known().any(|name| one.has_tag_name(name));
    let culprit = match (first, second) {
        (Some(first), None) if is_known(first) => return Ok(()),
        (_, Some(second)) => second,
        (first, None) => first.unwrap_or(node),
    };
    refuse(Importing::NotOneShape {
        at: start(culprit),
        element: node.tag_name().name().to_owned(),
        known: List(known().map(str::to_owned).collect()),
    })
}

/// Two attributes that contradict each other.
fn contradiction(node: Node<'_, '_>, table: &Element, version: Version) -> Checked {
    let has = |name| node.attribute(name).is_some();
    if version >= Version::V1_1 && table.name == "origin" && has("rpy") && has("quat_xyzw") {
        return refuse(Importing::TwoTurns { at: start(node) });
    }
    if version >= Version::V1_2 && table.name == "limit" {
        let bound = |name| node.attribute(name).and_then(number);
        if let (Some(lower), Some(upper)) = (bound("lower"), bound("upper"))
            && upper < lower
        {
            return refuse(Importing::BoundsSwapped {
                at: start(node),
                lower,
                upper,
            });
        }
    }
    Ok(())
}
