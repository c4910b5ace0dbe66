//! An independent decision if a finger can follow a straight line at all, found by trying every
//! posture: closed forms of two joints, and for the fingertip every direction of its last link.
//! Nothing here is the robot's own.

const LENGTHS: [f64; 3] = [70.0, 50.0, 40.0];
const LIMITS: [[f64; 2]; 3] = [[-90.0, 90.0], [-10.0, 110.0], [-10.0, 110.0]];

/// Bend of joint 2 below which it is straight and may bend to either side, deg.
const STRAIGHT: f64 = 0.01;

/// Number of pieces of a line.
const PIECES: usize = 80;

/// Directions of the last link: from `FIRST` deg on, `FINENESS` of them to a degree.
const FIRST: f64 = -110.0;
const FINENESS: usize = 2;
const DIRECTIONS: usize = 420 * FINENESS;

/// A place in a frame at the finger's base in which every finger closes to the right, mm.
pub(crate) type Place = [f64; 2];

/// Returns the places of joint 3 and the fingertip.
pub(crate) fn places(angles: [f64; 3]) -> [Place; 2] {
    let (mut at, mut turned, mut found) = ([0.0, 0.0], 0.0_f64, [[0.0; 2]; 3]);
    for (m, (length, angle)) in LENGTHS.iter().zip(angles).enumerate() {
        turned += angle.to_radians();
        at = [at[0] + length * turned.sin(), at[1] - length * turned.cos()];
        found[m] = at;
    }
    [found[1], found[2]]
}

fn within(m: usize, angle: f64) -> bool {
    angle >= LIMITS[m][0] && angle <= LIMITS[m][1]
}

/// Returns the angles of joints 1 and 2 that put joint 3 at a place, with joint 2 bent to a side
/// (±1).
fn two_joints([x, y]: Place, side: f64) -> Option<[f64; 2]> {
    let [a, b, _] = LENGTHS;
    let bend = (x * x + y * y - a * a - b * b) / (2.0 * a * b);
    if bend.abs() > 1.0 + 1e-9 {
        return None;
    }
    let second = side * bend.clamp(-1.0, 1.0).acos();
    let first = x.atan2(-y) - (b * second.sin()).atan2(a + b * second.cos());
    let angles = [first.to_degrees(), second.to_degrees()];
    (within(0, angles[0]) && within(1, angles[1])).then_some(angles)
}

fn on_line(from: Place, to: Place, piece: usize) -> Place {
    let share = piece as f64 / PIECES as f64;
    [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
}

/// Returns the sides to which joint 2 may be bent on the whole line.
fn sides(start: [f64; 3]) -> Vec<f64> {
    let both = [1.0, -1.0].into_iter();
    both.filter(|side| side * start[1] > -STRAIGHT).collect()
}

/// Returns true if joint 3 can go straight from a posture to a place, without changing the side of
/// the elbow.
pub(crate) fn third_joint_goes(start: [f64; 3], to: Place) -> bool {
    let [from, _] = places(start);
    sides(start)
        .into_iter()
        .any(|side| (1..=PIECES).all(|piece| two_joints(on_line(from, to, piece), side).is_some()))
}

/// Returns the directions of the last link in which the fingertip can be at a place.
fn directions(at: Place, side: f64) -> Vec<bool> {
    let tries = (0..DIRECTIONS).map(|number| {
        let direction = FIRST + number as f64 / FINENESS as f64;
        let (sin, cos) = direction.to_radians().sin_cos();
        let third = [at[0] - LENGTHS[2] * sin, at[1] + LENGTHS[2] * cos];
        two_joints(third, side).is_some_and(|[first, second]| within(2, direction - first - second))
    });
    tries.collect()
}

/// Returns true if the fingertip can go straight from a posture to a place, without changing the
/// side of the elbow: possible directions spread to their neighbours, piece by piece of the line.
pub(crate) fn fingertip_goes(start: [f64; 3], to: Place) -> bool {
    let [_, from] = places(start);
    let direction = (start.iter().sum::<f64>() - FIRST) * FINENESS as f64;
    sides(start).into_iter().any(|side| {
        let mut reached: Vec<bool> = (0..DIRECTIONS)
            .map(|number| (number as f64 - direction).abs() <= 1.0)
            .collect();
        for piece in 1..=PIECES {
            let can = directions(on_line(from, to, piece), side);
            let mut next: Vec<bool> = (0..DIRECTIONS)
                .map(|i| {
                    can[i] && reached[i.saturating_sub(1)..(i + 2).min(DIRECTIONS)].contains(&true)
                })
                .collect();
            for i in 1..DIRECTIONS {
                next[i] |= can[i] && next[i - 1];
            }
            for i in (1..DIRECTIONS).rev() {
                next[i - 1] |= can[i - 1] && next[i];
            }
            reached = next;
        }
        reached.contains(&true)
    })
}
