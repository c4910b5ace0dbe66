//! Motions, forces and inertias in space, all about one point: the origin of the body's frame as it is now, along the
//! axes of the world (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 2). In m, kg, s, rad and N.

use super::Vector;
use crate::model::Spread;
use core::ops::{Add, AddAssign, Sub};
use nalgebra::{Matrix3, Rotation3};

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
    #[inline]
    pub(super) fn turning(axis: Vector, place: Vector) -> Self {
        Spatial {
            angular: axis,
            linear: place.cross(&axis),
        }
    }

    /// A force that acts at `place`.
    #[inline]
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
    #[inline]
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

    /// kg.
    pub(super) const fn mass(&self) -> f64 {
        self.mass
    }

    /// The centre of mass: m.
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

/// Where a mass is whose frame is turned so (m), and its inertia about there (kg·m²).
#[inline]
pub(super) fn placed(spread: &Spread, turned: Rotation3<f64>) -> (Vector, Matrix3<f64>) {
    (
        turned * (Vector::from(spread.centre) / 1000.0),
        turned * tensor(spread) * turned.inverse(),
    )
}

/// The inertia about its centre in its own frame: kg·m².
#[inline]
pub(super) fn tensor(spread: &Spread) -> Matrix3<f64> {
    let [xx, yy, zz, xy, xz, yz] = spread.inertia;
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
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
