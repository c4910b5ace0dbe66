//! A joint's servo without inertia: its motor and its position loop.

use crate::hardware::JointCommand;
use crate::model::Joint;
use crate::plant::STOP;

/// The dynamics of all joints' position loops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ServoDynamics {
    /// Time constant of the position loop: ms.
    pub lag: f64,
    /// The greatest speed of a joint, deg/s.
    pub speed: f64,
}

impl Default for ServoDynamics {
    /// Returns 15 ms and 360 deg/s.
    fn default() -> Self {
        ServoDynamics {
            lag: 15.0,
            speed: 360.0,
        }
    }
}

impl ServoDynamics {
    /// Returns the share of the distance to its command that a joint turns in `dt` s.
    pub(in crate::plant) fn share(&self, dt: f64) -> f64 {
        1.0 - libm::exp(-1000.0 * dt / self.lag)
    }

    /// Returns the limits of a step of `dt` s.
    pub(super) fn within(&self, dt: f64) -> StepLimits {
        StepLimits {
            share: self.share(dt),
            farthest: self.speed * dt,
        }
    }
}

/// The motion of any joint in a time step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StepLimits {
    /// The share of the distance to its command.
    share: f64,
    /// The greatest turn, deg.
    farthest: f64,
}

/// The load of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointLoad {
    /// Torque, N·m.
    pub(super) torque: f64,
    /// Decrease of the torque with a turn, N·m/rad.
    pub(super) stiffness: f64,
}

/// The servo of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Servo {
    /// deg.
    pub(super) angle: f64,
    /// The motor's torque, N·m.
    pub(super) torque: f64,
    /// True if the load exceeded the motor at the last motion.
    pub(super) gave_way: bool,
}

impl Servo {
    /// Returns a joint at rest at an angle (deg).
    pub(super) const fn at(angle: f64) -> Self {
        Servo {
            angle,
            torque: 0.0,
            gave_way: false,
        }
    }

    /// Moves the joint under a load.
    pub(super) fn advance(
        &mut self,
        joint: &Joint,
        command: JointCommand,
        JointLoad {
            torque: load,
            stiffness,
        }: JointLoad,
        StepLimits { share, farthest }: StepLimits,
    ) {
        let strongest = joint.torque;
        self.gave_way =
            matches!(command, JointCommand::Angle { .. }) && libm::fabs(load) > strongest;
        let turn = match command {
            JointCommand::Angle { .. } if self.gave_way => {
                // The load wins: the joint gives way.
                self.torque = within(-load, -strongest, strongest);
                farthest * (load + self.torque) / strongest
            }
            JointCommand::Angle { angle: target, .. } => {
                self.torque = -load;
                (target - self.angle) * share
            }
            JointCommand::Torque(torque) => {
                // Without inertia a torque that nothing balances turns a viscous joint. The load is
                // taken as it is after the turn (the implicit Euler method): a foot on a stiff floor
                // would bounce for good under the load that it had before.
                self.torque = within(torque, -strongest, strongest);
                let opposed = 1.0 + farthest.to_radians() * stiffness / strongest;
                farthest * (self.torque + load) / strongest / opposed
            }
        };
        if turn.is_finite() {
            let stops = joint.outer.widened(STOP);
            let angle = self.angle + within(turn, -farthest, farthest);
            self.angle = within(angle, stops.min, stops.max);
        }
    }
}

/// Limits a value like [`f64::clamp`], which would panic where the limits of a model are invalid.
fn within(value: f64, least: f64, most: f64) -> f64 {
    if value > most {
        most
    } else if value < least {
        least
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::titan8;

    const KNEE: Joint = titan8::MODEL.legs[0].joints[2];

    /// Returns a load that no turn changes.
    const fn free(torque: f64) -> JointLoad {
        JointLoad {
            torque,
            stiffness: 0.0,
        }
    }

    /// Returns the limits of an ordinary servo in 20 ms.
    fn step() -> StepLimits {
        ServoDynamics::default().within(0.02)
    }

    fn advanced(command: JointCommand, load: f64, cycles: u32) -> Servo {
        let mut servo = Servo::at(90.0);
        for _ in 0..cycles {
            servo.advance(&KNEE, command, free(load), step());
        }
        servo
    }

    #[test]
    fn a_servo_arrives_without_error_and_carries_its_load() {
        let servo = advanced(JointCommand::at(60.0), 12.5, 100);
        assert!((servo.angle - 60.0).abs() < 1e-9);
        assert_eq!(servo.torque, -12.5);
    }

    #[test]
    fn one_time_constant_closes_the_gap_but_for_one_part_in_e() {
        let dynamics = ServoDynamics {
            lag: 20.0,
            speed: 1e9,
        };
        let mut servo = Servo::at(90.0);
        let step = dynamics.within(0.02);
        servo.advance(&KNEE, JointCommand::at(80.0), free(0.0), step);
        assert!((servo.angle - 80.0 - 10.0 * libm::exp(-1.0)).abs() < 1e-12);
    }

    #[test]
    fn no_joint_turns_faster_than_its_motor() {
        // 360 deg/s: 7.2 degrees in 20 ms.
        let servo = advanced(JointCommand::at(20.0), 0.0, 1);
        assert!((servo.angle - 82.8).abs() < 1e-12);
        let servo = advanced(JointCommand::Torque(1000.0), 1000.0, 1);
        assert!((servo.angle - 97.2).abs() < 1e-12);
    }

    #[test]
    fn no_motor_gives_more_than_its_torque_and_a_load_above_turns_it() {
        let servo = advanced(JointCommand::at(90.0), 60.0, 1);
        assert_eq!(servo.torque, -40.0);
        assert!((servo.angle - 93.6).abs() < 1e-12);
        let servo = advanced(JointCommand::at(90.0), 40.0, 1);
        assert_eq!((servo.angle, servo.torque), (90.0, -40.0));
    }

    #[test]
    fn the_stops_hold_and_nonsense_moves_nothing() {
        assert_eq!(advanced(JointCommand::Torque(40.0), 0.0, 1000).angle, 157.0);
        assert_eq!(advanced(JointCommand::Torque(-40.0), 0.0, 1000).angle, -2.0);
        assert_eq!(advanced(JointCommand::at(f64::NAN), 0.0, 5).angle, 90.0);
    }

    #[test]
    fn a_torque_settles_on_a_stiff_floor_without_bouncing() {
        const STIFFNESS: f64 = 1e6;
        let mut servo = Servo::at(90.0);
        let mut depth = 0.0_f64;
        for _ in 0..50 {
            let torque = -STIFFNESS * depth.to_radians();
            let load = JointLoad {
                torque,
                stiffness: STIFFNESS,
            };
            servo.advance(&KNEE, JointCommand::Torque(10.0), load, step());
            assert!(servo.angle - 90.0 >= depth, "it bounces");
            depth = servo.angle - 90.0;
        }
        // 10 N·m against 10⁶ N·m/rad.
        assert!((depth.to_radians() - 1e-5).abs() < 1e-9);
    }
}
