//! A search spreads over cycles, and finds the same as without that.

use super::{A_CYCLE, Outcome, PointOfLeg, Search, Stage};
use crate::kinematics::{Chain, LegPoint};
use crate::model::{Inverse, hand};

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

/// Cycles that a search takes at most: 18 postures, 60 steps of bending, twice 4 postures more; a line of
/// 400 pieces each, 9 solutions before.
const LONGEST: usize = (18 * 414 + 60 + 2 * 4 * 414) / A_CYCLE + 1;

/// Returns the result of a search and its number of cycles; each is compared with as many steps.
fn searched(
    point: LegPoint,
    start: [f64; 3],
    to: [f64; 3],
    home: Option<[f64; 3]>,
) -> (bool, usize) {
    let leg = &hand::MODEL.legs[0];
    let place = Chain::new(leg, &start).point(point).expect("a point");
    let point = PointOfLeg {
        leg,
        point,
        axes: Inverse::Planar.axes(),
    };
    let mut search = Search::new(&point, start, (place, to), home);
    for cycle in 1..=LONGEST {
        let mut stepped = search;
        let (mut pieces, mut steps) = (0, None);
        while pieces < A_CYCLE && steps.is_none() {
            pieces += if stepped.stage == Stage::Starting {
                6
            } else {
                1
            };
            steps = stepped.step(&point);
        }
        assert!(pieces < 48 + 6, "{pieces}");
        let found = search.advance(&point, &start, place);
        assert_eq!((search, found), (stepped, steps), "{cycle}");
        if let Some(outcome) = found {
            return (outcome != Outcome::Nothing, cycle);
        }
    }
    panic!("{start:?} {to:?}: no end");
}

#[test]
fn no_cycle_solves_a_leg_more_often_than_the_bound() {
    let mut dice = Dice(0x2545_F491_4F6C_DD1D);
    let (mut at_once, mut later, mut in_vain) = (0, 0, 0);
    for number in 0..600 {
        let start = [(-90.0, 90.0), (-10.0, 110.0), (-10.0, 110.0)];
        let start = start.map(|(min, max)| dice.within(min, max));
        let [x, y] = [(-200.0, 80.0), (-150.0, 100.0)].map(|(min, max)| dice.within(min, max));
        let point = if number % 2 == 0 {
            LegPoint::Tip
        } else {
            LegPoint::Joint(2)
        };
        match searched(point, start, [x, y, 0.0], None) {
            (true, 1) => at_once += 1,
            (true, _) => later += 1,
            (false, _) => in_vain += 1,
        }
    }
    assert!(
        at_once > 50 && later > 5 && in_vain > 50,
        "{at_once} {later} {in_vain}"
    );
}
