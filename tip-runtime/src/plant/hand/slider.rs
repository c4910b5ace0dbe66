//! The slider that carries the floor.

use super::Vector;
use super::overlap::Surface;
use crate::model::{Point, Range, Slider};
use crate::plant::Floor;

/// Greatest speed, mm/s.
const FASTEST: f64 = 1000.0;

/// A slider and the floor on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SliderServo {
    travel: [Range; 3],
    /// Position, mm.
    pub(super) position: Point,
    /// Velocity, mm/s.
    velocity: [f64; 3],
}

impl SliderServo {
    /// Returns a slider at rest in the model's initial position.
    pub(super) fn new(slider: Option<&Slider>) -> Self {
        SliderServo {
            travel: slider.map_or([Range::new(0.0, 0.0); 3], |slider| slider.travel),
            position: slider.map_or([0.0; 3], |slider| slider.initial),
            velocity: [0.0; 3],
        }
    }

    /// Starts a motion that arrives in `time` s; a position that is not a number stops the slider.
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

    /// Stops the slider.
    pub(super) const fn halt(&mut self) {
        self.velocity = [0.0; 3];
    }

    /// Moves the slider for `dt` s.
    pub(super) fn advance(&mut self, dt: f64) {
        let axes = self.velocity.iter().zip(self.travel);
        for (at, (velocity, travel)) in self.position.iter_mut().zip(axes) {
            *at = (*at + velocity * dt).max(travel.min).min(travel.max);
        }
    }

    /// Returns the floor on the slider.
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
