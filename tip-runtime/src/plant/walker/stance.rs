//! The stance: the body moves so that its stance feet stay in place.

use super::Vector;
use super::pose::FloorPose;
use super::support::Contacts;
use nalgebra::{Rotation3, Vector2};

/// Feet and belly on the floor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stance<const L: usize> {
    /// Position of each contact on the floor, `None` in the air.
    places: Contacts<Option<Vector2<f64>>, L>,
    /// Position of each foot's touchdown.
    touchdowns: [Option<Vector2<f64>>; L],
    slips: [f64; L],
    worst: f64,
    /// Speed of the body along the floor: mm/s.
    speed: f64,
}

impl<const L: usize> Stance<L> {
    /// Returns a stance without contacts.
    pub(super) const fn new() -> Self {
        Stance {
            places: Contacts::new([None; L], [None; 4]),
            touchdowns: [None; L],
            slips: [0.0; L],
            worst: 0.0,
            speed: 0.0,
        }
    }

    /// Returns the slip of a foot since its touchdown, mm.
    pub(super) fn slip(&self, leg: usize) -> f64 {
        self.slips.get(leg).copied().unwrap_or(0.0)
    }

    /// Returns the greatest slip of a foot so far, mm.
    pub(super) const fn worst(&self) -> f64 {
        self.worst
    }

    /// Moves the body so that contacts that persist stay in place: the rigid motion of least
    /// squares, weighted by the loads, which determine friction. A body that falls gains at most
    /// `pull` mm/s² along the floor within `dt` s, the limit of friction; its feet slip. If none
    /// persists because others carry the body now, those that did stay in place: they carried it
    /// until then. Returns the new rotation from the robot frame to the floor's.
    pub(super) fn follow(
        &mut self,
        points: &Contacts<Vector, L>,
        loads: &Contacts<f64, L>,
        body: &mut FloorPose,
        (pull, dt): (Option<f64>, f64),
    ) -> Rotation3<f64> {
        let levelling = FloorPose::levelling(body.normal);
        let mut stays = self.stays(points, loads, &levelling);
        let is_carried = loads.iter().any(|load| *load > 0.0);
        if is_carried && stays.iter().all(Option::is_none) {
            let alike = loads.map(|_| 1.0);
            stays = self.stays(points, &alike, &levelling);
        }
        let from = Vector2::new(body.x, body.y);
        fit(stays.iter().flatten(), body);
        let way = Vector2::new(body.x, body.y) - from;
        let mut length = way.norm();
        if let Some(pull) = pull {
            let farthest = (self.speed + pull * dt) * dt;
            if length > farthest {
                let place = from + way * (farthest / length);
                (body.x, body.y) = (place.x, place.y);
                length = farthest;
            }
        }
        if dt > 0.0 {
            self.speed = length / dt;
        }
        let rotation = body.headed(&levelling);
        self.remember(points, loads, body, &rotation);
        rotation
    }

    /// Returns the contacts that persist.
    fn stays(
        &self,
        points: &Contacts<Vector, L>,
        loads: &Contacts<f64, L>,
        levelling: &Rotation3<f64>,
    ) -> Contacts<Option<ContactPair>, L> {
        let (mut weights, mut places) = (loads.iter(), self.places.iter());
        points.map(|point| {
            let (weight, place) = (*weights.next()?, (*places.next()?)?);
            (weight > 0.0).then(|| ContactPair {
                own: (levelling * point).xy(),
                place,
                weight,
            })
        })
    }

    fn remember(
        &mut self,
        points: &Contacts<Vector, L>,
        loads: &Contacts<f64, L>,
        body: &FloorPose,
        rotation: &Rotation3<f64>,
    ) {
        let here = Vector2::new(body.x, body.y);
        let place =
            |point: &Vector, load: &f64| (*load > 0.0).then(|| (rotation * point).xy() + here);
        let belly = points.belly.iter().zip(&loads.belly);
        for (old, (point, load)) in self.places.belly.iter_mut().zip(belly) {
            *old = place(point, load);
        }
        let feet = points.feet.iter().zip(&loads.feet);
        for (old, (point, load)) in self.places.feet.iter_mut().zip(feet) {
            *old = place(point, load);
        }
        self.measure_slips();
    }

