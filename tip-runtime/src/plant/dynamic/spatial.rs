//! Motions, forces and inertias in space, all about one point: the origin of the body's frame as it is now, along the
//! axes of the world (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 2). In m, kg, s, rad and N.

use super::Vector;
use core::ops::{Add, AddAssign, Sub};
use nalgebra::Matrix3;

/// Six numbers: of a motion turn (rad/s) and velocity at the origin (m/s), of a force moment about the origin (N·m) and
/// force (N), of a momentum likewise.
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

    /// The turn at 1 rad/s about an axis through `place`.
    pub(super) fn turning(axis: Vector, place: Vector) -> Self {
        Spatial {
            angular: axis,
            linear: place.cross(&axis),
        }
    }

    /// A force that acts at `place`.
    pub(super) fn pushing(force: Vector, place: Vector) -> Self {
        Spatial {
            angular: place.cross(&force),
            linear: force,
        }
    }

    /// The power of a force in a motion.
    #[inline]
    pub(super) fn dot(&self, other: &Self) -> f64 {
        self.angular.dot(&other.angular) + self.linear.dot(&other.linear)
    }

    pub(super) fn entries(&self) -> [f64; 6] {
        let (a, l) = (&self.angular, &self.linear);
        [a.x, a.y, a.z, l.x, l.y, l.z]
    }

    pub(super) fn of([ax, ay, az, lx, ly, lz]: [f64; 6]) -> Self {
        Spatial {
            angular: Vector::new(ax, ay, az),
            linear: Vector::new(lx, ly, lz),
        }
    }
}

impl Add for Spatial {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Spatial {
            angular: self.angular + other.angular,
            linear: self.linear + other.linear,
        }
    }
}

impl AddAssign for Spatial {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Spatial {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Spatial {
            angular: self.angular - other.angular,
            linear: self.linear - other.linear,
        }
    }
}

/// What rigid bodies that move as one are heavy by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Inertia {
    /// kg.
    mass: f64,
    /// Mass times its centre: kg·m.
    moment: Vector,
    /// About the origin: kg·m².
    turning: Matrix3<f64>,
}

impl Inertia {
    pub(super) const NONE: Self = Inertia {
        mass: 0.0,
        moment: Vector::new(0.0, 0.0, 0.0),
        turning: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    };

    /// Of a mass (kg) with a centre (m) and an inertia of its own about it (kg·m²).
    pub(super) fn new(mass: f64, centre: Vector, own: Matrix3<f64>) -> Self {
        Inertia {
            mass,
            moment: centre * mass,
            turning: own + spread(centre) * mass,
        }
    }

    /// The momentum in a motion.
    #[inline]
    pub(super) fn momentum(&self, motion: &Spatial) -> Spatial {
        Spatial {
            angular: self.turning * motion.angular + self.moment.cross(&motion.linear),
            linear: motion.linear * self.mass + motion.angular.cross(&self.moment),
        }
    }

    /// The same for any motion: angular rows and columns first.
    pub(super) fn matrix(&self) -> [[f64; 6]; 6] {
        let [x, y, z] = [Vector::x(), Vector::y(), Vector::z()];
        let none = Vector::zeros();
        [
            (x, none),
            (y, none),
            (z, none),
            (none, x),
            (none, y),
            (none, z),
        ]
        .map(|(angular, linear)| self.momentum(&Spatial { angular, linear }).entries())
    }

    /// kg.
    pub(super) const fn mass(&self) -> f64 {
        self.mass
    }

    /// The centre of mass: m.
    pub(super) fn centre(&self) -> Vector {
        if self.mass > 0.0 {
            self.moment / self.mass
        } else {
            self.moment
        }
    }
}

impl AddAssign for Inertia {
    fn add_assign(&mut self, other: Self) {
        self.mass += other.mass;
        self.moment += other.moment;
        self.turning += other.turning;
    }
}

/// The inertia of 1 kg at `place` about the origin.
#[inline]
pub(super) fn spread(place: Vector) -> Matrix3<f64> {
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
