//! Holds what an attribute is given against its row in the tables of URDF.

use super::node::place;
use super::robot::Kind;
use super::schema::{Attribute, Value};
use super::values::{number, numbers, quaternion};
use super::version::Version;
use crate::message::Importing;
use crate::message::Place;
use roxmltree::Node;
use tipc::message::list::List;

/// An attribute that is there.
pub(super) struct Given<'a, 'i> {
    pub(super) node: Node<'a, 'i>,
    pub(super) found: roxmltree::Attribute<'a, 'i>,
    pub(super) attribute: &'a Attribute,
}

impl Given<'_, '_> {
    /// What the table does not let it hold.
    pub(super) fn fault(&self, version: Version) -> Option<Importing> {
        let text = self.found.value();
        let is_1_2 = version >= Version::V1_2;
        match self.attribute.value {
            Value::Text => None,
            Value::JointKind => Kind::from_word(text).is_none().then(|| self.unknown_kind()),
            Value::Numbers(count) => self.miscounted(count).or_else(|| self.infinite(count)),
            Value::Lengths(count) => self.miscounted(count).or_else(|| {
                let is_length = |number: f64| number.is_finite() && number > 0.0;
                (is_1_2 && !numbers(text).all(is_length)).then(|| self.no_length())
            }),
            Value::Bound => self.miscounted(1).or_else(|| self.is_nan()),
            Value::MostSince12 if !is_1_2 => None,
            Value::Most | Value::MostSince12 => self
                .miscounted(1)
                .or_else(|| self.is_nan())
                .or_else(|| (is_1_2 && number(text) < Some(0.0)).then(|| self.negative())),
            Value::Quaternion => {
                (version >= Version::V1_1 && quaternion(text).is_none()).then(|| self.no_numbers(4))
            }
        }
    }

    fn miscounted(&self, count: usize) -> Option<Importing> {
        let text = self.found.value();
        match count {
            1 => number(text).is_none().then(|| self.no_number()),
            _ => (numbers(text).count() != count).then(|| self.no_numbers(count)),
        }
    }

    /// A number that is none, or has no end.
    fn infinite(&self, count: usize) -> Option<Importing> {
        let is_infinite = numbers(self.found.value()).any(|number| !number.is_finite());
        is_infinite.then(|| match count {
            1 => self.no_number(),
            _ => self.no_numbers(count),
        })
    }

    fn is_nan(&self) -> Option<Importing> {
        let is_nan = number(self.found.value()).is_some_and(f64::is_nan);
        is_nan.then(|| self.no_number())
    }

    fn at(&self) -> Place {
        place(self.node, self.found.range().start)
    }

    /// The names of the element and the attribute, what the attribute holds, and an example.
    fn words(&self) -> (String, &'static str, String, &'static str) {
        (
            self.node.tag_name().name().to_owned(),
            self.attribute.name,
            self.found.value().to_owned(),
            self.attribute.example,
        )
    }

    fn unknown_kind(&self) -> Importing {
        let (element, attribute, value, _) = self.words();
        Importing::NotAKindOfJoint {
            at: self.at(),
            element,
            attribute,
            value,
            known: List(Kind::words()),
        }
    }

    fn no_number(&self) -> Importing {
        let (element, attribute, value, example) = self.words();
        Importing::NotANumber {
            at: self.at(),
            element,
            attribute,
            value,
            example,
        }
    }

    fn no_numbers(&self, wanted: usize) -> Importing {
        let (element, attribute, value, example) = self.words();
        Importing::NotSoManyNumbers {
            at: self.at(),
            element,
            attribute,
            value,
            wanted,
            example,
        }
    }

    fn no_length(&self) -> Importing {
        let (element, attribute, value, example) = self.words();
        Importing::NotALength {
            at: self.at(),
            element,
            attribute,
            value,
            example,
        }
    }

    fn negative(&self) -> Importing {
        let (element, attribute, value, example) = self.words();
        Importing::Negative {
            at: self.at(),
            element,
            attribute,
            value,
            example,
        }
    }
}
