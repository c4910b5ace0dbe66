//! The body on its contacts with the floor.

use super::Vector;
use super::events::{CycleEvents, UnmodelledCounter};
use super::fall::{Polygon, SupportMonitor};
use super::links::Mass;
use super::pose::{FloorPose, Obstacles, Odometer};
use super::stance::Stance;
use super::support::{self, Contacts, Descent, Load, Support};
use crate::model;
use crate::plant::GRAVITY;
use crate::plant::cuboid::Cuboid;
use crate::scene::{Floor, Scene};

/// The interface between legs and ground, independent of the number of legs.
pub(super) trait GroundInterface {
    /// Returns the load of every foot, N.
    fn loads(&self) -> &[f64];
    /// Returns the direction of gravity in the robot's frame.
    fn down(&self) -> Vector;
    /// Returns true if nothing moves while the legs do not.
    fn is_at_rest(&self) -> bool;
    /// Returns the mass of the body without legs (kg), and that times its centre in the robot's
    /// frame (kg·mm).
    fn body_mass(&self) -> (f64, Vector);
    /// Returns the positions of the feet in the robot's frame, to be written before
    /// [`settle`](Self::settle).
    fn feet(&mut self) -> &mut [Vector];
    /// Moves the body towards its rest on its contacts for `dt` s, and keeps stance feet in place.
    fn settle(&mut self, mass: Mass, dt: f64);
    /// Returns true if the body is on its way down, without hold.
    fn has_lost_hold(&self) -> bool;
    /// Judges the last `dt` s for unmodelled effects.
    fn judge(&mut self, dt: f64);
    /// Returns the height of a point of the robot's frame above the floor, mm; infinite for a robot
    /// that is bolted down.
    fn height(&self, point: Vector) -> f64;
    /// Returns true if there are blocks.
    fn has_blocks(&self) -> bool;
    /// Returns true if a segment of the robot's frame is in a block.
    fn is_segment_in_block(&self, segment: [Vector; 2]) -> bool;
    /// Returns true if the body is in a block.
    fn is_in_block(&self) -> bool;
    /// Ends a cycle with these events of the legs.
    fn close(&mut self, events: &CycleEvents);
}

/// The body of a robot of `L` legs, and the floor under it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground<const L: usize> {
    pub(super) floor: Floor,
    pub(super) obstacles: Obstacles,
    /// The direction of gravity in the floor's frame.
    gravity: Vector,
    /// The direction of gravity in the robot's frame.
    down: Vector,
    /// The body of the model, if there is one.
    model: Option<model::Body>,
    pub(super) mass: Mass,
    pub(super) body: FloorPose,
    pub(super) start: Odometer,
    at_rest: bool,
    feet: [Vector; L],
    pub(super) loads: Contacts<f64, L>,
    pub(super) stance: Stance<L>,
    pub(super) falls: SupportMonitor,
    pub(super) unmodelled: UnmodelledCounter,
    descent: Descent,
    /// Number of cycles so far.
    pub(super) cycle: u64,
}

impl<const L: usize> Ground<L> {
    /// Returns a level floor under a body that has not settled yet.
    // Out of line, or it would be copied for each number of joints.
    #[inline(never)]
    pub(super) fn new(model: Option<model::Body>) -> Self {
        let body = FloorPose::standing(model.as_ref());
        Ground {
            floor: Floor::LEVEL,
            obstacles: Obstacles(Scene::EMPTY.blocks),
            gravity: Floor::LEVEL.gravity(),
            down: Vector::zeros(),
            model,
            mass: Mass::NONE,
            body,
            start: Odometer::at(&Floor::LEVEL, &body),
            at_rest: false,
            feet: [Vector::zeros(); L],
            loads: Contacts::new([0.0; L], [0.0; 4]),
            stance: Stance::new(),
            falls: SupportMonitor::new(),
            unmodelled: UnmodelledCounter::new(Scene::EMPTY.friction),
            descent: Descent::NONE,
            cycle: 0,
        }
    }

    /// Replaces the floor and places the body again.
    pub(super) fn replace(&mut self, floor: Floor) {
        self.floor = floor;
        self.gravity = floor.gravity();
        self.body = FloorPose::standing(self.model.as_ref());
        self.stance = Stance::new();
        self.descent = Descent::NONE;
    }

