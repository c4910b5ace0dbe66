//! Straight lines from any posture: whatever a search finds possible, the controller must do.
//!
//! `PATHS=10000 cargo test --release -p tip-runtime --test hand paths -- --nocapture` tries that many
//! lines of each finger and of each third joint, and prints the counts.

mod search;

use crate::rig::Hand;
use search::{Place, fingertip_goes, third_joint_goes};
use tip_runtime::command::{Op, Target};
use tip_runtime::model::hand;

/// Lines of each point that must be possible, where PATHS says nothing else.
const FEW: usize = 20;

/// Postures to start from besides the initial and the straight one.
const POSTURES: usize = 100;

/// What became of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
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

/// Numbers that are as good as random and the same in every run (Marsaglia's xorshift).
struct Dice(u64);

impl Dice {
    fn within(&mut self, min: f64, max: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        min + (max - min) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// What PTP of a finger's point makes of a line, from a posture at rest.
fn go(n: u8, target: Target, start: [f64; 3], [x, y]: Place) -> End {
    let mut rig = Hand::new();
    let finger = usize::from(n) - 1;
    rig.sensors.angles[finger] = start;
    rig.controller
        .sense(&rig.sensors)
        .expect("within the limits");
    // Every joint stays where it is measured.
    rig.controller.emergency();
    let base = hand::MODEL.legs[finger].base[0];
    let place = [base + x * -base.signum(), y, 0.0];
    if rig.run(Op::Ptp, target, &place).is_err() {
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

/// Tries lines of one point; the counts of those that are possible, and of those that are not.
fn tried(n: u8, third: bool) -> [Count; 2] {
    let lines = std::env::var("PATHS")
        .ok()
        .and_then(|lines| lines.parse().ok());
    let lines: usize = lines.unwrap_or(FEW);
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
        if possible.refused + possible.stopped + possible.arrived >= lines {
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
