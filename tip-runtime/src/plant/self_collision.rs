//! Self-collision: the distances between the links of a robot and its body.
//!
//! A link is a capsule around the line from its joint to the next one, or to the foot; the body is its box.
//! Distances have closed forms, which take square roots and nothing else, in a fixed order.
//!
//! ```
//! use tip_runtime::model::titan8;
//! use tip_runtime::plant::SelfCollision;
//!
//! let bodies = SelfCollision::new(&titan8::MODEL);
//! let stand = titan8::MODEL.legs.map(|leg| leg.initial);
//! let gap = bodies.clearance(&stand).expect("its links are far enough apart to be compared");
//! assert!(gap.distance > 0.0);
//!
//! // Both legs on the left turn by 60 degrees towards each other, and their thighs cross.
//! let mut crossed = stand;
//! (crossed[0][0], crossed[2][0]) = (-60.0, 60.0);
//! let gap = bodies.clearance(&crossed).unwrap();
//! assert!(gap.distance < 0.0);
//! ```

use super::cuboid::Cuboid;
use crate::command::MAX;
use crate::kinematics::frames;
use crate::model::{Body, Joint, Leg, Model, Part};
use core::fmt;
use nalgebra::Vector3;

/// A vector, in mm.
type Vector = Vector3<f64>;

/// A link, by both ends of its line.
pub(super) type Line = [Vector; 2];

/// The distance between two parts of a robot.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Gap {
    /// Distance of the surfaces, mm. Below 0 the parts overlap; the line of a link inside of the body counts as
    /// on its side.
    pub distance: f64,
    /// The parts.
    pub parts: [Part; 2],
}

impl Gap {
    /// Creates the distance (mm) between two parts.
    pub const fn new(distance: f64, parts: [Part; 2]) -> Self {
        Gap { distance, parts }
    }
}

impl fmt::Display for Gap {
    /// Names both parts, such as `link12 and body`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [one, other] = self.parts;
        write!(f, "{one} and {other}")
    }
}

/// The distances between the parts of a robot in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Clearance {
    /// The least distance after the last cycle.
    pub now: Gap,
    /// The least distance so far.
    pub least: Gap,
    /// The control cycle of the least distance, from 0.
    pub cycle: u64,
    /// Number of cycles after which two parts overlapped.
    pub collisions: u32,
}

impl Clearance {
    /// Starts with the least distance in the initial posture.
    pub const fn new(gap: Gap) -> Self {
        Clearance {
            now: gap,
            least: gap,
            cycle: 0,
            collisions: 0,
        }
    }

    /// Records the least distance after a cycle.
    pub fn update(&mut self, gap: Gap, cycle: u64) {
        self.now = gap;
        self.collisions += u32::from(gap.distance < 0.0);
        if gap.distance < self.least.distance {
            (self.least, self.cycle) = (gap, cycle);
        }
    }
}

/// The parts of a robot whose distances are compared. These pairs are not:
///
/// - neighbours in a leg, the first links of two legs, and a first link and the body;
/// - the half of a second link that is next to its joint, and the body;
/// - pairs that overlap in the initial posture;
/// - pairs that the model allows to touch ([`Model::may_touch`]).
#[derive(Clone, Copy, Debug)]
pub struct SelfCollision<const L: usize, const J: usize> {
    legs: [Leg<J>; L],
    body: Option<Cuboid>,
    capsules: [Capsules<J>; L],
}

impl<const L: usize, const J: usize> SelfCollision<L, J> {
    /// Returns the parts of a robot.
    pub fn new(model: &Model<L, J>) -> Self {
        SelfCollision {
            legs: model.legs,
            body: body(model.body.as_ref()),
            capsules: capsules(model),
        }
    }

