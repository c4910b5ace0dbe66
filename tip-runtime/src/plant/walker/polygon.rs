//! Distances of points from the edges of convex hulls.

/// Returns the distance of `inner` from the nearest edge of the hull, negative outside. Points on
/// one line have a hull without inside.
pub(in crate::plant) fn margin(
    hull: impl Iterator<Item = [f64; 2]> + Clone,
    inner: [f64; 2],
) -> f64 {
    let inside = height_over_edges(hull.clone(), inner);
    if inside.is_finite() && inside > 0.0 {
        inside
    } else {
        -distance_to_segments(hull, inner)
    }
}

/// Returns the least distance of `inner` on the inner side of every edge of the hull; infinite
/// without edges.
fn height_over_edges(hull: impl Iterator<Item = [f64; 2]> + Clone, inner: [f64; 2]) -> f64 {
    let mut least = f64::INFINITY;
    for from in hull.clone() {
        for to in hull.clone() {
            if from != to && hull.clone().all(|point| side(from, to, point) >= -1e-6) {
                let length = libm::hypot(to[0] - from[0], to[1] - from[1]);
                if length > 0.0 {
                    least = least.min(side(from, to, inner) / length);
                }
            }
        }
    }
    least
}

/// Returns the distance of `inner` from the nearest segment between any two points.
fn distance_to_segments(points: impl Iterator<Item = [f64; 2]> + Clone, inner: [f64; 2]) -> f64 {
    let mut least = f64::INFINITY;
    for from in points.clone() {
        for to in points.clone() {
            least = least.min(distance(from, to, inner));
        }
    }
    least
}

/// Returns the distance of a point from the segment between two others.
fn distance(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> f64 {
    let (way, off) = (
        [to[0] - from[0], to[1] - from[1]],
        [point[0] - from[0], point[1] - from[1]],
    );
    let square = way[0] * way[0] + way[1] * way[1];
    let share = if square > 0.0 {
        ((way[0] * off[0] + way[1] * off[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    libm::hypot(off[0] - share * way[0], off[1] - share * way[1])
}

/// Returns twice the area of a triangle; positive if `point` is on the left of the path.
fn side(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> f64 {
    (to[0] - from[0]) * (point[1] - from[1]) - (to[1] - from[1]) * (point[0] - from[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 5] = [
        [0.0, 0.0],
        [10.0, 10.0],
        [10.0, 0.0],
        [4.0, 5.0],
        [0.0, 10.0],
    ];

    fn margin_of(points: &[[f64; 2]], inner: [f64; 2]) -> f64 {
        margin(points.iter().copied(), inner)
    }

    #[test]
    fn the_nearest_edge_counts_and_inner_points_do_not() {
        assert_eq!(margin_of(&SQUARE, [5.0, 5.0]), 5.0);
        assert_eq!(margin_of(&SQUARE, [9.0, 4.0]), 1.0);
        assert_eq!(margin_of(&SQUARE, [5.0, 0.0]), 0.0);
        assert_eq!(margin_of(&SQUARE, [5.0, -3.0]), -3.0);
        assert_eq!(margin_of(&SQUARE, [-3.0, -4.0]), -5.0);
    }

    #[test]
    fn lines_and_points_have_no_inside() {
        assert_eq!(margin_of(&[[0.0, 0.0], [0.0, 8.0]], [3.0, 4.0]), -3.0);
        assert_eq!(margin_of(&[[0.0, 0.0], [0.0, 8.0]], [3.0, 12.0]), -5.0);
        assert_eq!(margin_of(&[[0.0, 0.0], [0.0, 8.0]], [0.0, 20.0]), -12.0);
        assert_eq!(margin_of(&[[0.0, 0.0]], [3.0, 4.0]), -5.0);
    }
}