    /// Returns true if there is a body that moves.
    pub(super) const fn is_loose(&self) -> bool {
        self.model.is_some()
    }

    /// Restarts all measurements.
    pub(super) fn begin(&mut self) {
        self.start = Odometer::at(&self.floor, &self.body);
        self.falls.least = self.falls.margin;
        self.unmodelled.begin();
        self.judge(0.0);
    }

    /// Returns the points that can touch the floor, if there is a body.
    fn points(&self) -> Option<Contacts<Vector, L>> {
        let body = self.model.as_ref()?;
        Some(Contacts::of(body, self.feet))
    }
}

impl<const L: usize> GroundInterface for Ground<L> {
    fn loads(&self) -> &[f64] {
        &self.loads.feet
    }

    fn down(&self) -> Vector {
        self.down
    }

    fn is_at_rest(&self) -> bool {
        self.at_rest
    }

    fn body_mass(&self) -> (f64, Vector) {
        let Some(body) = self.model else {
            return (0.0, Vector::zeros());
        };
        let centre = body.inertial.map(|inertial| Vector::from(inertial.centre));
        let moment = centre.map_or(Vector::zeros(), |centre| centre * body.mass);
        (body.mass, moment)
    }

    fn feet(&mut self) -> &mut [Vector] {
        &mut self.feet
    }

    fn settle(&mut self, mass: Mass, dt: f64) {
        self.mass = mass;
        let Some(points) = self.points() else {
            self.at_rest = true;
            self.down = self.body.rotation().inverse() * self.gravity;
            return;
        };
        let load = Load {
            centre: mass.centre,
            weight: mass.weight,
            gravity: self.gravity,
        };
        let rest = support::rest(&points, &load, &self.body);
        let Support {
            normal,
            height,
            found,
        } = self
            .descent
            .towards(rest, &points, mass.weight, &self.body, dt);
        self.at_rest = found;
        (self.body.normal, self.body.height) = (normal, height);
        self.loads = support::loads(&points, normal, height);
        let heading = self.body.heading;
        let pull = self.unmodelled.friction * GRAVITY * 1000.0;
        let pull = self.descent.is_free.then_some(pull);
        let rotation = (self.stance).follow(&points, &self.loads, &mut self.body, (pull, dt));
        self.start.turned(heading, self.body.heading);
        self.down = rotation.inverse() * self.gravity;
        let polygon = Polygon::new(&points, &self.loads, self.falls.lift);
        self.falls
            .update(&polygon, mass.centre, (self.down, normal), self.cycle);
    }

    fn judge(&mut self, dt: f64) {
        let Some(points) = self.points() else {
            return;
        };
        let rotation = self.body.rotation();
        self.unmodelled.moved(self.body.point(self.mass.centre), dt);
        let polygon = Polygon::new(&points, &self.loads, self.falls.lift);
        let is_carried = self.loads.iter().any(|load| *load > 0.0);
        self.unmodelled.judge(
            &polygon,
            self.mass.centre,
            (self.gravity, is_carried),
            |pull| rotation.inverse() * pull,
            self.falls.margin,
        );
    }

    fn has_lost_hold(&self) -> bool {
        self.descent.is_free
    }

    fn height(&self, point: Vector) -> f64 {
        if self.is_loose() {
            self.body.normal.dot(&point) + self.body.height
        } else {
            f64::INFINITY
        }
    }

    fn has_blocks(&self) -> bool {
        self.is_loose() && !self.obstacles.is_empty()
    }

    fn is_segment_in_block(&self, segment: [Vector; 2]) -> bool {
        let ends = segment.map(|end| self.floor.outer(&self.body, end));
        self.obstacles.hits_segment(ends)
    }

    fn is_in_block(&self) -> bool {
        self.model.is_some_and(|body| {
            self.obstacles.hits_body(
                &Cuboid::of_body(&body, 1.0),
                |point| self.floor.inner(&self.body, point),
                |point| self.floor.outer(&self.body, point),
            )
        })
    }

    fn close(&mut self, events: &CycleEvents) {
        self.unmodelled.close(events);
    }
}
