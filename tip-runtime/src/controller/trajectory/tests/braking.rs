//! The place where a moving set point comes to rest, and its swing to the side of its line.

use super::{ORIGIN, Track, limits, to, vector};

#[test]
fn the_rest_point_is_where_braking_ends() {
    let limits = limits(300.0, 600.0);
    let mut track = Track::moving(ORIGIN, [0.0, 120.0, 50.0]);
    let rest = track.rest_point(limits);
    // v² / 2 a = 130² / 1200.
    assert!((vector::norm(rest) - 14.083_333_333).abs() < 1e-6);
    track = track.towards(to(rest));
    for _ in 0..12 {
        track.advance(limits, 0.02, false);
    }
    assert_eq!(track.position(), rest);
    assert!(track.is_at_rest());
}

#[test]
fn the_swing_is_the_farthest_place_to_the_side_of_the_line() {
    let limits = limits(300.0, 600.0);
    // At a right angle the part across brakes with the √½ of the acceleration: v² / √2 a = 12.02.
    let right = Track::moving(ORIGIN, [0.0, 101.0, 0.0]).towards(to([200.0, 0.0, 0.0]));
    let [_, y, _] = right.swing(limits);
    assert!((y - 101.0 * 101.0 / (600.0 * core::f64::consts::SQRT_2)).abs() < 1e-9);
    // Aslant it is as far as the track comes, seen in short steps.
    let mut slant = Track::moving(ORIGIN, [40.0, 101.0, 0.0]).towards(to([200.0, 0.0, 0.0]));
    let [x, y, _] = slant.swing(limits);
    let mut farthest = ORIGIN;
    for _ in 0..10_000 {
        slant.advance(limits, 1e-4, false);
        if slant.position()[1] > farthest[1] {
            farthest = slant.position();
        }
    }
    assert!(
        (farthest[1] - y).abs() < 1e-4 && (farthest[0] - x).abs() < 0.05,
        "{farthest:?}"
    );
}

#[test]
fn a_swing_is_finite_or_reaches_nowhere() {
    let target = [200.0, 0.0, 0.0];
    for acceleration in [0.0, 1e-308, 1e308, f64::INFINITY] {
        let track = Track::moving(ORIGIN, [0.0, 101.0, 0.0]).towards(to(target));
        let [_, y, _] = track.swing(limits(300.0, acceleration));
        assert!(
            y == 0.0 || y.abs() > 1e9 || (acceleration > 1e99 && y.abs() < 1e-9),
            "{y}"
        );
    }
    assert_eq!(
        Track::resting(ORIGIN)
            .towards(to(target))
            .swing(limits(300.0, 600.0)),
        ORIGIN
    );
}

#[test]
fn who_may_not_accelerate_rests_on_the_spot() {
    let track = Track::moving([7.0], [120.0]);
    assert_eq!(track.rest_point(limits(300.0, 0.0)), [7.0]);
}

#[test]
fn who_may_hardly_brake_rests_far_away_at_a_finite_place() {
    let track = Track::moving(ORIGIN, [0.0, 120.0, 50.0]);
    let [x, y, z] = track.rest_point(limits(300.0, 1e-308));
    assert_eq!(x, 0.0);
    assert!(y > 1e9 && z > 1e9 && y.is_finite() && z.is_finite());
}