    /// Returns the least distance of two parts at these joint angles, deg; `None` if no pair is compared.
    pub fn clearance(&self, angles: &[[f64; J]; L]) -> Option<Gap> {
        let mut lines = nowhere();
        for ((lines, leg), angles) in lines.iter_mut().zip(&self.legs).zip(angles) {
            *lines = place(leg, angles);
        }
        nearest(self.body.as_ref(), self.capsules.iter(), &lines)
    }

    /// Calls `found` with each pair of a robot that is not compared for the sole reason that it overlaps in the initial posture, and
    /// with its distance there, which is below 0.
    pub fn left_out(model: &Model<L, J>, found: &mut dyn FnMut(Gap)) {
        choose_pairs(model, found);
    }

    /// Returns true if two links, by leg and joint from 0, are compared.
    pub fn compares(&self, (n, j): (usize, usize), (m, i): (usize, usize)) -> bool {
        let meets = |(n, j): (usize, usize), other| {
            let own: Option<&Capsules<J>> = self.capsules.get(n);
            own.is_some_and(|own| own.meets(j, other))
        };
        meets((n, j), (m, i)) || meets((m, i), (n, j))
    }

    /// Returns the least distance at joint angles in one row, leg by leg; `None` also if the row has another length.
    pub fn clearance_of_row(&self, angles: &[f64]) -> Option<Gap> {
        let (legs, rest) = angles.as_chunks::<J>();
        let legs: &[[f64; J]; L] = legs.try_into().ok().filter(|_| rest.is_empty())?;
        self.clearance(legs)
    }
}

/// The thickness of a leg's links, and the parts with which they are compared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Capsules<const J: usize> {
    /// Radius of each link, mm.
    radii: [f64; J],
    /// The parts with which each link is compared.
    compared: [PartSet; J],
}

/// The number of the body among the parts; link m of leg n has the number n · 9 + m, from 0.
const BODY: usize = MAX * MAX;

/// Links that are not placed yet.
pub(super) const fn nowhere<const J: usize>() -> [[Line; J]; MAX] {
    [[[Vector::new(0.0, 0.0, 0.0); 2]; J]; MAX]
}

/// A set of parts, by their numbers: two words, since one of 128 bits would be aligned to 16 bytes.
#[derive(Clone, Copy, Debug)]
struct PartSet([u64; 2]);

impl PartSet {
    #[inline]
    fn has(&self, number: usize) -> bool {
        let word = self.0.get(number / 64);
        word.is_some_and(|word| word >> (number % 64) & 1 == 1)
    }

    fn add(&mut self, number: usize) {
        if let Some(word) = self.0.get_mut(number / 64) {
            *word |= 1 << (number % 64);
        }
    }
}

impl<const J: usize> Capsules<J> {
    /// Returns links that are compared with nothing.
    pub(super) const NONE: Self = Capsules {
        radii: [0.0; J],
        compared: [PartSet([0; 2]); J],
    };

    /// Returns the radius of a link, mm.
    #[inline]
    pub(super) fn radius(&self, j: usize) -> f64 {
        self.radii.get(j).copied().unwrap_or(0.0)
    }

    /// Returns true if a link is compared with link `i` of leg `other`.
    #[inline]
    pub(super) fn meets(&self, j: usize, (other, i): (usize, usize)) -> bool {
        self.has(j, other * MAX + i)
    }

    #[inline]
    fn has(&self, j: usize, part: usize) -> bool {
        self.compared.get(j).is_some_and(|of| of.has(part))
    }

    /// Returns the box around a leg.
    #[inline]
    fn around(&self, lines: &[Line; J]) -> Cuboid {
        let mut low = Vector::repeat(f64::INFINITY);
        let mut high = -low;
        for ([start, end], radius) in lines.iter().zip(&self.radii) {
            let radius = Vector::repeat(*radius);
            low = low.inf(&(start - radius)).inf(&(end - radius));
            high = high.sup(&(start + radius)).sup(&(end + radius));
        }
        Cuboid { low, high }
    }
}

