//! Spatial motions, forces and inertias, all about one point: the current origin of the body's
//! frame, along the axes of the world (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch.
//! 2). In m, kg, s, rad and N.
//!
//! The systems of equations that follow are symmetric and positive definite: Cholesky's method, without a panic path.

use super::Vector;
use crate::model::InertialProperties;
use core::ops::{Add, AddAssign, Sub};
use nalgebra::{Matrix3, Rotation3};

/// Six numbers. Of a motion: angular velocity (rad/s) and velocity at the origin (m/s); of a force:
/// moment about the origin (N·m) and force (N); of a momentum likewise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spatial {
    pub(super) angular: Vector,
    pub(super) linear: Vector,
}

impl Spatial {
    pub(super) const ZERO: Self = Spatial {
        angular: Vector::new(0.0, 0.0, 0.0),
        linear: Vector::new(0.0, 0.0, 0.0),
    };

    /// Returns the rotation at 1 rad/s about an axis through `place`.
    #[inline]
    pub(super) fn turning(axis: Vector, place: Vector) -> Self {
        Spatial {
            angular: axis,
            linear: place.cross(&axis),
        }
    }

    /// Returns a force that acts at `place`.
    #[inline]
    pub(super) fn pushing(force: Vector, place: Vector) -> Self {
        Spatial {
            angular: place.cross(&force),
            linear: force,
        }
    }

    /// Returns the power of a force in a motion.
    #[inline]
    pub(super) fn dot(&self, other: &Self) -> f64 {
        self.angular.dot(&other.angular) + self.linear.dot(&other.linear)
    }

    #[inline]
    pub(super) fn entries(&self) -> [f64; 6] {
        let (a, l) = (&self.angular, &self.linear);
        [a.x, a.y, a.z, l.x, l.y, l.z]
    }

    #[inline]
    pub(super) fn of([ax, ay, az, lx, ly, lz]: [f64; 6]) -> Self {
        Spatial {
            angular: Vector::new(ax, ay, az),
            linear: Vector::new(lx, ly, lz),
        }
    }
}

impl Add for Spatial {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Spatial {
            angular: self.angular + other.angular,
            linear: self.linear + other.linear,
        }
    }
}

impl AddAssign for Spatial {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Spatial {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Spatial {
            angular: self.angular - other.angular,
            linear: self.linear - other.linear,
        }
    }
}

/// The inertia of rigid bodies that move as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Inertia {
    /// Mass, kg.
    mass: f64,
    /// Mass times its centre, kg·m.
    moment: Vector,
    /// Inertia about the origin, kg·m².
    turning: Matrix3<f64>,
}

impl Inertia {
    pub(super) const NONE: Self = Inertia {
        mass: 0.0,
        moment: Vector::new(0.0, 0.0, 0.0),
        turning: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    };

    /// Returns the inertia of a mass (kg) with a centre (m) and a central inertia (kg·m²).
    #[inline]
    pub(super) fn new(mass: f64, centre: Vector, own: Matrix3<f64>) -> Self {
        Inertia {
            mass,
            moment: centre * mass,
            turning: own + point_mass(centre) * mass,
        }
    }

    /// Returns the momentum in a motion.
    #[inline]
    pub(super) fn momentum(&self, motion: &Spatial) -> Spatial {
        Spatial {
            angular: self.turning * motion.angular + self.moment.cross(&motion.linear),
            linear: motion.linear * self.mass + motion.angular.cross(&self.moment),
        }
    }

    /// Returns the matrix of the inertia, angular rows and columns first.
    #[inline]
    pub(super) fn matrix(&self) -> [[f64; 6]; 6] {
        let Inertia {
            mass,
            moment: m,
            turning: t,
        } = self;
        [
            [t.m11, t.m21, t.m31, 0.0, -m.z, m.y],
            [t.m12, t.m22, t.m32, m.z, 0.0, -m.x],
            [t.m13, t.m23, t.m33, -m.y, m.x, 0.0],
            [0.0, m.z, -m.y, *mass, 0.0, 0.0],
            [-m.z, 0.0, m.x, 0.0, *mass, 0.0],
            [m.y, -m.x, 0.0, 0.0, 0.0, *mass],
        ]
    }

    /// Returns the mass, kg.
    pub(super) const fn mass(&self) -> f64 {
        self.mass
    }

    /// Returns the centre of mass, m.
    #[inline]
    pub(super) fn centre(&self) -> Vector {
        if self.mass > 0.0 {
            self.moment / self.mass
        } else {
            self.moment
        }
    }
}

impl AddAssign for Inertia {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.mass += other.mass;
        self.moment += other.moment;
        self.turning += other.turning;
    }
}

