//! The body sways along a circle while the feet stand: a command of many cycles.

use tip_runtime::command::{Command, Flag, Op, Poll, Target, Teach, Value};
use tip_runtime::fault::Fault;
use tip_runtime::kinematics::{inverse, within_limits};
use tip_runtime::model::titan8::MODEL;
use tip_runtime::ops;
use tip_runtime::program::Robot;

/// Speed of the body along the circle, mm/s. A foot has to keep up with it under V_MAX.
const SPEED: f64 = 100.0;

/// Maximum angular speed, on a small circle, deg/s.
const FASTEST: f64 = 180.0;

/// Along how much of the spiral out and in the radius grows and shrinks: deg.
const SPIRAL: f64 = 180.0;

/// A sway in progress: half a turn spirals out, whole turns follow, half a turn spirals in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Circle {
    /// Feet at the start, in the robot frame, mm.
    feet: [[f64; 3]; 4],
    /// mm.
    radius: f64,
    /// deg/s.
    rate: f64,
    /// Angle travelled, deg.
    angle: f64,
    /// Angle at the end, deg.
    end: f64,
}

impl Circle {
    /// About where the body is now.
    ///
    /// # Errors
    /// `Domain` unless both numbers are positive.
    pub(crate) fn new(radius: f64, turns: f64, robot: &dyn Robot) -> Result<Self, Fault> {
        if radius <= 0.0 || turns <= 0.0 {
            return Err(Fault::Domain);
        }
        let mut feet = [[0.0; 3]; 4];
        for (n, foot) in (1..).zip(&mut feet) {
            let [x, y, z, ..] = robot.teach(Teach::Position, Target::Foot(n))?;
            *foot = [x, y, z];
        }
        Ok(Circle {
            feet,
            radius,
            rate: (SPEED / radius).to_degrees().min(FASTEST),
            angle: 0.0,
            end: SPIRAL + 360.0 * turns + SPIRAL,
        })
    }

    /// One cycle: done when the body is back and every foot has arrived.
    ///
    /// # Errors
    /// `OutOfReach`, and then no foot is sent anywhere.
    pub(crate) fn poll(&mut self, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        if self.angle >= self.end && robot.flag(Flag::Inpos(Target::All)) {
            return Ok(Poll::Done);
        }
        self.angle = (self.angle + self.rate * robot.period() / 1000.0).min(self.end);
        let [right, forward] = self.body()?;
        // Feet that stand still in the world go backwards in the frame of a body that goes forward.
        let targets = self.feet.map(|[x, y, z]| [x - right, y - forward, z]);
        // A command that fails must not have moved anything: all are looked at before any is sent.
        for (n, target) in (1..).zip(targets) {
            require_reach(n, target)?;
        }
        for (n, target) in (1..).zip(targets) {
            send(n, target, robot)?;
        }
        Ok(Poll::Pending)
    }

    /// Returns the body's setpoint to the right and forward of its start, mm.
    fn body(&self) -> Result<[f64; 2], Fault> {
        let share = (self.angle.min(self.end - self.angle) / SPIRAL).min(1.0);
        // Grows without a jerk: its slope is 0 at either end.
        let radius = self.radius * share * share * (3.0 - 2.0 * share);
        // The runtime's own functions give the same bits on every machine.
        Ok([
            radius * ops::cos(self.angle)?,
            radius * ops::sin(self.angle)?,
        ])
    }
}

fn require_reach(n: u8, target: [f64; 3]) -> Result<(), Fault> {
    let leg = &MODEL.legs[usize::from(n) - 1];
    let reached = inverse(MODEL.inverse, leg, target).filter(|angles| within_limits(leg, angles));
    reached
        .map(|_| ())
        .ok_or(Fault::OutOfReach(Target::Foot(n)))
}

/// HS, because the path itself is smooth: the foot is to be there one cycle later.
fn send(n: u8, target: [f64; 3], robot: &mut dyn Robot) -> Result<(), Fault> {
    robot.command(&Command {
        op: Op::Ptp,
        hs: true,
        target: Target::Foot(n),
        values: &target.map(Value::Absolute),
    })?;
    Ok(())
}