    fn measure_slips(&mut self) {
        let touchdowns = self.touchdowns.iter_mut().zip(&mut self.slips);
        for ((touchdown, slip), place) in touchdowns.zip(self.places.feet) {
            *slip = match place {
                Some(place) => (place - *touchdown.get_or_insert(place)).norm(),
                None => {
                    *touchdown = None;
                    0.0
                }
            };
            self.worst = self.worst.max(*slip);
        }
    }
}

/// A contact that persists.
struct ContactPair {
    /// Position from the body's origin, levelled, without heading, mm.
    own: Vector2<f64>,
    /// Previous position on the floor, mm.
    place: Vector2<f64>,
    /// Load, N.
    weight: f64,
}

/// Mean square distance from their centre below which contacts do not determine the heading, mm². A
/// lone contact is as far from its centre as rounding puts it.
const POINT: f64 = 1e-6;

/// Moves the body by the planar rigid motion of weighted least squares (Kabsch, Acta Cryst. A32,
/// 1976, in two dimensions). Without contacts the body keeps place and heading, with one contact
/// its heading.
fn fit<'a>(pairs: impl Iterator<Item = &'a ContactPair> + Clone, body: &mut FloorPose) {
    let mut total = 0.0;
    let (mut own_centre, mut place_centre) = (Vector2::zeros(), Vector2::zeros());
    for ContactPair { own, place, weight } in pairs.clone() {
        total += weight;
        own_centre += own * *weight;
        place_centre += place * *weight;
    }
    if total <= 0.0 {
        return;
    }
    own_centre /= total;
    place_centre /= total;
    let (mut along, mut across) = (0.0, 0.0);
    for ContactPair { own, place, weight } in pairs {
        let (own, place) = (own - own_centre, place - place_centre);
        along += weight * own.dot(&place);
        across += weight * own.perp(&place);
    }
    if libm::hypot(along, across) > POINT * total {
        body.heading = libm::atan2(across, along);
    }
    let (sin, cos) = (libm::sin(body.heading), libm::cos(body.heading));
    body.x = place_centre.x - (cos * own_centre.x - sin * own_centre.y);
    body.y = place_centre.y - (sin * own_centre.x + cos * own_centre.y);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns six feet on the floor that have moved backward by `back` mm under the body.
    fn hexapod(back: f64) -> Contacts<Vector, 6> {
        let feet = [-1.0, 1.0, -1.0, 1.0, -1.0, 1.0];
        let mut end = [200.0, 200.0, 0.0, 0.0, -200.0, -200.0].into_iter();
        let feet = feet.map(|side| {
            let y: f64 = end.next().unwrap_or(0.0);
            Vector::new(100.0 * side, y - back, -100.0)
        });
        Contacts::new(feet, [Vector::zeros(); 4])
    }

    /// Returns the position of the body after its feet moved backward by 4 mm while the load went
    /// from some of them to others.
    fn moved(before: [f64; 6], after: [f64; 6]) -> [f64; 2] {
        let mut stance = Stance::new();
        let mut body = FloorPose::standing(None);
        for (back, loads) in [(0.0, before), (4.0, after)] {
            let loads = Contacts::new(loads, [0.0; 4]);
            stance.follow(&hexapod(back), &loads, &mut body, (None, 0.02));
        }
        [body.x, body.y]
    }

    #[test]
    fn the_body_moves_on_while_its_supporting_feet_change() {
        let one = [9.0, 0.0, 0.0, 9.0, 9.0, 0.0];
        let other = [0.0, 9.0, 9.0, 0.0, 0.0, 9.0];
        let is_at = |at: [f64; 2], y: f64| at[0].abs() < 1e-9 && (at[1] - y).abs() < 1e-9;
        // The load stays on the same feet, moves to some of them, and to none of them.
        for after in [one, [9.0, 0.0, 9.0, 9.0, 0.0, 0.0], other] {
            let at = moved(one, after);
            assert!(is_at(at, 4.0), "{after:?}: {at:?}");
        }
        assert!(is_at(moved(one, [0.0; 6]), 0.0), "nothing carries it");
        assert!(is_at(moved([0.0; 6], other), 0.0), "nothing carried it");
    }
}
