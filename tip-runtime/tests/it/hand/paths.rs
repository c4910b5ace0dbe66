//! Straight lines from any posture: the controller must do every line that a search finds possible.
//!
//! `PATHS=10000 cargo test --release -p tip-runtime --test it hand::paths -- --nocapture` tries that many
//! lines of each finger and of each third joint, and prints the counts.

pub(crate) mod search;

use crate::hand::rig::{F1, Hand};
use search::{Place, fingertip_goes, third_joint_goes};
use tip_runtime::command::{Op, Target};
use tip_runtime::model::hand;

/// Number of lines of each point that must be possible, unless PATHS sets another.
const MIN_LINES: usize = 20;

/// Postures to start from besides the initial and the straight one.
const POSTURES: usize = 100;

/// The outcome of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End {
    Refused,
    Stopped,
    Arrived,
}

#[derive(Debug, Default)]
struct Count {
    refused: usize,
    stopped: usize,
    arrived: usize,
}

impl Count {
    fn add(&mut self, end: End) {
        match end {
            End::Refused => self.refused += 1,
            End::Stopped => self.stopped += 1,
            End::Arrived => self.arrived += 1,
        }
    }
}

/// Pseudo-random numbers, equal in every run (Marsaglia's xorshift).
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn within(&mut self, min: f64, max: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        min + (max - min) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Returns the hand with finger `n` at rest in a posture.
pub(crate) fn resting(n: u8, start: [f64; 3]) -> Hand {
    let mut rig = Hand::new();
    rig.sensors.angles[usize::from(n) - 1] = start;
    rig.controller
        .sense(&rig.sensors)
        .expect("within the limits");
    // Every joint stays where it is measured.
    rig.controller.emergency();
    rig
}

/// Transforms a place from the frame of finger `n` into the robot frame.
pub(crate) fn of_finger(n: u8, [x, y]: Place) -> [f64; 3] {
    let base = hand::MODEL.legs[usize::from(n) - 1].base[0];
    [base + x * -base.signum(), y, 0.0]
}

/// Returns the outcome of a PTP of a finger's point, from a posture at rest.
fn go(n: u8, target: Target, start: [f64; 3], place: Place) -> End {
    go_on(&mut resting(n, start), n, target, place)
}

/// Returns the outcome of a PTP of a finger's point, from its current state.
pub(crate) fn go_on(rig: &mut Hand, n: u8, target: Target, place: Place) -> End {
    if rig.run(Op::Ptp, target, &of_finger(n, place)).is_err() {
        return End::Refused;
    }
    for _ in 0..3000 {
        if rig.controller.inpos(target) {
            return End::Arrived;
        }
        if rig.tick().is_err() {
            return End::Stopped;
        }
    }
    End::Stopped
}

/// Returns the number of lines that must be possible.
fn lines() -> usize {
    let lines = std::env::var("PATHS").ok();
    lines
        .and_then(|lines| lines.parse().ok())
        .unwrap_or(MIN_LINES)
}

/// Tries lines of one point; returns the counts of those that are possible, and of those that are
/// not.
fn tried(n: u8, third: bool) -> [Count; 2] {
    let (target, reach, goes): (_, _, fn([f64; 3], Place) -> bool) = if third {
        (Target::Joint(n, 3), 120.0, third_joint_goes)
    } else {
        (Target::Foot(n), 160.0, fingertip_goes)
    };
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15 ^ u64::from(n));
    let mut starts = vec![[-40.0, 0.0, 80.0], [0.0; 3]];
    starts.extend((0..POSTURES).map(|_| {
        let [first, second, third] =
            [(-90.0, 90.0), (-10.0, 110.0), (-10.0, 110.0)].map(|(min, max)| dice.within(min, max));
        [first, second, third]
    }));
    let [mut possible, mut impossible] = [Count::default(), Count::default()];
    for start in starts.iter().cycle() {
        let place = [dice.within(-reach, reach), dice.within(-reach, reach)];
        let can = goes(*start, place);
        let end = go(n, target, *start, place);
        if can && end != End::Arrived && std::env::var("PATHS").is_ok() {
            println!("{start:?} {place:?} {end:?}");
        }
        if can { &mut possible } else { &mut impossible }.add(end);
        if possible.refused + possible.stopped + possible.arrived >= lines() {
            break;
        }
    }
    println!(
        "{}: possible {possible:?}, impossible {impossible:?}",
        if third { "J" } else { "F" }
    );
    [possible, impossible]
}

fn at_least_999_of_1000_arrive(third: bool) {
    for n in 1..=3 {
        let [possible, _] = tried(n, third);
        let failed = possible.refused + possible.stopped;
        assert!(
            failed * 1000 <= possible.arrived + failed,
            "{n}: {possible:?}"
        );
    }
}

// clauses: 7.2
#[test]
fn a_third_joint_follows_every_line_that_it_can() {
    at_least_999_of_1000_arrive(true);
}

// clauses: 7.2
#[test]
fn a_fingertip_follows_every_line_that_it_can() {
    at_least_999_of_1000_arrive(false);
}

