//! A joint's motor and its position loop: proportional and differential, with the forces at the end
//! of the step (Tan, Liu and Turk, *Stable Proportional-Derivative Controllers*, 2011).

use crate::hardware::JointCommand;
use crate::model::{Joint, Range};
use crate::plant::{Effort, STOP, ServoDynamics};

/// Stiffness of a mechanical stop, relative to a position loop.
const HARDER: f64 = 10.0;

/// The motors of all joints. Values that grow with a motor are given for each N·m of its greatest
/// torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drives {
    /// The dynamics of a joint's set point.
    pub servos: ServoDynamics,
    /// Stiffness of the position loop, N·m/rad for each N·m.
    pub stiffness: f64,
    /// Damping of the position loop, N·m·s/rad for each N·m.
    pub damping: f64,
    /// Inertia of motor and gear at the joint, kg·m² for each N·m.
    pub rotor: f64,
    /// Viscous friction of the joint, N·m·s/rad for each N·m.
    pub friction: f64,
}

impl Default for Drives {
    /// The motors of a robot with 40 N·m: 8000 N·m/rad, 120 N·m·s/rad, 0.03 kg·m² and 0.1
    /// N·m·s/rad.
    fn default() -> Self {
        Drives {
            servos: ServoDynamics::default(),
            stiffness: 200.0,
            damping: 3.0,
            rotor: 7.5e-4,
            friction: 2.5e-3,
        }
    }
}

/// The control mode of a joint. Its leg stores it in a bit: in each joint it would take eight
/// bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Control {
    Angle,
    Torque,
}

/// A time step, and the motion of set points in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TimeStep {
    /// s.
    pub(super) dt: f64,
    /// The share of the distance to the command that a set point moves.
    share: f64,
    /// The greatest speed of a set point, rad/s.
    speed: f64,
}

impl TimeStep {
    /// Returns a step of `dt` s.
    pub(super) fn of(dt: f64, servos: &ServoDynamics) -> Self {
        TimeStep {
            dt,
            share: servos.share(dt),
            speed: servos.speed.to_radians(),
        }
    }
}

/// The motor of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Servo {
    /// rad.
    pub(super) angle: f64,
    /// rad/s.
    pub(super) rate: f64,
    /// The current command: an angle between the previous command and this one (rad), or a torque
    /// (N·m).
    order: f64,
    /// The set point after lag and limit of speed, rad.
    setpoint: f64,
    /// The motor's torque, N·m.
    pub(super) torque: f64,
}

impl Servo {
    /// Returns a joint at rest at an angle (deg).
    pub(super) const fn at(angle: f64) -> Self {
        let angle = angle.to_radians();
        Servo {
            angle,
            rate: 0.0,
            order: angle,
            setpoint: angle,
            torque: 0.0,
        }
    }

    /// Takes a command and returns the new control mode; `unit` is the number of the robot's torque
    /// units in one N·m. A command that is not a number changes nothing.
    pub(super) fn command(&mut self, before: Control, command: JointCommand, unit: f64) -> Control {
        match command {
            JointCommand::Torque(torque) if (torque / unit).is_finite() => {
                self.order = torque / unit;
                Control::Torque
            }
            JointCommand::Angle { angle, .. } if angle.is_finite() => {
                if before == Control::Torque {
                    self.order = self.setpoint;
                }
                Control::Angle
            }
            _ => before,
        }
    }

    /// Returns the commanded angle at the end of the cycle, rad.
    fn goal(&self, command: Option<JointCommand>) -> f64 {
        match command {
            Some(JointCommand::Angle { angle, .. }) if angle.is_finite() => angle.to_radians(),
            _ => self.order,
        }
    }

    /// Holds the joint at its set point, from now on by angle.
    pub(super) const fn hold(&mut self) {
        self.order = self.setpoint;
    }

    /// Moves the set point by one of `left` steps of a cycle, and updates the torque of the motor.
    /// [`command`](Self::command) has taken the command before; without one the joint is held.
    #[inline]
    pub(super) fn aim(
        &mut self,
        control: Control,
        command: Option<JointCommand>,
        joint: &Joint,
        drives: &Drives,
        step: &TimeStep,
        left: f64,
    ) {
        let TimeStep { dt, share, speed } = *step;
        self.torque = match control {
            Control::Angle => {
                self.order += (self.goal(command) - self.order) / left;
                let gap = (self.order - self.setpoint) * share;
                let turn = within(gap, speed * dt);
                self.setpoint += turn;
                let behind = self.setpoint - self.angle - dt * self.rate;
                let slower = turn / dt - self.rate;
                (drives.stiffness * behind + drives.damping * slower) * joint.torque
            }
            Control::Torque => {
                let torque = self.order;
                self.setpoint = self.angle;
                let brake = speed.copysign(torque) - self.rate;
                let torque = match self.is_too_fast(torque, speed) {
                    true => brake * drives.damping * joint.torque,
                    false => torque,
                };
                within(torque, joint.torque)
            }
        };
    }

