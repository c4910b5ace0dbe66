//! Contacts of a robot with mass: the law of a point in an obstacle, and the contact of a foot. Along the normal there
//! are a spring and a damper, across it a bristle that bends until it slides (Cundall and Strack, *Géotechnique* 29,
//! 1979).

use super::Vector;
use crate::plant::ContactLaw;

/// Stiffness for each kg of the robot, N/m. TITAN VIII has 400 N/mm.
const STIFFNESS: f64 = 2e4;
/// Damping for each kg of the robot, N·s/m.
const DAMPING: f64 = 20.0;
/// The share of the stability limit that stiffness and damping may reach.
const SHARE: f64 = 0.25;

impl ContactLaw {
    /// Returns the law for a robot of a mass (kg) whose lightest foot has the effective mass `foot`
    /// (kg), in steps of `dt` s at most.
    pub(super) fn of_robot(mass: f64, foot: f64, dt: f64) -> Self {
        ContactLaw {
            stiffness: (mass * STIFFNESS).min(SHARE * foot / (dt * dt)),
            damping: (mass * DAMPING).min(SHARE * foot / dt),
        }
    }
}

/// A point inside of an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Penetration {
    /// Penetration depth, m.
    pub(super) depth: f64,
    /// Outward normal, a unit vector.
    pub(super) normal: Vector,
    /// The coefficient of Coulomb friction.
    pub(super) friction: f64,
}

/// Least upward component of the normal of a contact that carries load; a wall carries none.
const CARRIES: f64 = 0.25;

impl Penetration {
    /// Returns the part of a force that is load, N.
    #[inline]
    pub(super) fn load(&self, force: Vector) -> f64 {
        if self.normal.z > CARRIES {
            force.dot(&self.normal)
        } else {
            0.0
        }
    }

    /// Returns the force (N) on a place that slides, without a stored bristle.
    #[inline]
    pub(super) fn rub(self, velocity: Vector, law: &ContactLaw, dt: f64) -> Vector {
        let mut bare = Bristle::FREE;
        bare.force(Some(self), velocity, law, dt)
    }
}

/// The deflection of a contact's bristle, in the world, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bristle(Vector);

impl Bristle {
    /// The bristle of a free point.
    pub(super) const FREE: Self = Bristle(Vector::new(0.0, 0.0, 0.0));

    /// Returns the force (N) on a point that moves at `velocity` (m/s) for `dt` s; zero without a
    /// touch.
    #[inline]
    pub(super) fn force(
        &mut self,
        touch: Option<Penetration>,
        velocity: Vector,
        law: &ContactLaw,
        dt: f64,
    ) -> Vector {
        let Some(Penetration {
            depth,
            normal,
            friction,
        }) = touch
        else {
            *self = Bristle::FREE;
            return Vector::zeros();
        };
        let away = velocity.dot(&normal);
        let push = law.push(depth, away);
        let across = velocity - normal * away;
        let most = friction * push;
        let bent = self.0 + across * dt;
        let bent = bent - normal * bent.dot(&normal);
        self.0 = within(bent, most / law.stiffness);
        normal * push - within(self.0 * law.stiffness + across * law.damping, most)
    }
}

/// Shortens a vector to `longest`.
#[inline]
fn within(vector: Vector, longest: f64) -> Vector {
    let length = vector.norm();
    if length > longest {
        vector * (longest / length)
    } else {
        vector
    }
}

/// Time off the ground below which a foot has bounced and not stepped, s. Feet that chatter as a
/// push drives the robot along are up for some 10 ms, feet that step for 100.
const BOUNCE: f64 = 20e-3;

/// The contact of a foot with the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FootContact {
    /// Position in the world, m.
    pub(super) place: Vector,
    /// Force along the ground's normal, N.
    pub(super) load: f64,
    /// Force of the ground, friction included, in the world, N.
    pub(super) force: Vector,
    /// Place of the touchdown in the world, m. It counts until the foot has been up for the time of
    /// a step.
    touchdown: Vector,
    /// Time without load, s.
    up: f64,
    /// Slip since the touchdown, m.
    pub(super) slip: f64,
}

