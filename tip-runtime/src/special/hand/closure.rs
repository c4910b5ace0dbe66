//! Active force closure of the second kind (SPECIAL 5 and 6): the fingertips move the object that
//! they hold, each joint by its steady torque and a correction, `τ = τ₀ + k (θ_d − θ)`.

use super::{FINGERS, JOINTS, not_negative};
use crate::command::{Command, MAX, Op, Target, Teach, Value};
use crate::fault::Fault;
use crate::program::Robot;

/// The state of a finger at the beginning of the closure.
#[derive(Clone, Copy, Debug, Default)]
struct Finger {
    /// Steady torques, mN·m.
    torques: [f64; MAX],
    /// Desired joint angles `θ_d`, deg.
    angles: [f64; MAX],
    /// Position of the fingertip, mm.
    fingertip: [f64; 2],
}

/// The closure in progress.
#[derive(Clone, Copy, Debug)]
struct Carrying {
    fingers: [Finger; FINGERS],
    /// mN·m/deg.
    gain: f64,
    /// Distance that the fingertips are to move, mm; without one they move on.
    distance: Option<f64>,
    /// Desired displacement so far, mm along x and y.
    displacement: [f64; 2],
    arrived: bool,
    /// Time since the last SPECIAL 6, ms; `None` before the first one.
    elapsed: Option<f64>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Closure(Option<Carrying>);

impl Closure {
    /// SPECIAL 5: takes gain and distance, stores the state of the fingers and clears
    /// SPECIAL_FLAG0.
    pub(super) fn begin(
        &mut self,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let [Some(gain), distance] = arguments else {
            return Err(Fault::Domain);
        };
        let mut fingers = [Finger::default(); FINGERS];
        for (n, finger) in (1..).zip(&mut fingers) {
            *finger = Finger {
                torques: robot.torques(n)?,
                angles: robot.teach(Teach::Angle, Target::Foot(n))?,
                fingertip: fingertip(n, robot)?,
            };
        }
        self.0 = Some(Carrying {
            fingers,
            gain: not_negative(gain)?,
            distance: distance.map(not_negative).transpose()?,
            displacement: [0.0; 2],
            arrived: false,
            elapsed: None,
        });
        robot.set_special_flag(0, false);
        Ok(())
    }

    /// SPECIAL 6: takes the velocity along x and y; called repeatedly. The desired displacement
    /// grows by it for the time since the last call.
    pub(super) fn carry_on(
        &mut self,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let ([Some(x), Some(y)], Some(mut carrying)) = (arguments, self.0) else {
            return Err(Fault::Domain);
        };
        let velocity = [crate::ops::finite(x)?, crate::ops::finite(y)?];
        carrying.advance(velocity, robot)?;
        let torques = carrying.torques(robot)?;
        for (n, torques) in (1..).zip(torques) {
            robot.command(&Command {
                op: Op::Torque,
                hs: false,
                target: Target::Foot(n),
                values: &torques.map(Value::Absolute),
            })?;
        }
        if carrying.arrived {
            robot.set_special_flag(0, true);
        }
        self.0 = Some(carrying);
        Ok(())
    }

    /// Adds a cycle of `period` ms to the elapsed time.
    pub(super) fn elapse(&mut self, period: f64) {
        if let Some(Carrying {
            elapsed: Some(elapsed),
            ..
        }) = &mut self.0
        {
            *elapsed += period;
        }
    }
}

impl Carrying {
    /// Checks whether the fingertips have arrived; if not, their desired positions move at
    /// `velocity` (mm/s).
    fn advance(&mut self, velocity: [f64; 2], robot: &dyn Robot) -> Result<(), Fault> {
        let gone = self.gone_along(velocity, robot)?;
        self.arrived |= self.distance.is_some_and(|distance| gone >= distance);
        let seconds = self.elapsed.replace(0.0).unwrap_or(0.0) / 1000.0;
        if !self.arrived {
            for (displacement, velocity) in self.displacement.iter_mut().zip(velocity) {
                *displacement += velocity * seconds;
            }
        }
        Ok(())
    }

    /// Returns the mean distance that the fingertips have moved along a velocity, mm.
    fn gone_along(&self, [vx, vy]: [f64; 2], robot: &dyn Robot) -> Result<f64, Fault> {
        let speed = libm::hypot(vx, vy);
        if speed == 0.0 {
            return Ok(0.0);
        }
        let mut sum = 0.0;
        for (n, finger) in (1..).zip(&self.fingers) {
            let ([x, y], [from_x, from_y]) = (fingertip(n, robot)?, finger.fingertip);
            sum += (x - from_x) * (vx / speed) + (y - from_y) * (vy / speed);
        }
        Ok(sum / FINGERS as f64)
    }

    /// Returns the torque of each joint, mN·m.
    fn torques(&mut self, robot: &dyn Robot) -> Result<[[f64; JOINTS]; FINGERS], Fault> {
        let mut torques = [[0.0; JOINTS]; FINGERS];
        let [dx, dy] = self.displacement;
        for (n, (finger, torques)) in (1..).zip(self.fingers.iter_mut().zip(&mut torques)) {
            let [x, y] = finger.fingertip;
            finger.angles = robot.inverse(n, &finger.angles, [x + dx, y + dy, 0.0])?;
            let measured = robot.teach(Teach::Angle, Target::Foot(n))?;
            let errors = finger.angles.iter().zip(measured).map(|(d, at)| d - at);
            for (torque, (steady, error)) in
                torques.iter_mut().zip(finger.torques.iter().zip(errors))
            {
                *torque = crate::ops::finite(steady + self.gain * error)?;
            }
        }
        Ok(torques)
    }
}

fn fingertip(n: u8, robot: &dyn Robot) -> Result<[f64; 2], Fault> {
    let [x, y, ..] = robot.teach(Teach::Position, Target::Foot(n))?;
    Ok([x, y])
}
