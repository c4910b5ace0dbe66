//! From where a link and a body came together, so that neither leaves through the other: not when they
//! are pressed deeper into each other than half of what is thin, and not when they pass each other
//! within one step.

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

/// What is known of a link and a body that are near each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seam {
    /// On which side of the link the body is, or was before it came through: +1 where a quarter turn
    /// from it points, −1 on the other side, 0 if that is not known.
    pub(super) side: f64,
    /// The face of a box through which the link's end came, or would come, if that is known.
    pub(super) face: Option<Face>,
}

impl Seam {
    /// Of what has not been near each other.
    pub(super) const UNKNOWN: Self = Seam {
        side: 0.0,
        face: None,
    };

    /// Whether a body is known from the other side.
    #[inline]
    pub(super) fn is_other(&self, side: f64) -> bool {
        self.side == -side
    }

    /// Whether a body, whose centre is on that side now, has come through the link. That it can have only
    /// while it is beside it; elsewhere it goes round the link's ends.
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
        let mut seam = Seam::UNKNOWN;
        assert!(!seam.is_through(1.0, true));
        assert!(seam.is_through(-1.0, true) && seam.is_through(-1.0, true));
        assert!(!seam.is_through(1.0, true), "it is back");
        assert!(!seam.is_through(-1.0, false), "it went round");
        assert!(!seam.is_through(-1.0, true));
    }
}