/// Returns the box of a body, mm.
pub(super) fn body(body: Option<&Body>) -> Option<Cuboid> {
    body.map(|body| Cuboid::of_body(body, 1.0))
}

/// Returns the links of a leg in the robot frame.
fn place<const J: usize>(leg: &Leg<J>, angles: &[f64; J]) -> [Line; J] {
    let mut lines = [[Vector::zeros(); 2]; J];
    let links = frames(leg.base, &leg.joints, angles).zip(&leg.joints);
    for (line, (frame, joint)) in lines.iter_mut().zip(links) {
        *line = [frame.point([0.0; 3]), frame.point(joint.link)].map(Vector::from);
    }
    lines
}

/// Returns the links of every leg of a robot.
pub(super) fn capsules<const L: usize, const J: usize>(model: &Model<L, J>) -> [Capsules<J>; L] {
    choose_pairs(model, &mut |_| ())
}

/// Returns the links of every leg of a robot, and calls `left_out` with each pair that overlaps in the initial posture.
fn choose_pairs<const L: usize, const J: usize>(
    model: &Model<L, J>,
    left_out: &mut dyn FnMut(Gap),
) -> [Capsules<J>; L] {
    let mut capsules = [Capsules::NONE; L];
    let body = body(model.body.as_ref());
    let may_touch = model.may_touch.iter().flatten();
    choose(
        &mut capsules,
        &model.legs,
        body.as_ref(),
        may_touch,
        left_out,
    );
    capsules
}

/// Chooses the pairs that are compared. Of a pair that would be compared if it did not overlap now, `left_out` gets the distance.
// Out of line, or it would be copied for each number of legs.
#[inline(never)]
fn choose<'a, const J: usize>(
    capsules: &mut [Capsules<J>],
    legs: &[Leg<J>],
    body: Option<&Cuboid>,
    may_touch: impl Iterator<Item = &'a [Part; 2]> + Clone,
    left_out: &mut dyn FnMut(Gap),
) {
    let mut lines = nowhere();
    for ((lines, leg), own) in lines.iter_mut().zip(legs).zip(capsules.iter_mut()) {
        *lines = place(leg, &leg.initial);
        own.radii = leg.joints.each_ref().map(Joint::thickness);
    }
    let radii = |n: usize, j: usize| {
        legs.get(n)
            .and_then(|leg| leg.joints.get(j))
            .map_or(0.0, Joint::thickness)
    };
    let line = |n: usize, j: usize| lines.get(n).and_then(|of| of.get(j)).copied();
    let may_touch = |[one, other]: [Part; 2]| {
        let mut pairs = may_touch.clone();
        pairs.any(|pair| *pair == [one, other] || *pair == [other, one])
    };
    for (n, own) in capsules.iter_mut().enumerate() {
        for (j, compared) in own.compared.iter_mut().enumerate() {
            let (Some(one), part) = (line(n, j), Part::link(n, j)) else {
                continue;
            };
            for m in 0..=n {
                // The other link comes first in a leg of its own, so that each pair is compared once.
                let links = if m == n { j.saturating_sub(1) } else { J };
                for i in 0..links {
                    let Some(other) = line(m, i) else {
                        continue;
                    };
                    let are_hips = (j, i) == (0, 0);
                    let parts = [part, Part::link(m, i)];
                    if are_hips || may_touch(parts) {
                        continue;
                    }
                    let distance = between(one, other) - (radii(n, j) + radii(m, i));
                    if distance >= 0.0 {
                        compared.add(m * MAX + i);
                    } else {
                        left_out(Gap { distance, parts });
                    }
                }
            }
            let parts = [part, Part::Body];
            let Some(body) = body.filter(|_| j > 0 && !may_touch(parts)) else {
                continue;
            };
            let distance = to_box(body, beside(one, j)) - radii(n, j);
            if distance >= 0.0 {
                compared.add(BODY);
            } else {
                left_out(Gap { distance, parts });
            }
        }
    }
}

