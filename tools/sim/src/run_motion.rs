//! Figures of a run on the motion of its robot.

use crate::motion::{Fall, Grasp, Limbs};
use crate::run::Run;
use tip_runtime::controller::Setpoint;
use tip_runtime::plant::{Motion, Pose, Travel};

impl Run {
    /// Returns the motion of the body; none for a robot that stays where it is, or that another
    /// process simulates.
    pub fn motion(&self) -> Option<Motion> {
        self.machine.hardware().motion()
    }

    /// Returns the pose of the body; none for a robot that stays where it is, or that another
    /// process simulates without giving it.
    pub fn pose(&self) -> Option<Pose> {
        self.machine.hardware().pose()
    }

    /// Returns the distance that the body has come; none for a robot that stays where it is, or
    /// that another process simulates without giving the pose.
    pub fn travel(&self) -> Option<Travel> {
        self.machine.hardware().travel()
    }

    /// Returns time and place of the robot's first fall, if it fell.
    pub fn first_fall(&self) -> Option<Fall> {
        self.fall
    }

    /// Returns the legs or fingers as they are after the last cycle; none if nothing but joints is
    /// simulated.
    pub fn limbs(&self) -> Option<Limbs> {
        self.machine.hardware().limbs()
    }

    /// Returns the aims of every leg or finger, foot by foot or joint by joint.
    pub fn setpoints(&self) -> Vec<Setpoint> {
        self.machine.setpoints()
    }

    /// Returns the robot's grasp; none if it is not a hand.
    pub fn grasp(&self) -> Option<Grasp> {
        self.machine.hardware().grasp()
    }

    /// Keeps the first fall, if it was in this cycle.
    pub(crate) fn note_fall(&mut self, cycle: u64, time: f64, step: u32) {
        if self.fall.is_none() {
            self.fall = self.machine.hardware().first_fall().map(|fall| Fall {
                cycle,
                time,
                step,
                margin: fall.margin,
                is_upright: fall.is_upright,
            });
        }
    }
}