// clauses: 7.2
#[test]
fn a_nearly_straight_finger_bends_in_place_to_the_side_of_its_line() {
    // What closes the gap would bend these to the side of their nearer limits, and end there.
    for (start, place) in [
        ([-22.87, 0.58, -2.32], [-107.7, -70.7]),
        ([-22.87, 0.58, -2.32], [25.5, -107.4]),
        ([-25.59, -5.68, 2.51], [-114.4, -101.8]),
    ] {
        assert!(fingertip_goes(start, place));
        let mut rig = resting(3, start);
        let [_, before] = search::places(start);
        rig.run(Op::Ptp, Target::Foot(3), &of_finger(3, place))
            .expect("it can be reached");
        let mut bends = false;
        while !bends || search::places(rig.sensors.angles[2])[1] == before {
            rig.tick().expect("nothing is in its way");
            let angles = rig.sensors.angles[2];
            let [_, tip] = search::places(angles);
            let gone = (tip[0] - before[0]).hypot(tip[1] - before[1]);
            // The side on which the line goes on is that of the wide limits.
            if gone < 1e-6 {
                bends |= angles[1] + angles[2] > 0.5 && angles[2] > start[2];
            } else {
                assert!(bends, "{start:?}: it sets off as {angles:?}");
                break;
            }
        }
        rig.cycles(Op::WaitInpos, Target::Foot(3), &[])
            .expect("it arrives");
    }
}

// clauses: 7.2
#[test]
fn a_straight_third_joint_bends_to_the_side_on_which_it_arrives() {
    let starts = [[-40.0, 0.0, 80.0], [0.0; 3]];
    let mut lines = 0;
    for (start, x, y) in starts.iter().flat_map(|start| {
        (-5..=5).flat_map(move |x| {
            (-5..0).map(move |y| (start, 23.0 * f64::from(x), 23.0 * f64::from(y)))
        })
    }) {
        if third_joint_goes(*start, [x, y]) {
            assert_eq!(
                go(1, Target::Joint(1, 3), *start, [x, y]),
                End::Arrived,
                "{x} {y}"
            );
            lines += 1;
        }
    }
    assert!(lines > 20, "{lines}");
    // What closes the gap would bend it to the other side.
    for place in [
        [61.595_57, -99.945_29],
        [48.826_38, -107.732_13],
        [20.533_75, -117.202_15],
    ] {
        let end = go(1, Target::Joint(1, 3), starts[0], place);
        assert_eq!(end, End::Arrived, "{place:?}");
    }
}

// clauses: 7.2
#[test]
fn a_finger_that_is_nearly_straight_and_still_moves_follows_every_line_that_it_can() {
    let mut dice = Dice(0x2545_F491_4F6C_DD1D);
    let [mut possible, mut impossible] = [Count::default(), Count::default()];
    while possible.refused + possible.stopped + possible.arrived < lines() {
        let mut rig = resting(1, [-40.0, 0.0, 80.0]);
        rig.run(Op::Ptp, F1, &of_finger(1, [0.0, -160.0]))
            .expect("it reaches as far as it is long");
        rig.cycles(Op::WaitInpos, F1, &[]).expect("it arrives");
        let [start, ..] = rig.sensors.angles;
        let place = [dice.within(-160.0, 160.0), dice.within(-160.0, 160.0)];
        let end = go_on(&mut rig, 1, F1, place);
        if fingertip_goes(start, place) {
            if end != End::Arrived {
                println!("{start:?} {place:?} {end:?}");
            }
            possible.add(end);
        } else {
            impossible.add(end);
        }
    }
    println!("moving F: possible {possible:?}, impossible {impossible:?}");
    let failed = possible.refused + possible.stopped;
    assert!(failed * 1000 <= possible.arrived + failed, "{possible:?}");
}

// clauses: 7.2 7.6
#[test]
fn a_finger_waits_while_its_posture_is_sought_and_sets_off_at_once_otherwise() {
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let (mut waited, mut at_once) = (0, 0);
    while waited < 3 || at_once < 20 {
        let start =
            [(-90.0, 90.0), (-10.0, 110.0), (-10.0, 110.0)].map(|(min, max)| dice.within(min, max));
        let place = [dice.within(-160.0, 160.0), dice.within(-160.0, 160.0)];
        let mut rig = resting(1, start);
        if !fingertip_goes(start, place) || rig.run(Op::Ptp, F1, &of_finger(1, place)).is_err() {
            continue;
        }
        if rig.sensors.angles[0] == start {
            assert!(!rig.controller.inpos(F1), "{start:?} {place:?}");
            // Of 26 postures each takes 414 pieces at most, and bending 60; 48 a cycle.
            let mut cycles = 0..(26 * 414 + 60) / 48;
            let moves = cycles.find(|_| rig.tick().is_err() || rig.sensors.angles[0] != start);
            assert!(moves.is_some(), "{start:?} {place:?}");
            waited += 1;
        } else {
            at_once += 1;
        }
        rig.cycles(Op::WaitInpos, F1, &[]).expect("it arrives");
    }
}

// clauses: 7.2
#[test]
fn a_finger_that_is_sent_to_the_side_while_it_comes_to_rest_at_full_stretch_arrives() {
    // Along its circle the point would swing out of reach; the others bend to the side of the narrow limits
    // if the gap decides.
    for place in [
        [5.801_565_744, -159.612_294_263],
        [10.748_291_395, -159.482_055_363],
        [-144.671_256_441, -66.141_954_927],
        [-152.803_566_165, -45.635_574_492],
        [-130.842_040_647, -91.820_517_465],
    ] {
        let mut rig = resting(1, [-40.0, 0.0, 80.0]);
        rig.run(Op::Ptp, F1, &of_finger(1, [0.0, -160.0]))
            .expect("it reaches as far as it is long");
        rig.cycles(Op::WaitInpos, F1, &[]).expect("it arrives");
        assert!(fingertip_goes(rig.sensors.angles[0], place), "{place:?}");
        assert_eq!(go_on(&mut rig, 1, F1, place), End::Arrived, "{place:?}");
    }
}
