//! The history of a contact between a link and a body, so that neither leaves through the other:
//! not when they are pressed deeper into each other than half of the thinner one, and not when they
//! pass each other within one step.

/// One of the four faces of a box, by the sign of the direction out of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Face {
    /// Along the width.
    Side(f64),
    /// Along the height.
    End(f64),
}

impl Face {
    pub(super) const fn opposite(self) -> Self {
        match self {
            Face::Side(sign) => Face::Side(-sign),
            Face::End(sign) => Face::End(-sign),
        }
    }
}

/// The contact history of a link and a body that are near each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ContactHistory {
    /// The side of the link on which the body is, or was before it came through: +1 where a quarter
    /// turn from the link points, −1 on the other side, 0 if unknown.
    pub(super) side: f64,
    /// The face of a box through which the link's end came, or would come, if known.
    pub(super) face: Option<Face>,
}

impl ContactHistory {
    /// The history of a pair that has not been near each other.
    pub(super) const UNKNOWN: Self = ContactHistory {
        side: 0.0,
        face: None,
    };

    /// Returns true if the body is known from the other side.
    #[inline]
    pub(super) fn is_other(&self, side: f64) -> bool {
        self.side == -side
    }

    /// Returns true if a body, whose centre is on `side` now, has come through the link. It can
    /// only do so while it is `is_beside` the link; elsewhere it goes round the link's ends.
    #[inline]
    pub(super) fn is_through(&mut self, side: f64, is_beside: bool) -> bool {
        if !is_beside || self.side == 0.0 {
            self.side = side;
        }
        self.is_other(side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_comes_through_a_link_but_not_round_its_end() {
        let mut history = ContactHistory::UNKNOWN;
        assert!(!history.is_through(1.0, true));
        assert!(history.is_through(-1.0, true) && history.is_through(-1.0, true));
        assert!(!history.is_through(1.0, true), "it is back");
        assert!(!history.is_through(-1.0, false), "it went round");
        assert!(!history.is_through(-1.0, true));
    }
}
