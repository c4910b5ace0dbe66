//! Axis-aligned boxes, and line segments that cross them.

use crate::model::Body;
use crate::scene::Block;
use nalgebra::Vector3;

/// Depth to which blocks reach down, mm.
const DEEP: f64 = 1e7;

/// An axis-aligned box, by two opposite corners. The unit is the caller's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cuboid {
    pub(super) low: Vector,
    pub(super) high: Vector,
}

impl Cuboid {
    /// Returns a block, in a unit of `unit` mm.
    #[inline]
    pub(super) fn of_block(Block { x, y, height }: &Block, unit: f64) -> Self {
        Cuboid {
            low: Vector::new(x[0], y[0], -DEEP) / unit,
            high: Vector::new(x[1], y[1], *height) / unit,
        }
    }

    /// Returns a body in its own frame, in a unit of `unit` mm.
    #[inline]
    pub(super) fn of_body(Body { x, y, z, .. }: &Body, unit: f64) -> Self {
        Cuboid {
            low: Vector::new(x.min, y.min, z.min) / unit,
            high: Vector::new(x.max, y.max, z.max) / unit,
        }
    }

    /// Returns the corners: the lower four in order around the box, then the upper four.
    pub(super) fn corners(&self) -> [Vector; 8] {
        let (low, high) = (self.low, self.high);
        [
            [low.x, low.y, low.z],
            [high.x, low.y, low.z],
            [high.x, high.y, low.z],
            [low.x, high.y, low.z],
            [low.x, low.y, high.z],
            [high.x, low.y, high.z],
            [high.x, high.y, high.z],
            [low.x, high.y, high.z],
        ]
        .map(Vector::from)
    }

    /// Returns the edges, by both ends.
    pub(super) fn edges(&self) -> [[Vector; 2]; 12] {
        let [a, b, c, d, e, f, g, h] = self.corners();
        [
            [a, b],
            [b, c],
            [c, d],
            [d, a],
            [e, f],
            [f, g],
            [g, h],
            [h, e],
            [a, e],
            [b, f],
            [c, g],
            [d, h],
        ]
    }

    /// Returns the vector from the nearest point of the box to a point; zero inside.
    #[inline]
    pub(super) fn outside(&self, point: Vector) -> Vector {
        point - point.sup(&self.low).inf(&self.high)
    }

    /// Returns true if no axis shows that another box is as far away as `distance`.
    #[inline]
    pub(super) fn may_be_within(&self, distance: f64, other: &Self) -> bool {
        let apart = (other.low - self.high).sup(&(self.low - other.high)).max();
        apart < distance.max(0.0)
    }

    /// Returns the depth of a point inside and the normal of the nearest side; among equally near
    /// sides the upper one comes first.
    #[inline]
    pub(super) fn depth(&self, point: Vector) -> Option<(f64, Vector)> {
        let (above, below) = (self.high - point, point - self.low);
        let sides = [
            (above.z, Vector::z()),
            (below.x, -Vector::x()),
            (above.x, Vector::x()),
            (below.y, -Vector::y()),
            (above.y, Vector::y()),
            (below.z, -Vector::z()),
        ];
        let nearest = |best: (f64, Vector), side: (f64, Vector)| match side.0 < best.0 {
            true => side,
            false => best,
        };
        let most = (f64::INFINITY, Vector::z());
        let found = sides.into_iter().fold(most, nearest);
        (found.0 > 0.0).then_some(found)
    }

    /// Returns the part of a segment that is inside, as shares of its length (Liang and Barsky,
    /// *ACM Transactions on Graphics* 3, 1984).
    #[inline]
    pub(super) fn inside(&self, [start, end]: [Vector; 2]) -> Option<[f64; 2]> {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let sides = self.low.iter().zip(&self.high);
        for ((start, end), (low, high)) in start.iter().zip(&end).zip(sides) {
            let along = end - start;
            if along == 0.0 {
                if start < low || start > high {
                    return None;
                }
            } else {
                let (one, other) = ((low - start) / along, (high - start) / along);
                from = from.max(one.min(other));
                to = to.min(one.max(other));
            }
        }
        (from < to).then_some([from, to])
    }

    /// Like [`inside`](Self::inside), for a segment whose ends are both outside, so that neither
    /// end touches by itself.
    #[inline]
    pub(super) fn through(&self, segment: [Vector; 2]) -> Option<[f64; 2]> {
        self.inside(segment)
            .filter(|[from, to]| *from > 0.0 && *to < 1.0)
    }
}

/// Returns the midpoint of a part of a segment.
#[inline]
pub(super) fn middle([start, end]: [Vector; 2], [from, to]: [f64; 2]) -> Vector {
    start + (end - start) * ((from + to) / 2.0)
}

type Vector = Vector3<f64>;

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Cuboid = Cuboid {
        low: Vector::new(0.0, 0.0, 0.0),
        high: Vector::new(1.0, 1.0, 1.0),
    };

    #[test]
    fn a_segment_is_inside_where_its_points_are() {
        let v = Vector::new;
        let slant = [v(-1.0, 0.5, 0.25), v(3.0, 0.5, 0.75)];
        assert_eq!(UNIT.inside(slant), Some([0.25, 0.5]));
        assert_eq!(UNIT.through(slant), Some([0.25, 0.5]));
        assert_eq!(middle(slant, [0.25, 0.5]), v(0.5, 0.5, 0.4375));
        let begins = [v(0.5, 0.5, 0.5), v(0.5, 0.5, 2.5)];
        assert_eq!(UNIT.inside(begins), Some([0.0, 0.25]));
        assert_eq!(UNIT.through(begins), None, "its end touches by itself");
        for passes in [
            [v(-1.0, 0.5, 2.0), v(2.0, 0.5, 2.0)],
            [v(-1.0, 0.5, 0.5), v(-0.5, 0.5, 0.5)],
            [v(-1.0, 0.5, 0.5), v(0.5, 2.0, 0.5)],
        ] {
            assert_eq!(UNIT.inside(passes), None, "{passes:?}");
        }
    }

    #[test]
    fn a_point_leaves_by_the_nearest_side() {
        let at = |x, y, z| UNIT.depth(Vector::new(x, y, z));
        assert_eq!(at(0.5, 0.5, 0.75), Some((0.25, Vector::z())));
        assert_eq!(at(0.25, 0.5, 0.5), Some((0.25, -Vector::x())));
        assert_eq!(at(0.5, 0.875, 0.5), Some((0.125, Vector::y())));
        assert_eq!(at(0.5, 0.5, 0.125), Some((0.125, -Vector::z())));
        assert_eq!(at(0.5, 0.5, 1.5), None);
    }

    #[test]
    fn edges_join_corners_along_one_axis() {
        let edges = UNIT.edges();
        for [start, end] in edges {
            assert_eq!((end - start).norm(), 1.0);
        }
        let sum = edges.iter().flatten().sum::<Vector>();
        assert_eq!(sum, Vector::repeat(12.0), "each corner three times");
    }
}
