//! The moving frame of the body.

use super::Vector;
use super::spatial::Spatial;
use nalgebra::{Matrix3, Rotation3};

/// The position, rotation and velocity of the body in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// Position, m.
    pub(super) position: Vector,
    pub(super) rotation: Rotation3<f64>,
    /// Velocity of the origin, m/s.
    pub(super) velocity: Vector,
    /// Angular velocity along the axes of the world, rad/s.
    pub(super) rate: Vector,
}

impl Frame {
    /// Integrates an acceleration (angular first) over `dt` s.
    pub(super) fn advance(&mut self, acceleration: [f64; 6], dt: f64) {
        let Spatial { angular, linear } = Spatial::of(acceleration);
        self.rate += angular * dt;
        self.velocity += linear * dt;
        self.position += self.velocity * dt;
        self.rotation = orthogonal(Rotation3::from_scaled_axis(self.rate * dt) * self.rotation);
    }

    /// Transforms a point of the body into the world, m.
    pub(super) fn point(&self, inner: Vector) -> Vector {
        self.position + self.rotation * inner
    }

    /// Returns angular and linear velocity.
    pub(super) const fn twist(&self) -> Spatial {
        Spatial {
            angular: self.rate,
            linear: self.velocity,
        }
    }
}

/// Returns the rotation nearest to a matrix with rounding errors (one step of Newton's method for
/// the polar decomposition).
fn orthogonal(bent: Rotation3<f64>) -> Rotation3<f64> {
    let matrix = bent.matrix();
    let square = matrix.transpose() * matrix;
    Rotation3::from_matrix_unchecked(matrix * (Matrix3::identity() * 3.0 - square) / 2.0)
}