    /// Returns true if a joint turns the way of a torque faster than its motor.
    #[inline]
    fn is_too_fast(&self, torque: f64, speed: f64) -> bool {
        self.rate * torque.signum() > speed
    }

    /// Returns the effort that the position loop demands, after [`aim`](Self::aim).
    #[inline]
    pub(super) fn demand(
        &self,
        control: Control,
        joint: &Joint,
        drives: &Drives,
        dt: f64,
    ) -> Effort {
        let inertia = match control {
            Control::Angle => dt * (drives.damping + dt * drives.stiffness) * joint.torque,
            Control::Torque => 0.0,
        };
        Effort {
            torque: self.torque,
            inertia,
        }
    }

    /// Returns the effort of rotor, friction and mechanical stops.
    #[inline]
    pub(super) fn passive(&self, joint: &Joint, drives: &Drives, dt: f64) -> Effort {
        let friction = drives.friction * joint.torque;
        let mut effort = Effort {
            torque: -friction * self.rate,
            inertia: drives.rotor * joint.torque + dt * friction,
        };
        let stops = joint.outer.widened(STOP);
        let stops = Range::new(stops.min.to_radians(), stops.max.to_radians());
        let beyond = self.angle - stops.nearest(self.angle);
        if beyond != 0.0 {
            let stiffness = HARDER * drives.stiffness * joint.torque;
            let damping = drives.damping * joint.torque;
            effort.torque -= stiffness * (beyond + dt * self.rate) + damping * self.rate;
            effort.inertia += dt * (damping + dt * stiffness);
        }
        effort
    }

    /// Integrates an acceleration (rad/s²) over `dt` s, which takes `own` effort.
    #[inline]
    pub(super) fn advance(&mut self, joint: &Joint, own: Effort, acceleration: f64, dt: f64) {
        self.torque = within(own.at(acceleration), joint.torque);
        self.rate += acceleration * dt;
        self.angle += self.rate * dt;
    }
}

/// The state of a motor in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Saturation {
    /// It gives what its position loop demands.
    None,
    /// It gives its greatest torque.
    Above,
    /// It gives its least torque.
    Below,
}

impl Saturation {
    /// Returns the state of a motor of which a position loop demands a torque.
    #[inline]
    pub(super) fn of(torque: f64, joint: &Joint) -> Self {
        if torque > joint.torque {
            Saturation::Above
        } else if torque < -joint.torque {
            Saturation::Below
        } else {
            Saturation::None
        }
    }

    /// Returns the effort of a motor whose position loop demands this one.
    #[inline]
    pub(super) fn limit(self, demand: Effort, joint: &Joint) -> Effort {
        let torque = match self {
            Saturation::None => return demand,
            Saturation::Above => joint.torque,
            Saturation::Below => -joint.torque,
        };
        Effort {
            torque,
            inertia: 0.0,
        }
    }
}

/// Limits a value to ±`most`.
#[inline]
fn within(value: f64, most: f64) -> f64 {
    if libm::fabs(value) > most {
        most.copysign(value)
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_after_a_torque_begins_where_the_joint_is() {
        let mut servo = Servo::at(10.0);
        let torque = servo.command(Control::Angle, JointCommand::Torque(5.0), 1.0);
        assert_eq!((torque, servo.order), (Control::Torque, 5.0));
        // A command that is not a number leaves the torque.
        let nonsense = JointCommand::Torque(f64::NAN);
        assert_eq!(servo.command(torque, nonsense, 1.0), Control::Torque);
        assert_eq!(servo.order, 5.0);
        let angle = JointCommand::Angle {
            angle: 30.0,
            rate: 0.0,
        };
        assert_eq!(servo.command(torque, angle, 1.0), Control::Angle);
        assert_eq!(servo.order, 10_f64.to_radians());
        assert_eq!(servo.goal(Some(angle)), 30_f64.to_radians());
        assert_eq!(servo.goal(None), servo.order);
    }
}
