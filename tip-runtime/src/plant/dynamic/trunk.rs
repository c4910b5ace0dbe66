//! The dynamics of the body: a floating box, or a frame that is bolted down.

use super::Vector;
use super::bump::bumps;
use super::contact::{Grip, Touch};
use super::frame::Frame;
use super::spatial::{Inertia, Spatial, placed};
use super::world::{GRAVITY, Share, World};
use crate::model::{Body, Range};
use crate::plant::cuboid::Cuboid;
use nalgebra::{Matrix3, Rotation3};

/// The body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trunk {
    /// `None` if it is bolted down.
    pub(super) model: Option<Body>,
    pub(super) frame: Frame,
    /// Bristles of the corners.
    grips: [Grip; 8],
    /// The load of each corner, N.
    pub(super) loads: [f64; 8],
    /// The load of blocks under sides and edges, N.
    pub(super) propped: f64,
    pub(super) push: Push,
}

/// A force on the body's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Push {
    /// The force in the world, N.
    pub(super) force: Vector,
    /// Number of remaining cycles.
    pub(super) cycles: u32,
}

impl Push {
    const NONE: Self = Push {
        force: Vector::new(0.0, 0.0, 0.0),
        cycles: 0,
    };

    /// Counts a cycle.
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
            propped: 0.0,
            push: Push::NONE,
        }
    }

    pub(super) fn mass(&self) -> f64 {
        self.model.map_or(0.0, |body| body.mass)
    }

    /// Returns the extent in the body's frame.
    pub(super) fn extent(&self) -> Option<Cuboid> {
        self.model.map(|body| Cuboid::of_body(&body, 1000.0))
    }

    /// Returns the corners in the body's frame, those of the belly first, m.
    pub(super) fn corners(&self) -> [Vector; 8] {
        let extent = self.extent();
        extent.map_or([Vector::zeros(); 8], |extent| extent.corners())
    }

    /// Updates contacts and forces; returns the body's inertia and the forces on it.
    pub(super) fn place(&mut self, world: &World<'_>) -> Share {
        let Some(body) = self.model else {
            return Share::NONE;
        };
        let Frame { rotation, rate, .. } = self.frame;
        let weight = Vector::new(0.0, 0.0, GRAVITY * body.mass);
        let (centre, own, mut force) = match &body.spread {
            None => {
                let own =
                    rotation * Matrix3::from_diagonal(&box_inertia(&body)) * rotation.inverse();
                let force = Spatial {
                    angular: rate.cross(&(own * rate)),
                    linear: weight,
                };
                (Vector::zeros(), own, force)
            }
            Some(spread) => {
                let (centre, own) = placed(spread, rotation);
                let pull = weight + rate.cross(&rate.cross(&centre)) * body.mass;
                let force = Spatial {
                    angular: rate.cross(&(own * rate)) + centre.cross(&pull),
                    linear: pull,
                };
                (centre, own, force)
            }
        };
        force.linear -= self.push.force;
        let extent = self.extent();
        let corners = self.corners().map(|corner| rotation * corner);
        let before = self.grips;
        let mut push = |grip: &mut Grip, arm: Vector, touch: Option<Touch>| {
            let velocity = self.frame.velocity + rate.cross(&arm);
            let push = grip.force(touch, velocity, world.law, world.stride.dt);
            force = force - Spatial::pushing(push, arm);
            touch.map_or(0.0, |touch| touch.load(push))
        };
        let mut spare = [const { None }; 8];
        let contacts = self.grips.iter_mut().zip(&mut self.loads).zip(before);
        for ((((grip, load), before), arm), spare) in contacts.zip(corners).zip(&mut spare) {
            let touch =
                (world.terrain).and_then(|terrain| terrain.touch(self.frame.position + arm));
            *load = push(grip, arm, touch);
            *spare = touch.is_none().then_some((grip, before));
        }
        // Bristles of corners that touch nothing serve where the body meets blocks between its corners.
        let mut spare = spare.into_iter().flatten();
        self.propped = 0.0;
        if let Some((extent, terrain)) = extent.zip(world.terrain) {
            bumps(&extent, &self.frame, terrain, |arm, touch| {
                let mut bare = Grip::FREE;
                let grip = match spare.next() {
                    Some((grip, before)) => {
                        *grip = before;
                        grip
                    }
                    None => &mut bare,
                };
                self.propped += push(grip, arm, Some(touch));
            });
        }
        Share {
            inertia: Inertia::new(body.mass, centre, own),
            force,
        }
    }

    /// Integrates an acceleration over `dt` s, unless the body is bolted down.
    pub(super) fn advance(&mut self, acceleration: [f64; 6], dt: f64) {
        if self.model.is_some() {
            self.frame.advance(acceleration, dt);
        }
    }
}

/// Returns the inertia of a uniform box about its middle, which is taken as the centre of mass,
/// kg·m².
fn box_inertia(body: &Body) -> Vector {
    let square = |range: Range| {
        let length = (range.max - range.min) / 1000.0;
        length * length
    };
    let (x, y, z) = (square(body.x), square(body.y), square(body.z));
    Vector::new(y + z, x + z, x + y) * (body.mass / 12.0)
}
