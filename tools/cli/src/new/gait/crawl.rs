//! The body of a crawl: where it leans when a foot lifts, how long that takes, and how far feet are away then.

use crate::new::gait::reach::{Twist, beside, left_behind};
use tip_runtime::model::Point;

/// Number of times that the stride and the ways in it are calculated from each other.
const ITERATIONS: usize = 4;
/// Least part of the time to lean from one side to the other.
const LEAST: f64 = 0.25;
/// Number of parts of a lean that are looked at.
const SAMPLES: u32 = 8;

/// A crawl at a velocity that stays the same.
pub(super) struct Crawl<'a> {
    /// Places of the feet at rest, mm.
    pub(super) homes: &'a [Point],
    /// Legs in the order of their swings, from 0.
    pub(super) order: &'a [usize],
    /// Part of a foot's way from the middle that the body leans away from it.
    pub(super) share: f64,
    /// Time of a foot in the air, s.
    pub(super) swing: f64,
    /// Time to lean from one side to the other at rest, s.
    pub(super) shift: f64,
}

impl Crawl<'_> {
    /// Returns the distance that the body leans from one side to the other at rest, mm.
    pub(super) fn full(homes: &[Point], share: f64) -> f64 {
        2.0 * share * homes.first().map_or(0.0, |[x, y, _]| x.hypot(*y))
    }

    /// Returns the time in which every foot swings once, s.
    pub(super) fn stride(&self, twist: Twist) -> f64 {
        let count = self.order.len();
        let mut stride = count as f64 * (self.shift + self.swing);
        for _ in 0..ITERATIONS {
            // The body leans enough when half of the swing is over.
            let leans: Vec<[f64; 2]> = (0..count)
                .map(|place| self.lean(twist, stride, place, self.swing / 2.0))
                .collect();
            let times = (0..count).map(|place| {
                let from = leans[(place + count - 1) % count];
                self.swing + self.time(from, leans[place])
            });
            stride = times.sum();
        }
        stride
    }

    /// Returns the largest distance of a foot from its place below the body, mm, if the body looks ahead by a time (s). A way to the side
    /// counts as a multiple of it ahead.
    pub(super) fn farthest(&self, twist: Twist, side: f64, time: f64) -> f64 {
        let (count, stride) = (self.order.len(), self.stride(twist));
        let half = self.swing / 2.0;
        let mut farthest = 0.0_f64;
        for place in 0..count {
            let [from, to] = [(place + count - 1) % count, place]
                .map(|place| self.lean(twist, stride, place, half));
            let first = self.time(from, to);
            let mut add = |[x, y]: [f64; 2], body: [f64; 2]| {
                farthest = farthest.max((side * (x - body[0])).hypot(y - body[1]));
            };
            for sample in 0..=SAMPLES {
                let part = f64::from(sample) / f64::from(SAMPLES);
                let share = (1.0 - (std::f64::consts::PI * part).cos()) / 2.0;
                let body = [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]));
                for leg in self.order {
                    let since = (part - 1.0) * first + time;
                    add(self.moved(twist, stride, place, *leg, since), body);
                }
            }
            for leg in self.order {
                add(self.moved(twist, stride, place, *leg, time), [0.0; 2]);
            }
            // The foot that lifted lands as far ahead as it was behind.
            let landing = time - (stride - self.swing) / 2.0;
            add(self.moved_by(twist, self.order[place], landing), to);
        }
        farthest
    }

    /// Returns the time in which the body leans from one place to another, s: at the same acceleration, the root of the way.
    fn time(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let way = (to[0] - from[0]).hypot(to[1] - from[1]);
        let part = way / Self::full(self.homes, self.share);
        self.shift * part.sqrt().max(LEAST)
    }

    /// Returns where the body leans in a time (s) after the foot at a place in the order lifts, mm.
    fn lean(&self, twist: Twist, stride: f64, place: usize, time: f64) -> [f64; 2] {
        let leg = self.order[place];
        let [one, other] =
            beside(self.homes, leg).map(|leg| self.moved(twist, stride, place, leg, time));
        [0, 1].map(|axis| (one[axis] + other[axis]) / 2.0 - self.share * self.homes[leg][axis])
    }

    /// Returns how far a foot on the floor is from its place, in a time (s) after the foot at a place in the order lifts, mm.
    fn moved(&self, twist: Twist, stride: f64, place: usize, leg: usize, time: f64) -> [f64; 2] {
        let count = self.order.len();
        let own = self.order.iter().position(|other| *other == leg);
        let ago = (place + count - own.unwrap_or(0)) % count;
        // The foot that lifts stood longest.
        let ago = if ago == 0 { count } else { ago };
        let since = (stride - self.swing) / 2.0 - (count - ago) as f64 * stride / count as f64;
        self.moved_by(twist, leg, since + time)
    }

    /// Returns how far a foot is from its place a time (s) after it was there, mm.
    fn moved_by(&self, twist: Twist, leg: usize, time: f64) -> [f64; 2] {
        let home = self.homes[leg];
        let [x, y, _] = left_behind(home, twist, time);
        [x - home[0], y - home[1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point; 4] = [
        [-100.0, 100.0, 0.0],
        [100.0, 100.0, 0.0],
        [-100.0, -100.0, 0.0],
        [100.0, -100.0, 0.0],
    ];
    const CRAWL: Crawl<'static> = Crawl {
        homes: &SQUARE,
        order: &[2, 0, 3, 1],
        share: 0.2,
        swing: 0.2,
        shift: 0.8,
    };

    /// At rest the body goes round a square of 40 mm beside the middle: along two of its sides and two of its diagonals.
    #[test]
    fn a_shorter_way_takes_less_time() {
        let side = 0.8 * 0.5_f64.sqrt().sqrt();
        let stride = 4.0 * 0.2 + 2.0 * 0.8 + 2.0 * side;
        assert!((CRAWL.stride([0.0; 3]) - stride).abs() < 1e-9);
    }

    /// At rest a foot is away from its place below the body by what the body leans: 20 mm along both axes.
    #[test]
    fn a_body_that_leans_takes_the_places_of_its_feet_along() {
        let farthest = CRAWL.farthest([0.0; 3], 1.0, 0.3);
        assert!((farthest - 20.0 * 2.0_f64.sqrt()).abs() < 1e-9);
    }

    /// The foot that lifts was half of the time on the floor behind its place, and the two beside it half and a quarter of a stride less.
    #[test]
    fn feet_are_farther_away_the_faster_the_body_is() {
        let twist = [0.0, 100.0, 0.0];
        let stride = CRAWL.stride(twist);
        let quarter = stride / 4.0;
        let half = (stride - 0.2) / 2.0;
        let behind = |ago: f64| -100.0 * (half - (4.0 - ago) * quarter);
        // F3 lifts; F2 landed last, then F4, and F1 is the next. The body goes on for half of the swing.
        let lean = (behind(3.0) + behind(2.0)) / 2.0 + 20.0 - 100.0 * 0.1;
        let away = (behind(4.0) - 0.3 * 100.0 - lean).hypot(20.0);
        assert!(CRAWL.farthest(twist, 1.0, 0.3) >= away - 1e-9);
        let faster = CRAWL.farthest([0.0, 120.0, 0.0], 1.0, 0.3);
        assert!(faster > CRAWL.farthest(twist, 1.0, 0.3));
    }
}