impl FootContact {
    /// The contact of a foot that has not been placed yet.
    pub(super) const NONE: Self = FootContact {
        place: Vector::new(0.0, 0.0, 0.0),
        load: 0.0,
        force: Vector::new(0.0, 0.0, 0.0),
        touchdown: Vector::new(0.0, 0.0, 0.0),
        up: f64::INFINITY,
        slip: 0.0,
    };

    /// Updates the contact: the foot is at `place`, and ground with a normal has pushed it with
    /// `force` for `dt` s.
    #[inline]
    pub(super) fn at(&mut self, place: Vector, force: Vector, normal: Vector, dt: f64) {
        let load = force.dot(&normal);
        (self.place, self.force, self.load) = (place, force, load);
        if load > 0.0 {
            if self.up >= BOUNCE {
                self.touchdown = place;
            }
            self.slip = (place - self.touchdown).norm();
            self.up = 0.0;
            return;
        }
        self.up += dt;
        if self.up >= BOUNCE {
            self.slip = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: ContactLaw = ContactLaw {
        stiffness: 1e5,
        damping: 100.0,
    };

    /// Returns a touch inside a floor with friction 0.5.
    fn on_floor(depth: f64) -> Option<Penetration> {
        let normal = Vector::new(0.0, 0.6, 0.8);
        Some(Penetration {
            depth,
            normal,
            friction: 0.5,
        })
    }

    #[test]
    fn no_force_leaves_the_friction_cone_and_none_pulls() {
        let mut bristle = Bristle::FREE;
        for step in 0..10_000 {
            let time = f64::from(step) * 5e-4;
            let velocity = Vector::new(
                libm::sin(9.0 * time),
                libm::cos(7.0 * time),
                libm::sin(5.0 * time),
            );
            let depth = 1e-3 * libm::sin(3.0 * time);
            let touch = on_floor(depth).filter(|touch| touch.depth > 0.0);
            let force = bristle.force(touch, velocity, &LAW, 5e-4);
            let normal = Vector::new(0.0, 0.6, 0.8);
            let push = force.dot(&normal);
            let across = (force - normal * push).norm();
            assert!(push >= 0.0 && across <= 0.5 * push + 1e-9, "{force}");
        }
    }

    #[test]
    fn a_bristle_holds_until_friction_lets_go() {
        // A depth of 1 mm gives 100 N. Friction holds 50 N of them, which bend the bristle by 0.5 mm.
        let slow = Vector::new(0.01, 0.0, 0.0);
        let mut bristle = Bristle::FREE;
        let forces: [f64; 2] = [100, 1000].map(|steps| {
            let mut last = 0.0;
            for _ in 0..steps {
                last = bristle.force(on_floor(1e-3), slow, &LAW, 5e-4).x;
            }
            last
        });
        // 100 steps bend it by 0.5 mm; the damper's newton is beyond the cone.
        assert!((forces[0] + 50.0).abs() < 1e-6, "{forces:?}");
        assert!((forces[1] + 50.0).abs() < 1e-6, "{forces:?}");
        assert!((bristle.0.norm() - 0.5e-3).abs() < 1e-12);
        bristle.force(None, slow, &LAW, 5e-4);
        assert_eq!(bristle, Bristle::FREE);
    }

    #[test]
    fn a_foot_that_bounces_goes_on_slipping_and_one_that_steps_does_not() {
        let mut foot = FootContact::NONE;
        let at = |x| Vector::new(x, 0.0, 0.0);
        let up = |z| Vector::new(0.0, 0.0, z);
        foot.at(at(1.0), up(5.0), up(1.0), 1e-3);
        foot.at(at(1.5), up(0.0), up(1.0), 19e-3);
        foot.at(at(2.0), up(5.0), up(1.0), 1e-3);
        assert_eq!(foot.slip, 1.0);
        foot.at(at(2.5), up(0.0), up(1.0), 19e-3);
        foot.at(at(3.0), up(0.0), up(1.0), 1e-3);
        assert_eq!(foot.slip, 0.0);
        foot.at(at(4.0), up(5.0), up(1.0), 1e-3);
        foot.at(at(4.25), up(5.0), up(1.0), 1e-3);
        assert_eq!(foot.slip, 0.25);
    }
}
