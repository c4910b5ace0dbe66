//! The points of a robot that can touch the floor.

use super::Vector;
use crate::model::Body;

/// A value for each foot and for each corner of the belly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contacts<T, const L: usize> {
    pub(super) feet: [T; L],
    pub(super) belly: [T; 4],
}

impl<T, const L: usize> Contacts<T, L> {
    pub(super) const fn new(feet: [T; L], belly: [T; 4]) -> Self {
        Contacts { feet, belly }
    }

    /// Iterates over all contacts, feet first.
    pub(super) fn iter(&self) -> impl Iterator<Item = &T> + Clone {
        self.feet.iter().chain(&self.belly)
    }

    /// Calls `f` with both values of each contact, feet first.
    pub(super) fn for_each_with<U>(&self, other: &Contacts<U, L>, mut f: impl FnMut(&T, &U)) {
        for (one, other) in self.feet.iter().zip(&other.feet) {
            f(one, other);
        }
        for (one, other) in self.belly.iter().zip(&other.belly) {
            f(one, other);
        }
    }
}

impl<T: Copy, const L: usize> Contacts<T, L> {
    pub(super) fn map<U>(&self, mut f: impl FnMut(T) -> U) -> Contacts<U, L> {
        Contacts {
            feet: self.feet.map(&mut f),
            belly: self.belly.map(&mut f),
        }
    }
}

impl<const L: usize> Contacts<Vector, L> {
    /// Returns the points that can touch the floor, in the robot frame.
    pub(super) fn of(body: &Body, feet: [Vector; L]) -> Self {
        let (x, y, z) = (body.x, body.y, body.z.min);
        Contacts {
            feet,
            belly: [
                Vector::new(x.min, y.min, z),
                Vector::new(x.max, y.min, z),
                Vector::new(x.max, y.max, z),
                Vector::new(x.min, y.max, z),
            ],
        }
    }
}
