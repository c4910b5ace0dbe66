//! The body: a box that floats, or a frame that is bolted down.

use super::Vector;
use super::contact::Grip;
use super::frame::Frame;
use super::spatial::{Inertia, Spatial};
use super::world::{GRAVITY, Share, World};
use crate::model::{Body, Range};
use nalgebra::{Matrix3, Rotation3};

/// The body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trunk {
    /// `None` if it is bolted down.
    pub(super) model: Option<Body>,
    pub(super) frame: Frame,
    /// Of its corners.
    grips: [Grip; 8],
    /// What each of its corners carries: N.
    pub(super) loads: [f64; 8],
    pub(super) push: Push,
}

/// A force on the body's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Push {
    /// N, in the world.
    pub(super) force: Vector,
    /// For how many more cycles.
    pub(super) cycles: u32,
}

impl Push {
    const NONE: Self = Push {
        force: Vector::new(0.0, 0.0, 0.0),
        cycles: 0,
    };

    /// A cycle is over.
    pub(super) const fn tire(&mut self) {
        match self.cycles.checked_sub(1) {
            Some(left @ 1..) => self.cycles = left,
            _ => *self = Push::NONE,
        }
    }
}

impl Trunk {
    pub(super) fn new(model: Option<Body>) -> Self {
        Trunk {
            model,
            frame: Frame {
                position: Vector::zeros(),
                rotation: Rotation3::identity(),
                velocity: Vector::zeros(),
                rate: Vector::zeros(),
            },
            grips: [Grip::FREE; 8],
            loads: [0.0; 8],
            push: Push::NONE,
        }
    }

    pub(super) fn mass(&self) -> f64 {
        self.model.map_or(0.0, |body| body.mass)
    }

    /// Its corners in its own frame, those of the belly first: m.
    pub(super) fn corners(&self) -> [Vector; 8] {
        let corners = |body: Body| {
            let (x, y, z) = (body.x, body.y, body.z);
            [
                [x.min, y.min, z.min],
                [x.max, y.min, z.min],
                [x.max, y.max, z.min],
                [x.min, y.max, z.min],
                [x.min, y.min, z.max],
                [x.max, y.min, z.max],
                [x.max, y.max, z.max],
                [x.min, y.max, z.max],
            ]
            .map(|corner| Vector::from(corner) / 1000.0)
        };
        self.model.map_or([Vector::zeros(); 8], corners)
    }

    /// What it weighs, and what forces act on it.
    pub(super) fn place(&mut self, world: &World<'_>) -> Share {
        let Some(body) = self.model else {
            return Share::NONE;
        };
        let Frame { rotation, rate, .. } = self.frame;
        let own = rotation * Matrix3::from_diagonal(&box_inertia(&body)) * rotation.inverse();
        let weight = Vector::new(0.0, 0.0, GRAVITY * body.mass);
        let mut force = Spatial {
            angular: rate.cross(&(own * rate)),
            linear: weight - self.push.force,
        };
        let corners = self.corners();
        let contacts = self.grips.iter_mut().zip(&mut self.loads);
        for ((grip, load), corner) in contacts.zip(corners) {
            let arm = rotation * corner;
            let touch =
                (world.terrain).and_then(|terrain| terrain.touch(self.frame.position + arm));
            let velocity = self.frame.velocity + rate.cross(&arm);
            let push = grip.force(touch, velocity, world.law, world.stride.dt);
            *load = touch.map_or(0.0, |touch| push.dot(&touch.normal));
            force = force - Spatial::pushing(push, arm);
        }
        Share {
            inertia: Inertia::new(body.mass, Vector::zeros(), own),
            force,
        }
    }

    /// Moves on for `dt` s, unless it is bolted down.
    pub(super) fn advance(&mut self, acceleration: [f64; 6], dt: f64) {
        if self.model.is_some() {
            self.frame.advance(acceleration, dt);
        }
    }
}

/// Of a uniform box about its middle, which is taken to be where its mass is: kg·m².
fn box_inertia(body: &Body) -> Vector {
    let square = |range: Range| {
        let length = (range.max - range.min) / 1000.0;
        length * length
    };
    let (x, y, z) = (square(body.x), square(body.y), square(body.z));
    Vector::new(y + z, x + z, x + y) * (body.mass / 12.0)
}
