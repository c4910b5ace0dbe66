//! What a foot does on the ground.

use super::Vector;

/// A foot on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Foothold {
    /// In the world: m.
    pub(super) place: Vector,
    /// Along the ground's normal: N.
    pub(super) load: f64,
    /// Where it touched down, in the world: m.
    touchdown: Option<Vector>,
    /// How far from there it has slipped: m.
    pub(super) slip: f64,
}

impl Foothold {
    /// Of a foot that has not been placed yet.
    pub(super) const NONE: Self = Foothold {
        place: Vector::new(0.0, 0.0, 0.0),
        load: 0.0,
        touchdown: None,
        slip: 0.0,
    };

    /// The foot is there, and carries so much.
    #[inline]
    pub(super) fn at(&mut self, place: Vector, load: f64) {
        self.place = place;
        self.load = load;
        if load > 0.0 {
            let touchdown = *self.touchdown.get_or_insert(place);
            self.slip = (place - touchdown).norm();
        } else {
            self.touchdown = None;
            self.slip = 0.0;
        }
    }
}
