//! The distances between the parts of a robot of any size, for hosts.

use super::self_collision::{Gap, SelfCollision};
use crate::model::Model;
use core::fmt;
use std::sync::Arc;
use std::vec::Vec;

/// A function from the angles of all joints (deg), leg by leg, to the least distance of two parts of a robot.
type Measure = dyn Fn(&[f64]) -> Option<Gap> + Send + Sync;

/// The distances between the parts of a robot, whatever its size. Copies share it.
#[derive(Clone)]
pub struct Distances {
    measure: Arc<Measure>,
    left_out: Arc<[Gap]>,
}

impl Distances {
    /// Returns the distances of a robot.
    pub fn new<const L: usize, const J: usize>(model: &Model<L, J>) -> Self {
        let bodies = SelfCollision::new(model);
        let mut left_out = Vec::new();
        SelfCollision::left_out(model, &mut |gap| left_out.push(gap));
        Distances {
            measure: Arc::new(move |angles| bodies.clearance_of_row(angles)),
            left_out: left_out.into(),
        }
    }

    /// Returns the least distance of two parts at the angles of all joints, deg, leg by leg; `None` if no pair is compared.
    pub fn at(&self, angles: &[f64]) -> Option<Gap> {
        (self.measure)(angles)
    }

    /// Returns the parts that overlap at these angles, if there are any.
    pub fn overlap(&self, angles: &[f64]) -> Option<Gap> {
        self.at(angles).filter(|gap| gap.distance < 0.0)
    }

    /// Returns the pairs that are not compared because they overlap in the initial posture, with their distances there.
    pub fn left_out(&self) -> &[Gap] {
        &self.left_out
    }
}

impl fmt::Debug for Distances {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Distances").finish_non_exhaustive()
    }
}