/// Returns the part of a link that is compared with the body.
#[inline]
fn beside([start, end]: Line, j: usize) -> Line {
    match j {
        1 => [(start + end) / 2.0, end],
        _ => [start, end],
    }
}

/// Returns the least distance of two parts, whose links lie on these lines in the robot frame. Among equal distances
/// the first pair counts.
pub(super) fn nearest<'a, const J: usize>(
    body: Option<&Cuboid>,
    capsules: impl Iterator<Item = &'a Capsules<J>> + Clone,
    lines: &[[Line; J]; MAX],
) -> Option<Gap> {
    let mut boxes = [Cuboid {
        low: Vector::zeros(),
        high: Vector::zeros(),
    }; MAX];
    for ((around, own), lines) in boxes.iter_mut().zip(capsules.clone()).zip(lines) {
        *around = own.around(lines);
    }
    let legs = || capsules.clone().zip(lines).zip(&boxes).enumerate();
    let mut least: Option<Gap> = None;
    let mut keep = |distance: f64, one: (usize, usize), other: Option<(usize, usize)>| {
        if least.is_none_or(|least| distance < least.distance) {
            let other = other.map_or(Part::Body, |(m, i)| Part::link(m, i));
            least = Some(Gap {
                distance,
                parts: [Part::link(one.0, one.1), other],
            });
        }
        least.map_or(f64::INFINITY, |least| least.distance)
    };
    let mut best = f64::INFINITY;
    for (n, ((own, lines), around)) in legs() {
        if let Some(body) = body.filter(|body| around.may_be_within(best, body)) {
            for (j, line) in lines.iter().enumerate() {
                if own.has(j, BODY) {
                    let distance = to_box(body, beside(*line, j)) - own.radius(j);
                    best = keep(distance, (n, j), None);
                }
            }
        }
        for (m, ((other, others), theirs)) in legs().take(n + 1) {
            if !around.may_be_within(best, theirs) {
                continue;
            }
            for (j, line) in lines.iter().enumerate() {
                for (i, opposite) in others.iter().enumerate() {
                    if own.meets(j, (m, i)) {
                        let thickness = own.radius(j) + other.radius(i);
                        best = keep(between(*line, *opposite) - thickness, (n, j), Some((m, i)));
                    }
                }
            }
        }
    }
    least
}

/// Returns the distance of two lines, mm.
#[inline]
fn between(one: Line, other: Line) -> f64 {
    let [at, from] = nearest_points(one, other);
    (at - from).norm()
}

/// Returns the nearest points of two lines (Ericson, *Real-Time Collision Detection*, 2005, §5.1.9), in any unit.
#[inline]
pub(super) fn nearest_points([a, b]: Line, [c, d]: Line) -> [Vector; 2] {
    let (along, across, apart) = (b - a, d - c, a - c);
    let (square, other) = (along.norm_squared(), across.norm_squared());
    let (to, of) = (along.dot(&apart), across.dot(&apart));
    let both = along.dot(&across);
    let area = square * other - both * both;
    // On parallel lines any point of the first one is nearest.
    let share = if area > 1e-12 * square * other {
        fraction(both * of - to * other, area)
    } else {
        0.0
    };
    let second = fraction(both * share + of, other);
    let share = fraction(both * second - to, square);
    [a + along * share, c + across * second]
}

/// Returns the fraction, limited to 0…1.
#[inline]
fn fraction(of: f64, total: f64) -> f64 {
    if total > 0.0 && of > 0.0 {
        (of / total).min(1.0)
    } else {
        0.0
    }
}

