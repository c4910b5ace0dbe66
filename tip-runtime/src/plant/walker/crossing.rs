//! Collisions of legs with other legs, blocks or the floor.

use super::Vector;
use super::floor::SINK_TOLERANCE;
use super::ground::GroundInterface;
use super::links::LegLinks;

/// Thickness of a leg, as a share of its length.
const THICK: f64 = 0.04;

/// Returns true if a joint of a leg is below the floor.
pub(super) fn is_below_floor<const J: usize>(
    leg: &LegLinks<J>,
    ground: &dyn GroundInterface,
) -> bool {
    (leg.places().skip(1)).any(|joint| ground.height(joint) < -SINK_TOLERANCE)
}

/// Returns true if a leg is in a block.
pub(super) fn is_in_block<const J: usize>(leg: &LegLinks<J>, ground: &dyn GroundInterface) -> bool {
    leg.lines().any(|line| ground.is_segment_in_block(line))
}

/// Returns true if a leg goes through another one, both of this length (mm). Their first links are
/// part of the body.
pub(super) fn touch<const J: usize>(a: &LegLinks<J>, b: &LegLinks<J>, length: f64) -> bool {
    let thick = THICK * length;
    if a.is_beyond(b, thick) {
        return false;
    }
    let mut lines = a.lines().skip(1);
    lines.any(|one| (b.lines().skip(1)).any(|other| gap(one, other) < thick))
}

/// Returns the distance of two segments (Ericson, *Real-Time Collision Detection*, 2004, §5.1.9),
/// mm.
fn gap([from, to]: [Vector; 2], [other_from, other_to]: [Vector; 2]) -> f64 {
    let (along, other, apart) = (to - from, other_to - other_from, from - other_from);
    let (a, e, f) = (
        along.norm_squared(),
        other.norm_squared(),
        other.dot(&apart),
    );
    let (b, c) = (along.dot(&other), along.dot(&apart));
    let part = |share: f64, whole: f64| {
        if whole > 0.0 {
            (share / whole).clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    let nearest = part(b * f - c * e, a * e - b * b);
    let on_other = part(b * nearest + f, e);
    let nearest = part(b * on_other - c, a);
    (apart + along * nearest - other * on_other).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_as_far_apart_as_their_nearest_points() {
        let at = |x: f64, y: f64, z: f64| Vector::new(x, y, z);
        let flat = [at(0.0, 0.0, 0.0), at(10.0, 0.0, 0.0)];
        // Over the middle, beyond an end, alongside, and a point.
        let others = [
            ([at(5.0, -5.0, 3.0), at(5.0, 5.0, 3.0)], 3.0),
            ([at(13.0, 4.0, 0.0), at(20.0, 4.0, 0.0)], 5.0),
            ([at(-4.0, 2.0, 0.0), at(4.0, 2.0, 0.0)], 2.0),
            ([at(-3.0, 0.0, 4.0), at(-3.0, 0.0, 4.0)], 5.0),
            ([at(5.0, -5.0, 0.0), at(5.0, 5.0, 0.0)], 0.0),
        ];
        for (other, expected) in others {
            assert!((gap(flat, other) - expected).abs() < 1e-12, "{other:?}");
            assert!((gap(other, flat) - expected).abs() < 1e-12, "{other:?}");
        }
    }
}
