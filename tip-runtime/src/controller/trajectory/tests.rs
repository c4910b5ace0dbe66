//! Times in closed form, limits, continuity and arrival of moving set points.

use super::{Goal, INSTANT, Limits, SetPoint, add_scaled, dot, norm};

const ORIGIN: [f64; 3] = [0.0; 3];

const fn limits(speed: f64, acceleration: f64) -> Limits {
    Limits {
        speed,
        acceleration,
    }
}

const fn to<const N: usize>(target: [f64; N]) -> Goal<N> {
    Goal::Point { target, hs: false }
}

fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    norm(add_scaled(a, b, -1.0))
}

/// Returns the number of cycles until the set point is at its target.
fn cycles<const N: usize>(track: &mut SetPoint<N>, limits: Limits, dt: f64) -> u32 {
    let Goal::Point { target, .. } = track.goal() else {
        panic!("it heads for no point");
    };
    for cycle in 1..1_000_000 {
        track.advance(limits, dt, false);
        if track.position() == target && track.is_at_rest() {
            return cycle;
        }
    }
    panic!("it never arrives");
}

/// Numbers that are as good as random and the same in every run (Marsaglia's xorshift).
struct Dice(u64);

impl Dice {
    fn new(seed: u64) -> Self {
        Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn within(&mut self, min: f64, max: f64) -> f64 {
        min + (max - min) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn point(&mut self) -> [f64; 3] {
        [(); 3].map(|()| self.within(-200.0, 200.0))
    }
}

#[test]
fn rest_to_rest_takes_the_time_of_the_trapezium() {
    // Distance, speed, acceleration, seconds: distance / speed + speed / acceleration if the speed is
    // reached, otherwise 2 √(distance / acceleration).
    let moves = [
        (200.0, 500.0, 1000.0, 0.894_427_191),
        (50.0, 500.0, 1000.0, 0.447_213_595),
        (250.0, 500.0, 1000.0, 1.0),
        (500.0, 500.0, 1000.0, 1.5),
        (90.0, 90.0, 360.0, 1.25),
    ];
    for (way, speed, acceleration, seconds) in moves {
        for dt in [0.001, 0.0007, 0.02, 0.033] {
            let target = [0.48 * way, -0.6 * way, 0.64 * way];
            let mut track = SetPoint::resting(ORIGIN).towards(to(target));
            let cycles = cycles(&mut track, limits(speed, acceleration), dt);
            let time = f64::from(cycles) * dt;
            assert!(
                time > seconds - 1e-6 && time < seconds + dt + 1e-6,
                "{way} mm took {time} s in cycles of {dt} s"
            );
        }
    }
}

#[test]
fn the_way_is_straight_and_never_passes_its_end() {
    let target = [30.0, -40.0, 120.0];
    let mut track = SetPoint::resting(ORIGIN).towards(to(target));
    let mut before = 0.0;
    for _ in 0..200 {
        track.advance(limits(300.0, 600.0), 0.02, false);
        let way = norm(track.position());
        let along = dot(track.position(), target) / 130.0;
        assert!((way - along).abs() < 1e-9, "off the line");
        assert!(way >= before && way <= 130.0 + 1e-9);
        before = way;
    }
    assert_eq!(track.position(), target);
}

#[test]
fn positions_along_the_way_are_those_of_the_closed_form() {
    // 400 mm at 200 mm/s and 400 mm/s²: 0.5 s up (50 mm), 1.5 s at 200 mm/s, 0.5 s down.
    let mut track = SetPoint::resting([0.0]).towards(to([400.0]));
    for cycle in 1..=125 {
        track.advance(limits(200.0, 400.0), 0.02, false);
        let t = f64::from(cycle) * 0.02;
        let expected = if t <= 0.5 {
            200.0 * t * t
        } else if t <= 2.0 {
            50.0 + 200.0 * (t - 0.5)
        } else {
            400.0 - 200.0 * (2.5 - t) * (2.5 - t)
        };
        let [position] = track.position();
        assert!((position - expected).abs() < 1e-9, "{t}: {position}");
    }
}

#[test]
fn a_target_nearer_than_the_way_of_braking_is_passed_and_come_back_to() {
    // 100 mm/s under 100 mm/s² end 2 mm beyond the target, after 1 s; the return takes 0.283 s.
    let mut track = SetPoint::moving([0.0], [100.0]).towards(to([48.0]));
    for cycle in 1..=50 {
        track.advance(limits(200.0, 100.0), 0.02, false);
        let t = f64::from(cycle) * 0.02;
        let expected = 100.0 * t - 50.0 * t * t;
        assert!((track.position()[0] - expected).abs() < 1e-9, "{t}");
    }
    assert_eq!(cycles(&mut track, limits(200.0, 100.0), 0.02), 15);
}

#[test]
fn in_a_turn_both_parts_share_the_limits_as_the_sides_of_a_triangle() {
    // Straight across, either part gets 1/√2 of the acceleration; of 100 mm/s the part across keeps
    // its 60, so that 80 are left.
    let mut track = SetPoint::moving(ORIGIN, [60.0, 0.0, 0.0]).towards(to([0.0, 100.0, 0.0]));
    for cycle in 1..=20 {
        track.advance(limits(100.0, 400.0), 0.02, false);
        let along = 400.0 * core::f64::consts::FRAC_1_SQRT_2 * 0.02 * f64::from(cycle);
        assert!((track.velocity()[1] - along.min(80.0)).abs() < 1e-9);
    }
}

#[test]
fn what_is_left_for_an_instant_is_dropped() {
    // 0.5 mm/s take 0.5 s.
    let mut track = SetPoint::resting([0.0]).towards(Goal::Speed([0.5]));
    track.advance(limits(1.0, 1.0), 0.5 - INSTANT, false);
    assert_eq!(track.velocity(), [0.5]);
    // Two instants before its arrival.
    let speed = 2.0 * INSTANT;
    let target = [0.5 * speed * speed];
    let mut track = SetPoint::moving([0.0], [speed]).towards(to(target));
    track.advance(limits(1.0, 1.0), INSTANT, false);
    assert_eq!((track.position(), track.velocity()), (target, [0.0]));
}

#[test]
fn random_retargets_exceed_no_limit_and_never_jump() {
    for seed in 1..=40 {
        let mut dice = Dice::new(seed);
        let dt = dice.within(0.001, 0.05);
        let limits = limits(dice.within(10.0, 500.0), dice.within(10.0, 2000.0));
        let mut track = SetPoint::resting(dice.point());
        for _ in 0..2000 {
            match dice.next() % 20 {
                0 => track = track.towards(to(dice.point())),
                1 => track = track.towards(to(track.rest_point(limits))),
                2 => track = track.towards(Goal::Rest),
                _ => {}
            }
            let held = dice.next().is_multiple_of(10);
            let before = track;
            track.advance(limits, dt, held);
            let speed = norm(track.velocity());
            assert!(speed <= limits.speed * (1.0 + 1e-9));
            let change = distance(track.velocity(), before.velocity());
            assert!(change <= limits.acceleration * dt * (1.0 + 1e-6) + 1e-9);
            let moved = distance(track.position(), before.position());
            assert!(moved <= limits.speed * dt * (1.0 + 1e-9));
        }
        // Left alone, it arrives exactly.
        let target = dice.point();
        track = track.towards(to(target));
        cycles(&mut track, limits, dt);
    }
}

#[test]
fn a_target_that_moves_ahead_is_followed_at_full_speed() {
    let mut track = SetPoint::resting(ORIGIN);
    for cycle in 0..100 {
        let ahead = [200.0 + 4.0 * f64::from(cycle), 0.0, 0.0];
        track = track.towards(to(ahead));
        track.advance(limits(200.0, 400.0), 0.02, false);
    }
    assert!((norm(track.velocity()) - 200.0).abs() < 1e-9);
}

#[test]
fn limits_may_change_on_the_way() {
    for seed in 1..=40 {
        let mut dice = Dice::new(seed);
        let target = dice.point();
        let mut track = SetPoint::resting(dice.point()).towards(to(target));
        for _ in 0..300 {
            let limits = limits(dice.within(10.0, 500.0), dice.within(10.0, 2000.0));
            let dt = dice.within(0.001, 0.05);
            let before = track;
            track.advance(limits, dt, false);
            let change = distance(track.velocity(), before.velocity());
            assert!(change <= limits.acceleration * dt * (1.0 + 1e-6) + 1e-9);
            let allowed = limits.speed.max(norm(before.velocity()));
            assert!(norm(track.velocity()) <= allowed * (1.0 + 1e-9));
        }
        cycles(&mut track, limits(100.0, 100.0), 0.02);
    }
}

#[test]
fn a_lowered_speed_limit_is_reached_by_braking() {
    let mut track = SetPoint::resting([0.0]).towards(to([1000.0]));
    for _ in 0..50 {
        track.advance(limits(300.0, 600.0), 0.02, false);
    }
    assert!((track.velocity()[0] - 300.0).abs() < 1e-9);
    track.advance(limits(50.0, 600.0), 0.02, false);
    assert!((track.velocity()[0] - 288.0).abs() < 1e-9);
    for _ in 0..21 {
        track.advance(limits(50.0, 600.0), 0.02, false);
    }
    assert!((track.velocity()[0] - 50.0).abs() < 1e-9);
}

#[test]
fn a_speed_limit_of_zero_brakes_under_the_acceleration_limit() {
    // 61² / 1200 mm.
    let mut track = SetPoint::moving([0.0], [61.0]).towards(to([100.0]));
    for _ in 0..10 {
        track.advance(limits(0.0, 600.0), 0.02, false);
    }
    assert!((track.position()[0] - 3.100_833_333).abs() < 1e-8);
    assert!(track.is_at_rest());
}

#[test]
fn high_speed_starts_and_stops_at_once_but_keeps_v_max() {
    let goal = Goal::Point {
        target: [50.0],
        hs: true,
    };
    let mut track = SetPoint::resting([0.0]).towards(goal);
    for cycle in 1..=8 {
        track.advance(limits(300.0, 600.0), 0.02, false);
        assert!((track.position()[0] - 6.0 * f64::from(cycle)).abs() < 1e-9);
        assert_eq!(track.velocity(), [300.0]);
    }
    track.advance(limits(300.0, 600.0), 0.02, false);
    assert_eq!((track.position(), track.velocity()), ([50.0], [0.0]));
    // Held in motion, it stops immediately.
    let mut track = SetPoint::resting([0.0]).towards(goal);
    track.advance(limits(300.0, 600.0), 0.02, false);
    track.advance(limits(300.0, 600.0), 0.02, true);
    assert_eq!((track.position(), track.velocity()), ([6.0], [0.0]));
}

#[test]
fn high_speed_from_a_motion_across_goes_straight_on() {
    let goal = Goal::Point {
        target: [0.0, 60.0, 0.0],
        hs: true,
    };
    let mut track = SetPoint::moving(ORIGIN, [100.0, 0.0, 0.0]).towards(goal);
    for _ in 0..20 {
        track.advance(limits(300.0, 600.0), 0.02, false);
        assert!(track.position().iter().all(|x| x.is_finite()));
    }
    assert_eq!(track.position(), [0.0, 60.0, 0.0]);
}

#[test]
fn zero_limits_mean_no_motion() {
    for limits in [limits(0.0, 600.0), limits(300.0, 0.0), limits(0.0, 0.0)] {
        for hs in [false, true] {
            let target = [10.0, 20.0, 30.0];
            let goal = Goal::Point { target, hs };
            let mut track = SetPoint::resting(ORIGIN).towards(goal);
            for _ in 0..10 {
                track.advance(limits, 0.02, false);
            }
            let stays = !hs || limits.speed == 0.0;
            if stays {
                assert!(distance(track.position(), ORIGIN) < 1e-12);
            }
            // In motion it comes to rest.
            let mut track = SetPoint::moving(ORIGIN, [60.0, 0.0, 0.0]).towards(goal);
            for _ in 0..10 {
                track.advance(limits, 0.02, false);
            }
            if stays {
                assert!(track.is_at_rest());
            }
            // Given limits again, it goes on.
            cycles(&mut track, self::limits(300.0, 600.0), 0.02);
        }
    }
    let mut track = SetPoint::resting([0.0]).towards(Goal::Speed([40.0]));
    track.advance(limits(300.0, 0.0), 0.02, false);
    assert_eq!(track.position(), [0.0]);
}

#[test]
fn a_velocity_is_reached_under_the_acceleration_limit() {
    let mut track = SetPoint::resting(ORIGIN).towards(Goal::Speed([30.0, 40.0, 0.0]));
    track.advance(limits(1.0, 500.0), 0.02, false);
    assert!(distance(track.velocity(), [6.0, 8.0, 0.0]) < 1e-12);
    for _ in 0..9 {
        track.advance(limits(1.0, 500.0), 0.02, false);
    }
    assert_eq!(track.velocity(), [30.0, 40.0, 0.0]);
    // 0.1 s to reach it (2.5 mm), 0.1 s at it (5 mm).
    assert!((norm(track.position()) - 7.5).abs() < 1e-9);
}

#[test]
fn far_targets_make_no_nonsense() {
    for target in [[1e308; 3], [-1e308, 1e200, 0.0], [1e-308, 0.0, 0.0]] {
        let mut track = SetPoint::moving(ORIGIN, [1.0, 2.0, 3.0]).towards(to(target));
        for _ in 0..100 {
            track.advance(limits(300.0, 600.0), 0.02, false);
            assert!(!track.position().iter().any(|x| x.is_nan()));
            assert!(track.velocity().iter().all(|x| x.is_finite()));
        }
    }
}

#[test]
fn the_rest_point_is_where_braking_ends() {
    let limits = limits(300.0, 600.0);
    let mut track = SetPoint::moving(ORIGIN, [0.0, 120.0, 50.0]);
    let rest = track.rest_point(limits);
    // v² / 2 a = 130² / 1200.
    assert!((norm(rest) - 14.083_333_333).abs() < 1e-6);
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
    let right = SetPoint::moving(ORIGIN, [0.0, 101.0, 0.0]).towards(to([200.0, 0.0, 0.0]));
    let [_, y, _] = right.swing(limits);
    assert!((y - 101.0 * 101.0 / (600.0 * core::f64::consts::SQRT_2)).abs() < 1e-9);
    // Aslant it is as far as the track comes, seen in short steps.
    let mut slant = SetPoint::moving(ORIGIN, [40.0, 101.0, 0.0]).towards(to([200.0, 0.0, 0.0]));
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
        let track = SetPoint::moving(ORIGIN, [0.0, 101.0, 0.0]).towards(to(target));
        let [_, y, _] = track.swing(limits(300.0, acceleration));
        assert!(
            y == 0.0 || y.abs() > 1e9 || (acceleration > 1e99 && y.abs() < 1e-9),
            "{y}"
        );
    }
    assert_eq!(
        SetPoint::resting(ORIGIN)
            .towards(to(target))
            .swing(limits(300.0, 600.0)),
        ORIGIN
    );
}

#[test]
fn who_may_not_accelerate_rests_on_the_spot() {
    let track = SetPoint::moving([7.0], [120.0]);
    assert_eq!(track.rest_point(limits(300.0, 0.0)), [7.0]);
}

#[test]
fn who_may_hardly_brake_rests_far_away_at_a_finite_place() {
    let track = SetPoint::moving(ORIGIN, [0.0, 120.0, 50.0]);
    let [x, y, z] = track.rest_point(limits(300.0, 1e-308));
    assert_eq!(x, 0.0);
    assert!(y > 1e9 && z > 1e9 && y.is_finite() && z.is_finite());
}
