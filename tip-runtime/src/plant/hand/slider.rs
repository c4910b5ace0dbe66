//! The slider that carries the floor.

use super::Vector;
use super::overlap::Surface;
use crate::model::{Point, Range, Slider};
use crate::plant::Floor;

/// How fast it goes at most: mm/s.
const FASTEST: f64 = 1000.0;

/// A slider and the floor on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SliderServo {
    travel: [Range; 3],
    /// mm.
    pub(super) position: Point,
    /// mm/s.
    velocity: [f64; 3],
}

impl SliderServo {
    /// At rest where the model has it at first.
    pub(super) fn new(slider: Option<&Slider>) -> Self {
        SliderServo {
            travel: slider.map_or([Range::new(0.0, 0.0); 3], |slider| slider.travel),
            position: slider.map_or([0.0; 3], |slider| slider.initial),
            velocity: [0.0; 3],
        }
    }

    /// Is sent somewhere, to arrive in `time` s; a position that is not a number leaves it where it is.
    pub(super) fn send(&mut self, target: Point, time: f64) {
        let axes = self.velocity.iter_mut().zip(self.position);
        for ((velocity, at), (target, travel)) in axes.zip(target.iter().zip(self.travel)) {
            let way = target.max(travel.min).min(travel.max) - at;
            *velocity = if target.is_finite() {
                (way / time).clamp(-FASTEST, FASTEST)
            } else {
                0.0
            };
        }
    }

    /// Stays where it is.
    pub(super) const fn halt(&mut self) {
        self.velocity = [0.0; 3];
    }

    /// Goes on for `dt` s.
    pub(super) fn advance(&mut self, dt: f64) {
        let axes = self.velocity.iter().zip(self.travel);
        for (at, (velocity, travel)) in self.position.iter_mut().zip(axes) {
            *at = (*at + velocity * dt).max(travel.min).min(travel.max);
        }
    }

    /// The floor that it carries.
    pub(super) fn floor(&self, floor: &Floor, friction: f64) -> Surface {
        let [x, y, _] = self.position;
        let [vx, vy, _] = self.velocity;
        let [rise, _] = floor.slope;
        Surface {
            point: Vector::new(x, y + floor.height) / 1000.0,
            normal: Vector::new(-rise, 1.0).normalize(),
            velocity: Vector::new(vx, vy) / 1000.0,
            friction,
        }
    }
}
