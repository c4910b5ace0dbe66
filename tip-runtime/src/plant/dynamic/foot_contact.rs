//! The contact of a foot with the ground.

use super::Vector;

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
