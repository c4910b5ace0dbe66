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
            dt,
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
    /// s.
    dt: f64,
}

/// The load of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointLoad {
    /// Torque, N·m.
    pub(super) torque: f64,
    /// Decrease of the torque with a turn, N·m/rad.
    pub(super) stiffness: f64,
    /// Greatest angular acceleration of a joint that lifts the body, deg/s²: infinite if it lifts nothing.
    pub(super) lift: f64,
}

/// The servo of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Servo {
    /// Angle of the joint, deg.
    pub(super) angle: f64,
    /// The motor's torque, N·m.
    pub(super) torque: f64,
    /// True if the load exceeded the motor at the last motion.
    pub(super) gave_way: bool,
    /// Speed of a joint that gave way, deg/s, until it is back at its command.
    returning: Option<f64>,
}

/// Greatest distance of a joint from its command at which it has come back, deg.
const BACK: f64 = 0.1;

impl Servo {
    /// Returns a joint at rest at an angle (deg).
    pub(super) const fn at(angle: f64) -> Self {
        Servo {
            angle,
            torque: 0.0,
            gave_way: false,
            returning: None,
        }
    }

    /// Returns the turn of a joint that would turn by `turn` (deg) to its command: after it has given way, no faster
    /// than the `surplus` of its torque, a share, accelerates the body.
    fn turn_back(&mut self, turn: f64, surplus: f64, lift: f64, dt: f64) -> f64 {
        let Some(speed) = self.returning else {
            return turn;
        };
        let most = (speed + surplus * lift * dt) * dt;
        let limited = within(turn, -most, most);
        self.returning = (libm::fabs(turn) > BACK).then_some(libm::fabs(limited) / dt);
        limited
    }

    /// Returns true if the joint has given way and is not back at its command.
    pub(super) const fn is_returning(&self) -> bool {
        self.returning.is_some()
    }

    /// Moves the joint under a load.
    pub(super) fn advance(
        &mut self,
        joint: &Joint,
        command: JointCommand,
        JointLoad {
            torque: load,
            stiffness,
            lift,
        }: JointLoad,
        StepLimits {
            share,
            farthest,
            dt,
        }: StepLimits,
    ) {
        let strongest = joint.torque;
        self.gave_way =
            matches!(command, JointCommand::Angle { .. }) && libm::fabs(load) > strongest;
        let turn = match command {
            JointCommand::Angle { .. } if self.gave_way => {
                // The load wins: the joint gives way.
                self.returning = Some(0.0);
                self.torque = within(-load, -strongest, strongest);
                farthest * (load + self.torque) / strongest
            }
            JointCommand::Angle { angle: target, .. } => {
                self.torque = -load;
                let surplus = 1.0 - libm::fabs(load) / strongest;
                self.turn_back((target - self.angle) * share, surplus, lift, dt)
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
            lift: f64::INFINITY,
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
    fn a_joint_that_gave_way_comes_back_as_its_torque_accelerates_the_body() {
        let mut servo = Servo::at(90.0);
        let command = JointCommand::at(90.0);
        servo.advance(&KNEE, command, free(60.0), step());
        assert!((servo.angle - 93.6).abs() < 1e-12);
        // Half of its torque is left: 500 of 1000 deg/s², 0.2 deg in the first 20 ms, 0.4 deg in the next.
        let load = JointLoad {
            torque: 20.0,
            stiffness: 0.0,
            lift: 1000.0,
        };
        for expected in [93.4, 93.0, 92.4] {
            servo.advance(&KNEE, command, load, step());
            assert!((servo.angle - expected).abs() < 1e-9, "{}", servo.angle);
        }
        for _ in 0..50 {
            servo.advance(&KNEE, command, load, step());
        }
        assert!((servo.angle - 90.0).abs() < 0.01 && !servo.is_returning());
        // From then on it follows its commands as before.
        servo.advance(&KNEE, JointCommand::at(86.0), load, step());
        let share = ServoDynamics::default().share(0.02);
        assert!(
            (servo.angle - 90.0 + 4.0 * share).abs() < 0.02,
            "{}",
            servo.angle
        );
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
                lift: f64::INFINITY,
            };
            servo.advance(&KNEE, JointCommand::Torque(10.0), load, step());
            assert!(servo.angle - 90.0 >= depth, "it bounces");
            depth = servo.angle - 90.0;
        }
        // 10 N·m against 10⁶ N·m/rad.
        assert!((depth.to_radians() - 1e-5).abs() < 1e-9);
    }
}
