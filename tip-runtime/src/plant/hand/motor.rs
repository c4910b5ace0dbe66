//! The drive of a joint: its motor by torque or as a servo, friction, and the stops.
//!
//! Springs and dampers of a joint are taken at the end of each step, friction at its middle, so
//! that no gain is too stiff for the step (Tan, Liu and Turk, *Stable Proportional-Derivative
//! Controllers*, 2011): terms in the acceleration count as inertia.

use super::contact::within;
use crate::hardware::JointCommand;
use crate::model::{Joint, Range};
use crate::plant::{Effort, STOP};

/// Stiffness of the position servo, far stiffer than any contact, N·m/rad.
const SERVO: f64 = 1e5;

/// Damping of the position servo, N·m·s/rad.
const SERVO_DAMPING: f64 = 100.0;

/// Viscous friction of the joint, N·m·s/rad.
const FRICTION: f64 = 0.01;

/// Stiffness of the stops, N·m/rad.
const STOP_STIFFNESS: f64 = 500.0;

/// Damping of the stops, N·m·s/rad.
const STOP_DAMPING: f64 = 0.5;

impl Effort {
    /// Returns the effort of a spring (N·m/rad) that is stretched by `gap` deg, and a damper
    /// (N·m·s/rad) between rates that differ by `slower` rad/s, both at the end of a step of `dt` s
    /// at constant rate. A change of the rate is even, and turns the joint half as far as the final
    /// rate would.
    #[inline]
    fn spring(stiffness: f64, damping: f64, gap: f64, slower: f64, dt: f64) -> Self {
        Effort {
            torque: stiffness * gap.to_radians() + damping * slower,
            inertia: dt * (damping + dt / 2.0 * stiffness),
        }
    }
}

/// The mode of a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// Gives a torque, N·m.
    Torque(f64),
    /// Holds an angle, which moves.
    Servo,
    /// Like `Servo`, saturated for this step at a torque, N·m.
    Yielding(f64),
}

/// The motor of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Motor {
    /// The greatest torque, N·m.
    strongest: f64,
    /// The mechanical stops, deg.
    stops: Range,
    mode: Mode,
    /// The set point of a servo, deg.
    set_point: f64,
    /// Speed of the set point, rad/s.
    set_rate: f64,
    /// The current torque, N·m.
    pub(super) torque: f64,
    /// Acceleration of the joint in the last step, rad/s²; 0 of one that the servo led, which keeps its rate.
    pub(super) carried: f64,
}

impl Motor {
    /// A motor without torque.
    pub(super) const IDLE: Self = Motor {
        strongest: 0.0,
        stops: Range::new(0.0, 0.0),
        mode: Mode::Servo,
        set_point: 0.0,
        set_rate: 0.0,
        torque: 0.0,
        carried: 0.0,
    };

    /// Returns a motor that holds an angle (deg).
    pub(super) fn new(joint: &Joint, angle: f64) -> Self {
        Motor {
            strongest: joint.torque,
            stops: joint.outer.widened(STOP),
            set_point: angle,
            ..Motor::IDLE
        }
    }

    /// Takes a command for the next `time` s, in which a servo's set point moves evenly to its
    /// target, or to the stop before that; the set point of a joint that was driven by torque
    /// starts at its `angle` (deg). `unit` is the number of the command's units in one N·m. A value
    /// that is not a number is ignored.
    pub(super) fn command(&mut self, command: JointCommand, unit: f64, angle: f64, time: f64) {
        if let Mode::Torque(_) = self.mode {
            self.set_point = angle;
        }
        self.set_rate = 0.0;
        match command {
            JointCommand::Torque(torque) if torque.is_finite() => {
                let torque = torque / unit;
                self.mode = Mode::Torque(within(torque, self.strongest));
            }
            JointCommand::Angle { angle: target, .. } if target.is_finite() => {
                self.mode = Mode::Servo;
                let target = self.stops.nearest(target);
                self.set_rate = (target - self.set_point).to_radians() / time;
            }
            JointCommand::Torque(_) | JointCommand::Angle { .. } => self.mode = Mode::Servo,
        }
    }

    /// Holds the joint's current angle (deg).
    pub(super) const fn hold(&mut self, angle: f64) {
        self.mode = Mode::Servo;
        self.set_point = angle;
        self.set_rate = 0.0;
    }

    /// Moves the set point for `dt` s.
    #[inline]
    pub(super) fn advance(&mut self, dt: f64) {
        self.set_point += (self.set_rate * dt).to_degrees();
        if let Mode::Yielding(_) = self.mode {
            self.mode = Mode::Servo;
        }
    }

    /// Returns the effort of the motor on a joint at `angle` deg in the middle of a step of `dt` s,
    /// at whose start it turns at `rate` rad/s.
    #[inline]
    pub(super) fn effort(&self, angle: f64, rate: f64, dt: f64) -> Effort {
        match self.mode {
            Mode::Torque(torque) | Mode::Yielding(torque) => Effort {
                torque,
                inertia: 0.0,
            },
            Mode::Servo => {
                let gap = self.set_point - angle - (rate * dt / 2.0).to_degrees();
                Effort::spring(SERVO, SERVO_DAMPING, gap, self.set_rate - rate, dt)
            }
        }
    }

    /// Returns the efforts of friction and the stops on that joint.
    #[inline]
    pub(super) fn resistance(&self, angle: f64, rate: f64, dt: f64) -> [Effort; 2] {
        let friction = Effort {
            torque: -FRICTION * rate,
            inertia: FRICTION * dt / 2.0,
        };
        let ahead = angle + (rate * dt / 2.0).to_degrees();
        [friction, self.stop(ahead, rate, dt)]
    }

    /// Takes the acceleration (rad/s²) that resulted with the motor's `own` effort. Returns true if
    /// the motor exceeded its greatest torque, and saturates it.
    #[inline]
    pub(super) fn settle(&mut self, own: Effort, acceleration: f64) -> bool {
        self.torque = own.at(acceleration);
        let bounded = within(self.torque, self.strongest);
        let yields = matches!(self.mode, Mode::Servo) && bounded != self.torque;
        if yields {
            self.mode = Mode::Yielding(bounded);
        }
        self.carried = match self.mode {
            Mode::Servo => 0.0,
            Mode::Torque(_) | Mode::Yielding(_) => acceleration,
        };
        yields
    }

    /// Returns the effort of a stop on a joint whose angle is going to be `ahead` deg.
    #[inline]
    fn stop(&self, ahead: f64, rate: f64, dt: f64) -> Effort {
        let stops = self.stops;
        if stops.contains(ahead) {
            return Effort::default();
        }
        let gap = ahead.min(stops.max).max(stops.min) - ahead;
        Effort::spring(STOP_STIFFNESS, STOP_DAMPING, gap, -rate, dt)
    }
}
