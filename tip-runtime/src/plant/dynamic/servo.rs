//! A joint's motor, and the position loop that drives it: proportional and differential, with the forces that they will
//! have at the end of the step (Tan, Liu and Turk, *Stable Proportional-Derivative Controllers*, 2011).

use crate::hardware::JointCommand;
use crate::model::Joint;
use crate::plant::{Effort, STOP, ServoDynamics};

/// How much stiffer than a position loop a mechanical stop is.
const HARDER: f64 = 10.0;

/// What the motors of all joints are like. What grows with a motor is given for each N·m of the most that it gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drives {
    /// How a joint's set point follows its command.
    pub servos: ServoDynamics,
    /// How hard a joint is drawn to its set point: N·m/rad for each N·m.
    pub stiffness: f64,
    /// How hard its rate is drawn to that of its set point: N·m·s/rad for each N·m.
    pub damping: f64,
    /// The inertia of motor and gear, as the joint feels it: kg·m² for each N·m.
    pub rotor: f64,
    /// Viscous friction of the joint: N·m·s/rad for each N·m.
    pub friction: f64,
}

impl Default for Drives {
    /// Of a motor of 40 N·m: 8000 N·m/rad, 120 N·m·s/rad, 0.03 kg·m² and 0.1 N·m·s/rad.
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

/// What a joint is commanded by. Its leg knows, in a bit: as a part of each joint it would take eight bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Control {
    Angle,
    Torque,
}

/// A piece of time, and what set points may do in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stride {
    /// s.
    pub(super) dt: f64,
    /// What fraction of the distance to the command a set point moves.
    share: f64,
    /// The fastest: rad/s.
    speed: f64,
}

impl Stride {
    /// Of `dt` s.
    pub(super) fn of(dt: f64, servos: &ServoDynamics) -> Self {
        Stride {
            dt,
            share: 1.0 - libm::exp(-1000.0 * dt / servos.lag),
            speed: servos.speed.to_radians(),
        }
    }
}

/// One joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Servo {
    /// rad.
    pub(super) angle: f64,
    /// rad/s.
    pub(super) rate: f64,
    /// What is commanded now: an angle between the command before and this one (rad), or a torque (N·m).
    order: f64,
    /// After lag and limit of speed: rad.
    setpoint: f64,
    /// What the motor gives: N·m.
    pub(super) torque: f64,
}

impl Servo {
    /// At rest at an angle: deg.
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

    /// Takes a command, and says what the joint is commanded by from now on; `unit` is how many of the robot's torque unit
    /// one N·m is. A command that is not a number changes nothing.
    pub(super) fn obey(&mut self, before: Control, command: JointCommand, unit: f64) -> Control {
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

    /// Where a command wants the joint at the end of the cycle: rad.
    fn goal(&self, command: Option<JointCommand>) -> f64 {
        match command {
            Some(JointCommand::Angle { angle, .. }) if angle.is_finite() => angle.to_radians(),
            _ => self.order,
        }
    }

    /// Holds the joint where it is to be now, from now on by angle.
    pub(super) const fn hold(&mut self) {
        self.order = self.setpoint;
    }

    /// Moves the set point on by one of `left` steps of a cycle, and lets the motor draw the joint there, or give the
    /// torque that it is commanded. The command is the one [obeyed](Self::obey) before; without it the joint is held.
    #[inline]
    pub(super) fn aim(
        &mut self,
        control: Control,
        command: Option<JointCommand>,
        joint: &Joint,
        drives: &Drives,
        stride: &Stride,
        left: f64,
    ) {
        let Stride { dt, share, speed } = *stride;
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

    /// Whether a joint turns the way of a torque faster than its motor.
    #[inline]
    fn is_too_fast(&self, torque: f64, speed: f64) -> bool {
        self.rate * torque.signum() > speed
    }

    /// What the motor turns the joint by, after [`aim`](Self::aim); with no more than it can give if it is `spent`.
    #[inline]
    pub(super) fn motor(
        &self,
        control: Control,
        joint: &Joint,
        drives: &Drives,
        dt: f64,
        spent: bool,
    ) -> Effort {
        let inertia = match control {
            Control::Angle if !spent => {
                dt * (drives.damping + dt * drives.stiffness) * joint.torque
            }
            _ => 0.0,
        };
        Effort {
            torque: if spent {
                within(self.torque, joint.torque)
            } else {
                self.torque
            },
            inertia,
        }
    }

    /// What rotor, friction and mechanical stops add.
    #[inline]
    pub(super) fn passive(&self, joint: &Joint, drives: &Drives, dt: f64) -> Effort {
        let friction = drives.friction * joint.torque;
        let mut effort = Effort {
            torque: -friction * self.rate,
            inertia: drives.rotor * joint.torque + dt * friction,
        };
        let least = (joint.outer.min - STOP).to_radians();
        let most = (joint.outer.max + STOP).to_radians();
        let beyond = self.angle - self.angle.max(least).min(most);
        if beyond != 0.0 {
            let stiffness = HARDER * drives.stiffness * joint.torque;
            let damping = drives.damping * joint.torque;
            effort.torque -= stiffness * (beyond + dt * self.rate) + damping * self.rate;
            effort.inertia += dt * (damping + dt * stiffness);
        }
        effort
    }

    /// Whether a joint that accelerates so (rad/s²) asks more of its motor than it can give, which then gives that.
    #[inline]
    pub(super) fn overload(&mut self, joint: &Joint, own: Effort, acceleration: f64) -> bool {
        let torque = own.torque - own.inertia * acceleration;
        let is_too_much = libm::fabs(torque) > joint.torque;
        if is_too_much {
            self.torque = torque;
        }
        is_too_much
    }

    /// Moves for `dt` s.
    #[inline]
    pub(super) fn advance(&mut self, joint: &Joint, own: Effort, acceleration: f64, dt: f64) {
        self.torque = within(own.torque - own.inertia * acceleration, joint.torque);
        self.rate += acceleration * dt;
        self.angle += self.rate * dt;
    }
}

/// The value, or `most` of its sign.
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
        let torque = servo.obey(Control::Angle, JointCommand::Torque(5.0), 1.0);
        assert_eq!((torque, servo.order), (Control::Torque, 5.0));
        // A command that is not a number leaves the torque.
        let nonsense = JointCommand::Torque(f64::NAN);
        assert_eq!(servo.obey(torque, nonsense, 1.0), Control::Torque);
        assert_eq!(servo.order, 5.0);
        let angle = JointCommand::Angle {
            angle: 30.0,
            rate: 0.0,
        };
        assert_eq!(servo.obey(torque, angle, 1.0), Control::Angle);
        assert_eq!(servo.order, 10_f64.to_radians());
        assert_eq!(servo.goal(Some(angle)), 30_f64.to_radians());
        assert_eq!(servo.goal(None), servo.order);
    }
}
