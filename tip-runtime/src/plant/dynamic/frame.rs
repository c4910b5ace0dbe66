//! Where the body is, and how it moves.

use super::Vector;
use super::spatial::Spatial;
use nalgebra::{Matrix3, Rotation3};

/// Where the body is in the world, and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// m.
    pub(super) position: Vector,
    pub(super) rotation: Rotation3<f64>,
    /// m/s.
    pub(super) velocity: Vector,
    /// rad/s, along the axes of the world.
    pub(super) rate: Vector,
}

impl Frame {
    /// Moves for `dt` s while it accelerates: angular first.
    pub(super) fn advance(&mut self, acceleration: [f64; 6], dt: f64) {
        let Spatial { angular, linear } = Spatial::of(acceleration);
        self.rate += angular * dt;
        self.velocity += linear * dt;
        self.position += self.velocity * dt;
        self.rotation = orthogonal(Rotation3::from_scaled_axis(self.rate * dt) * self.rotation);
    }

    /// A point of the body, in the world: m.
    pub(super) fn point(&self, inner: Vector) -> Vector {
        self.position + self.rotation * inner
    }

    /// Turn and velocity.
    pub(super) const fn twist(&self) -> Spatial {
        Spatial {
            angular: self.rate,
            linear: self.velocity,
        }
    }
}

/// The rotation nearest to one that rounding has bent (one step of Newton's method for the polar decomposition).
fn orthogonal(bent: Rotation3<f64>) -> Rotation3<f64> {
    let matrix = bent.matrix();
    let square = matrix.transpose() * matrix;
    Rotation3::from_matrix_unchecked(matrix * (Matrix3::identity() * 3.0 - square) / 2.0)
}
