//! The dynamics of the body: a floating box, or a frame that is bolted down. Its corners touch the floor, its edges
//! blocks where neither has a corner inside.

use super::Vector;
use super::contact::{Bristle, Penetration};
use super::spatial::{Contribution, Inertia, MovingFrame, Spatial, placed};
use super::terrain::{StepContext, Terrain};
use crate::model::{Body, Range};
use crate::plant::GRAVITY;
use crate::plant::cuboid::{Cuboid, middle};
use nalgebra::{Matrix3, Rotation3};

/// The body.
#[derive(Clone, Copy, Debug)]
pub(super) struct BodyDynamics {
    /// `None` if it is bolted down.
    pub(super) model: Option<Body>,
    pub(super) frame: MovingFrame,
    /// Bristles of the corners.
    bristles: [Bristle; 8],
    /// The load of each corner, N.
    pub(super) loads: [f64; 8],
    /// The load of blocks under sides and edges, N.
    pub(super) edge_load: f64,
    pub(super) push: ExternalForce,
}

/// A force on the body's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ExternalForce {
    /// The force in the world, N.
    pub(super) force: Vector,
    /// Number of remaining cycles.
    pub(super) cycles: u32,
}

impl ExternalForce {
    const NONE: Self = ExternalForce {
        force: Vector::new(0.0, 0.0, 0.0),
        cycles: 0,
    };

    /// Counts a cycle.
    pub(super) const fn count_cycle(&mut self) {
        match self.cycles.checked_sub(1) {
            Some(left @ 1..) => self.cycles = left,
            _ => *self = ExternalForce::NONE,
        }
    }
}

impl BodyDynamics {
    pub(super) fn new(model: Option<Body>) -> Self {
        BodyDynamics {
            model,
            frame: MovingFrame {
                position: Vector::zeros(),
                rotation: Rotation3::identity(),
                velocity: Vector::zeros(),
                rate: Vector::zeros(),
            },
            bristles: [Bristle::FREE; 8],
            loads: [0.0; 8],
            edge_load: 0.0,
            push: ExternalForce::NONE,
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
    pub(super) fn place(&mut self, context: &StepContext<'_>) -> Contribution {
        let Some(body) = self.model else {
            return Contribution::NONE;
        };
        let MovingFrame { rotation, rate, .. } = self.frame;
        let weight = Vector::new(0.0, 0.0, GRAVITY * body.mass);
        let (centre, own, mut force) = match &body.inertial {
            None => {
                let own =
                    rotation * Matrix3::from_diagonal(&box_inertia(&body)) * rotation.inverse();
                let force = Spatial {
                    angular: rate.cross(&(own * rate)),
                    linear: weight,
                };
                (Vector::zeros(), own, force)
            }
            Some(inertial) => {
                let (centre, own) = placed(inertial, rotation);
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
        let before = self.bristles;
        let mut push = |bristle: &mut Bristle, arm: Vector, touch: Option<Penetration>| {
            let velocity = self.frame.velocity + rate.cross(&arm);
            let push = bristle.force(touch, velocity, context.law, context.step.dt);
            force = force - Spatial::pushing(push, arm);
            touch.map_or(0.0, |touch| touch.load(push))
        };
        let mut spare = [const { None }; 8];
        let contacts = self.bristles.iter_mut().zip(&mut self.loads).zip(before);
        for ((((bristle, load), before), arm), spare) in contacts.zip(corners).zip(&mut spare) {
            let touch =
                (context.terrain).and_then(|terrain| terrain.touch(self.frame.position + arm));
            *load = push(bristle, arm, touch);
            *spare = touch.is_none().then_some((bristle, before));
        }
        // Bristles of corners that touch nothing serve where the body meets blocks between its corners.
        let mut spare = spare.into_iter().flatten();
        self.edge_load = 0.0;
        if let Some((extent, terrain)) = extent.zip(context.terrain) {
            for_each_edge_contact(&extent, &self.frame, terrain, |arm, touch| {
                let mut bare = Bristle::FREE;
                let bristle = match spare.next() {
                    Some((bristle, before)) => {
                        *bristle = before;
                        bristle
                    }
                    None => &mut bare,
                };
                self.edge_load += push(bristle, arm, Some(touch));
            });
        }
        Contribution {
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

/// Height of the first lift of a body over a block that is wholly under it, m.
const CLIMB: f64 = 1e4;

/// Calls `meet` for each place where an edge of the body passes through a block, or an edge of a
/// block through the body: the midpoint of the part inside, from the body's origin (m). Corners of
/// the body are handled elsewhere.
fn for_each_edge_contact(
    extent: &Cuboid,
    frame: &MovingFrame,
    terrain: &Terrain,
    mut meet: impl FnMut(Vector, Penetration),
) {
    let corners = extent.corners();
    let reach = corners.iter().map(Vector::norm).fold(0.0, f64::max);
    let near = Vector::repeat(reach);
    for block in terrain.blocks() {
        let around = Cuboid {
            low: block.low - near,
            high: block.high + near,
        };
        if around.depth(frame.position).is_none() {
            continue;
        }
        for edge in extent.edges() {
            let edge = edge.map(|corner| frame.point(corner));
            let place = block.through(edge).map(|part| middle(edge, part));
            if let Some((place, (depth, side))) =
                place.and_then(|place| Some((place, block.depth(place)?)))
            {
                meet(place - frame.position, terrain.touching(depth, side));
            }
        }
        let inverse = frame.rotation.inverse();
        for edge in block.edges() {
            let edge = edge.map(|corner| inverse * (corner - frame.position));
            let place = extent.inside(edge).map(|part| middle(edge, part));
            if let Some((place, (depth, side))) =
                place.and_then(|place| Some((place, extent.depth(place)?)))
            {
                let touch = terrain.touching(depth, frame.rotation * -side);
                meet(frame.rotation * place, touch);
            }
        }
    }
}

/// Returns the rise of the body that clears the top of every block, m.
pub(super) fn rise_over_blocks(extent: &Cuboid, frame: &MovingFrame, terrain: &Terrain) -> f64 {
    let edges = extent.edges();
    let edges = edges.map(|edge| terrain.rise(edge.map(|corner| frame.point(corner))));
    let rise = edges.into_iter().fold(0.0, f64::max);
    let inverse = frame.rotation.inverse();
    let tops = terrain.blocks().flat_map(|block| {
        let [_, _, _, _, tops @ ..] = block.corners();
        tops
    });
    // A segment from deep below a top straight up to it, cut where it enters the body.
    let ups = tops.filter_map(|top| {
        let below = Vector::new(top.x, top.y, top.z - CLIMB);
        let [from, _] = extent.inside([below, top].map(|end| inverse * (end - frame.position)))?;
        Some(CLIMB * (1.0 - from))
    });
    ups.fold(rise, f64::max)
}