/// Returns the distance of a line from a box, mm; 0 if they meet.
///
/// The square of the distance is convex along the line, and its slope is linear between the planes of the sides. Each
/// plane halves the range that holds the least distance, until the slope is linear in it.
#[inline]
fn to_box(cuboid: &Cuboid, [start, end]: Line) -> f64 {
    let way = end - start;
    let out = |share: f64| cuboid.outside(start + way * share);
    let slope = |share: f64| out(share).dot(&way);
    let (mut from, mut to) = (0.0, 1.0);
    let (mut falls, mut rises) = (slope(from), slope(to));
    if falls >= 0.0 {
        return out(from).norm();
    }
    if rises <= 0.0 {
        return out(to).norm();
    }
    let sides = [cuboid.low - start, cuboid.high - start];
    for (side, along) in sides.iter().flat_map(|side| side.iter().zip(&way)) {
        let share = side / along;
        if share > from && share < to {
            let slope = slope(share);
            if slope < 0.0 {
                (from, falls) = (share, slope);
            } else {
                (to, rises) = (share, slope);
            }
        }
    }
    out(from + (to - from) * fraction(-falls, rises - falls)).norm()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{generic, hand, titan8};
    use crate::random::Random;

    /// Returns numbers from -1 to 1.
    fn numbers() -> impl FnMut() -> f64 {
        let mut random = Random::new(1);
        move || random.within(-1.0, 1.0)
    }

    /// Returns points of a line, and the greatest distance of a point of the line from one of them.
    fn sampled([a, b]: Line) -> impl Iterator<Item = Vector> {
        (0..=200).map(move |n| a + (b - a) * (f64::from(n) / 200.0))
    }

    fn least(distances: impl Iterator<Item = f64>) -> f64 {
        distances.fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn nothing_is_nearer_than_the_nearest_points() {
        let mut number = numbers();
        let mut point = || Vector::new(number(), number(), number());
        for _ in 0..50 {
            let (one, other) = ([point(), point()], [point(), point()]);
            let found = between(one, other);
            let points =
                sampled(one).flat_map(|at| sampled(other).map(move |from| (at - from).norm()));
            let tried = least(points);
            assert!(
                found <= tried + 1e-12 && found > tried - 0.02,
                "{found}, {tried}"
            );
            assert!((found - between(other, one)).abs() < 1e-12, "symmetric");
        }
        let origin = Vector::zeros();
        let points = nearest_points([origin, origin], [Vector::x(), Vector::x()]);
        assert_eq!(points, [origin, Vector::x()], "points");
    }

    #[test]
    fn lines_are_as_far_apart_as_geometry_says() {
        let at = |x: f64, y: f64, z: f64| Vector::new(x, y, z);
        let flat = [at(0.0, 0.0, 0.0), at(10.0, 0.0, 0.0)];
        // Over the middle, beyond an end, alongside, a point, and through it.
        let others = [
            ([at(5.0, -5.0, 3.0), at(5.0, 5.0, 3.0)], 3.0),
            ([at(13.0, 4.0, 0.0), at(20.0, 4.0, 0.0)], 5.0),
            ([at(-4.0, 2.0, 0.0), at(4.0, 2.0, 0.0)], 2.0),
            ([at(-3.0, 0.0, 4.0), at(-3.0, 0.0, 4.0)], 5.0),
            ([at(5.0, -5.0, 0.0), at(5.0, 5.0, 0.0)], 0.0),
            ([at(4.0, 2.0, 0.0), at(-4.0, 2.0, 0.0)], 2.0),
            ([at(11.0, 1.0, 0.0), at(30.0, 1.0, 0.0)], 2.0_f64.sqrt()),
        ];
        for (other, expected) in others {
            assert!((between(flat, other) - expected).abs() < 1e-12, "{other:?}");
            assert!((between(other, flat) - expected).abs() < 1e-12, "{other:?}");
        }
    }

    #[test]
    fn nothing_is_nearer_to_a_box_than_the_nearest_point() {
        let mut number = numbers();
        let cuboid = Cuboid {
            low: Vector::new(-0.2, -0.3, -0.1),
            high: Vector::new(0.2, 0.1, 0.4),
        };
        let mut point = || Vector::new(number(), number(), number());
        for count in 0..300 {
            let mut line = [point(), point()];
            if count % 3 == 0 {
                // Along an axis: its quotients are infinite or not numbers.
                line[1].x = line[0].x;
                line[1].y = line[0].y;
            }
            let found = to_box(&cuboid, line);
            let tried = least(sampled(line).map(|at| cuboid.outside(at).norm()));
            assert!(
                found <= tried + 1e-12 && found > tried - 0.01,
                "{line:?}: {found}, {tried}"
            );
            let [a, b] = line;
            assert!((found - to_box(&cuboid, [b, a])).abs() < 1e-12, "{line:?}");
        }
        // Above a side, beside an edge, off a corner, through, inside, and a point.
        let unit = Cuboid {
            low: Vector::zeros(),
            high: Vector::repeat(1.0),
        };
        let v = Vector::new;
        for (line, expected) in [
            ([v(-1.0, 0.5, 3.0), v(2.0, 0.5, 3.0)], 2.0),
            ([v(4.0, -2.0, 5.0), v(4.0, 2.0, 5.0)], 5.0),
            ([v(2.0, 2.0, 3.0), v(4.0, 4.0, 4.0)], 6.0_f64.sqrt()),
            ([v(-1.0, -1.0, -1.0), v(2.0, 2.0, 2.0)], 0.0),
            ([v(0.2, 0.2, 0.2), v(0.8, 0.8, 0.8)], 0.0),
            ([v(1.0, 4.0, 5.0), v(1.0, 4.0, 5.0)], 5.0),
        ] {
            assert!((to_box(&unit, line) - expected).abs() < 1e-12, "{line:?}");
        }
    }

    #[test]
    fn legs_that_cross_overlap_by_the_thickness_of_their_thighs() {
        let bodies = SelfCollision::new(&titan8::MODEL);
        // Level legs turned towards each other until their thighs cross: lines that meet, 12 mm thick each.
        let mut crossed = [[0.0; 3]; 4];
        (crossed[0][0], crossed[2][0]) = (-60.0, 60.0);
        let gap = bodies.clearance(&crossed).unwrap();
        assert!((gap.distance + 24.0).abs() < 1e-9, "{gap:?}");
        assert_eq!(gap.parts, [Part::Link(3, 2), Part::Link(1, 2)]);
        // Mirrored, the right legs meet as far.
        let mut mirrored = [[0.0; 3]; 4];
        (mirrored[1][0], mirrored[3][0]) = (-60.0, 60.0);
        let other = bodies.clearance(&mirrored).unwrap();
        assert!((gap.distance - other.distance).abs() < 1e-9, "{other:?}");
        assert_eq!(other.parts, [Part::Link(4, 2), Part::Link(2, 2)]);
    }

    #[test]
    fn pairs_that_may_touch_are_not_compared() {
        let mut crossed = [[0.0; 3]; 4];
        (crossed[0][0], crossed[2][0]) = (-60.0, 60.0);
        let mut model = titan8::MODEL;
        model.may_touch[0] = Some([Part::Link(1, 2), Part::Link(3, 2)]);
        let gap = SelfCollision::new(&model).clearance(&crossed).unwrap();
        assert_ne!(gap.parts, [Part::Link(3, 2), Part::Link(1, 2)]);
    }

    #[test]
    fn neighbours_hips_and_what_overlaps_at_first_are_not_compared() {
        let capsules = capsules(&titan8::MODEL);
        let [first, second, ..] = capsules;
        assert!(!first.has(0, BODY), "a first link and the body");
        assert!(first.has(1, BODY) && first.has(2, BODY));
        assert!(
            !first.meets(1, (0, 0)) && !first.meets(2, (0, 1)),
            "neighbours"
        );
        assert!(
            first.meets(2, (0, 0)),
            "the first and the third link of a leg"
        );
        assert!(!second.meets(0, (0, 0)), "hips");
        assert!(second.meets(0, (0, 1)) && second.meets(1, (0, 0)));
        let mut model = titan8::MODEL;
        for leg in [0, 2] {
            model.legs[leg].initial = [0.0; 3];
            model.legs[leg].initial[0] = if leg == 0 { -60.0 } else { 60.0 };
        }
        assert!(
            !super::capsules(&model)[2].meets(1, (0, 1)),
            "they overlap at first"
        );
        // The line of a thigh crosses that of the other thigh, by 24 mm, and those of no other links.
        let left_out = |model: &Model<4, 3>| {
            let (mut count, mut last) = (0, None);
            SelfCollision::left_out(model, &mut |gap| {
                count += 1;
                last = Some(gap);
            });
            (count, last)
        };
        let (1, Some(gap)) = left_out(&model) else {
            panic!("{:?}", left_out(&model));
        };
        assert!((gap.distance + 24.0).abs() < 1e-9, "{gap:?}");
        assert_eq!(gap.parts, [Part::Link(3, 2), Part::Link(1, 2)]);
        // A pair that may touch is left out by name, and nothing overlaps where the robot stands.
        model.may_touch[0] = Some([Part::Link(1, 2), Part::Link(3, 2)]);
        assert_eq!(left_out(&model), (0, None));
        assert_eq!(left_out(&titan8::MODEL), (0, None));
    }

    #[test]
    fn thicker_links_are_nearer_by_their_radii() {
        // The lines of the thighs are at the same height and cross, so that the distance is the sum of both radii, negative.
        let mut model = titan8::MODEL;
        let mut crossed = model.legs.map(|leg| leg.initial);
        (crossed[0][0], crossed[2][0]) = (-60.0, 60.0);
        let gap = SelfCollision::new(&model).clearance(&crossed).unwrap();
        // 5 % of 240 mm, twice.
        assert!((gap.distance + 24.0).abs() < 1e-9, "{gap:?}");
        for leg in &mut model.legs {
            leg.joints[1].radius = Some(3.0);
        }
        let gap = SelfCollision::new(&model).clearance(&crossed).unwrap();
        assert!((gap.distance + 6.0).abs() < 1e-9, "{gap:?}");
    }

    #[test]
    fn a_row_of_angles_is_that_of_the_legs() {
        let bodies = SelfCollision::new(&titan8::MODEL);
        let angles = titan8::MODEL.legs.map(|leg| leg.initial);
        let row = angles.as_flattened();
        assert_eq!(bodies.clearance_of_row(row), bodies.clearance(&angles));
        assert_eq!(bodies.clearance_of_row(&row[1..]), None);
        assert!(bodies.compares((0, 1), (2, 1)) && bodies.compares((2, 1), (0, 1)));
        assert!(!bodies.compares((0, 0), (2, 0)), "they are hips");
        assert!(!bodies.compares((4, 0), (0, 1)), "it has four legs");
    }

    #[test]
    fn a_robot_without_pairs_has_no_clearance() {
        let one = titan8::MODEL.with_legs([titan8::MODEL.legs[0]]);
        let bolted = Model { body: None, ..one };
        let bodies = SelfCollision::new(&bolted);
        assert!(
            bodies.clearance(&[[0.0, 0.0, 90.0]]).is_some(),
            "its first and third link"
        );
        for (distance, name) in [
            (
                SelfCollision::new(&titan8::MODEL)
                    .clearance(&titan8::MODEL.legs.map(|leg| leg.initial)),
                "titan8",
            ),
            (
                SelfCollision::new(&generic::MODEL)
                    .clearance(&generic::MODEL.legs.map(|leg| leg.initial)),
                "generic",
            ),
            (
                SelfCollision::new(&hand::MODEL)
                    .clearance(&hand::MODEL.legs.map(|leg| leg.initial)),
                "hand",
            ),
        ] {
            assert!(distance.unwrap().distance > 0.0, "{name}");
        }
    }
}