/// Returns the centre (m) of a mass in a rotated frame, and its inertia about it (kg·m²).
#[inline]
pub(super) fn placed(
    inertial: &InertialProperties,
    turned: Rotation3<f64>,
) -> (Vector, Matrix3<f64>) {
    (
        turned * (Vector::from(inertial.centre) / 1000.0),
        turned * tensor(inertial) * turned.inverse(),
    )
}

/// Returns the inertia about the centre in its own frame, kg·m².
#[inline]
pub(super) fn tensor(inertial: &InertialProperties) -> Matrix3<f64> {
    let [xx, yy, zz, xy, xz, yz] = inertial.inertia;
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

/// Returns the inertia of 1 kg at `place` about the origin.
#[inline]
pub(super) fn point_mass(place: Vector) -> Matrix3<f64> {
    let (x, y, z) = (place.x, place.y, place.z);
    Matrix3::new(
        y * y + z * z,
        -x * y,
        -x * z,
        -x * y,
        x * x + z * z,
        -y * z,
        -x * z,
        -y * z,
        x * x + y * y,
    )
}

/// The contribution of a leg or the body to the robot: its inertia, and the force that sustains its
/// motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contribution {
    pub(super) inertia: Inertia,
    pub(super) force: Spatial,
}

impl Contribution {
    pub(super) const NONE: Self = Contribution {
        inertia: Inertia::NONE,
        force: Spatial::ZERO,
    };

    #[inline]
    pub(super) fn add(&mut self, other: Contribution) {
        self.inertia += other.inertia;
        self.force += other.force;
    }
}

/// The position, rotation and velocity of the body in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MovingFrame {
    /// Position, m.
    pub(super) position: Vector,
    pub(super) rotation: Rotation3<f64>,
    /// Velocity of the origin, m/s.
    pub(super) velocity: Vector,
    /// Angular velocity along the axes of the world, rad/s.
    pub(super) rate: Vector,
}

impl MovingFrame {
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

/// The lower triangle of a matrix's Cholesky factor, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CholeskyFactor<const N: usize>([[f64; N]; N]);

impl<const N: usize> CholeskyFactor<N> {
    /// Factorises a matrix, of which only the lower triangle is read; `None` if it is not positive
    /// definite.
    pub(super) fn of(mut rows: [[f64; N]; N]) -> Option<Self> {
        for i in 0..N {
            let (done, rest) = rows.split_at_mut_checked(i)?;
            let row = rest.first_mut()?;
            for (k, other) in done.iter().enumerate() {
                let known = dot(row, other, k);
                let entry = row.get_mut(k)?;
                *entry = (*entry - known) / other.get(k)?;
            }
            let known = dot(row, row, i);
            let own = row.get_mut(i)?;
            let square = *own - known;
            if square.is_nan() || square <= 0.0 {
                return None;
            }
            *own = libm::sqrt(square);
        }
        Some(CholeskyFactor(rows))
    }

    /// Solves the lower triangular system: the forward substitution of `right`.
    pub(super) fn forward_substitute(&self, mut right: [f64; N]) -> [f64; N] {
        for (i, row) in self.0.iter().enumerate() {
            let known = dot(row, &right, i);
            if let (Some(own), Some(pivot)) = (right.get_mut(i), row.get(i)) {
                *own = (*own - known) / pivot;
            }
        }
        right
    }

    /// Solves the whole system.
    pub(super) fn solve(&self, right: [f64; N]) -> [f64; N] {
        let mut half = self.forward_substitute(right);
        for (i, row) in self.0.iter().enumerate().rev() {
            let below = self.0.iter().zip(&half).skip(i + 1);
            let known: f64 = below
                .map(|(row, solved)| row.get(i).map_or(0.0, |entry| entry * solved))
                .sum();
            if let (Some(own), Some(pivot)) = (half.get_mut(i), row.get(i)) {
                *own = (*own - known) / pivot;
            }
        }
        half
    }
}

/// Returns the dot product of the first `count` entries.
pub(super) fn dot<const N: usize>(one: &[f64; N], other: &[f64; N], count: usize) -> f64 {
    let both = one.iter().zip(other).take(count);
    both.map(|(one, other)| one * other).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_solves() {
        let matrix = [[4.0, 9.9, 9.9], [2.0, 5.0, 9.9], [-2.0, 1.0, 6.0]];
        let full = [[4.0, 2.0, -2.0], [2.0, 5.0, 1.0], [-2.0, 1.0, 6.0]];
        let factor = CholeskyFactor::of(matrix).expect("positive definite");
        let solved = factor.solve([1.0, -2.0, 3.0]);
        for (row, right) in full.iter().zip([1.0, -2.0, 3.0]) {
            assert!((dot(row, &solved, 3) - right).abs() < 1e-12);
        }
        assert_eq!(CholeskyFactor::of([[0.0]]), None);
        assert_eq!(CholeskyFactor::of([[1.0, 0.0], [2.0, 1.0]]), None);
    }
}
