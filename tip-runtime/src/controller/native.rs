//! Functions for native code, and the vibrations that it adds to joint commands (active friction control, T.I.P. 3.1
//! §8-2-2).

use super::drive::{bounded, reach};
use super::sensing::members;
use super::targets::unlocked;
use super::trajectory::{Goal, SetPoint};
use super::{ControllerView, targets};
use crate::command::{MAX, Target};
use crate::fault::Fault;
use crate::hardware::JointCommand;
use crate::kinematics::LegPoint;
use crate::model::{Joint, Point, VibrationGain};
use crate::vibration::{Vibration, Waveform};
use core::f64::consts::TAU;

impl<const J: usize> ControllerView<J> {
    /// Pulls a foot, or a third joint, to the place `to` (mm) by a spring with its own stiffness (N/mm along each
    /// axis), whose set point is there immediately. All else is as in COMPLIANCE_POSITION.
    ///
    /// # Errors
    /// `Domain` for another target, a place that is not finite, a stiffness that is not finite or
    /// negative, or a robot without torques; `InvalidMode` if a joint is locked that it would change.
    pub fn pull(&mut self, target: Target, to: Point, stiffness: [f64; 3]) -> Result<(), Fault> {
        let (n, point) = self.point_of(target)?;
        let sound = to.iter().all(|place| place.is_finite())
            && stiffness.iter().all(|k| k.is_finite() && *k >= 0.0);
        if !sound || self.robot.forces.is_none() {
            return Err(Fault::Domain);
        }
        unlocked(self.leg(n)?.locks_point(point))?;
        let target = self.robot.inverse.flat(to);
        let spring = Goal::Spring { target, hs: false };
        self.take_point(n, point, SetPoint::resting(target).towards(spring))?;
        targets::leg_mut(&mut self.legs, n)?.drive.own_stiffness = Some(stiffness);
        Ok(())
    }

    /// Returns the commanded torque of each joint of a leg, or the sensed one if none is commanded, in the robot's
    /// torque unit.
    ///
    /// # Errors
    /// `Domain` for a leg that the robot lacks, or a robot without torques.
    pub fn torques(&self, n: u8) -> Result<[f64; MAX], Fault> {
        if self.robot.forces.is_none() {
            return Err(Fault::Domain);
        }
        let leg = self.leg(n)?;
        let mut torques = members(&leg.torques);
        for (torque, command) in torques.iter_mut().zip(leg.drive.outputs()) {
            if let JointCommand::Torque(commanded) = command {
                *torque = commanded;
            }
        }
        Ok(torques)
    }

    /// Returns the joint angles (deg), near the angles `from`, that put a foot at `position` (mm).
    ///
    /// # Errors
    /// `OutOfReach` or `JointLimit` if there are none, `Domain` for a leg that the robot lacks.
    pub fn inverse(&self, n: u8, from: &[f64; MAX], position: Point) -> Result<[f64; MAX], Fault> {
        let leg = &self.leg(n)?.model;
        let mut near = leg.initial;
        for (near, from) in near.iter_mut().zip(from) {
            *near = *from;
        }
        let found = reach(self.robot.inverse, leg, (LegPoint::Tip, n), &near, position)?;
        Ok(members(&found))
    }
}

/// The vibration of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointVibration {
    vibration: Option<Vibration>,
    /// Phase of the wave, 0…1.
    phase: f64,
}

/// The share of a sawtooth's time that its slow flank takes.
const SLOW: f64 = 0.8;

impl JointVibration {
    pub(super) const STILL: Self = JointVibration {
        vibration: None,
        phase: 0.0,
    };

    /// Advances by `dt` seconds. Under a hold it waits at the start of its wave.
    fn advance(&mut self, dt: f64, held: bool) {
        self.phase = match self.vibration {
            Some(vibration) if !held => fraction(self.phase + fraction(vibration.frequency * dt)),
            _ => 0.0,
        };
    }

    /// Returns the present deviation, V.
    fn volts(&self) -> f64 {
        self.vibration.map_or(0.0, |vibration| {
            vibration.amplitude * wave(vibration.waveform, self.phase)
        })
    }

    /// Returns the command of a joint that is at `measured` (deg) with its vibration; the joint is commanded no more
    /// than the torque `most_torque`.
    pub(super) fn vibrated(
        &self,
        command: JointCommand,
        joint: &Joint,
        measured: f64,
        (per_volt, most_torque): (VibrationGain, f64),
    ) -> JointCommand {
        if self.vibration.is_none() {
            return command;
        }
        let volts = self.volts();
        match command {
            JointCommand::Angle { angle, rate } => JointCommand::Angle {
                // A deviation stays within the joint's working limits.
                angle: joint
                    .limits
                    .including(angle)
                    .nearest(angle + per_volt.angle * volts),
                rate,
            },
            JointCommand::Torque(torque) => {
                let vibrated = bounded(torque + per_volt.torque * volts, most_torque);
                JointCommand::Torque(inward(vibrated, measured, joint))
            }
        }
    }
}

/// Returns a wave of amplitude 1 at a phase of 0…1.
fn wave(waveform: Waveform, phase: f64) -> f64 {
    match waveform {
        Waveform::Sine => libm::sin(TAU * phase),
        Waveform::OneSided => (1.0 - libm::cos(TAU * phase)) / 2.0,
        Waveform::Sawtooth => {
            let half = SLOW / 2.0;
            if phase <= half {
                phase / half
            } else if phase < 1.0 - half {
                (0.5 - phase) / (0.5 - half)
            } else {
                (phase - 1.0) / half
            }
        }
    }
}

fn fraction(value: f64) -> f64 {
    value - libm::floor(value)
}

impl<const J: usize> ControllerView<J> {
    /// Starts or ends the vibration of a joint about its command. A joint that vibrates already keeps the phase of its
    /// wave.
    ///
    /// # Errors
    /// `Domain` for a target that is not a joint, a robot that does not vibrate, an amplitude that is
    /// not finite, or a frequency that is not finite or negative; `InvalidMode` for a locked joint that
    /// is to vibrate.
    pub fn vibrate(&mut self, joint: Target, vibration: Option<Vibration>) -> Result<(), Fault> {
        let Target::Joint(n, m) = joint else {
            return Err(Fault::Domain);
        };
        let sound = vibration.is_none_or(|it| {
            it.amplitude.is_finite() && it.frequency.is_finite() && it.frequency >= 0.0
        });
        if !sound || self.robot.vibration.is_none() {
            return Err(Fault::Domain);
        }
        let leg = targets::leg_mut(&mut self.legs, n)?;
        unlocked(vibration.is_some() && leg.switches.is_locked(targets::index(m)))?;
        let joint_vibration = targets::leg_mut(&mut leg.vibrations, m)?;
        *joint_vibration = match vibration {
            Some(_) => JointVibration {
                vibration,
                ..*joint_vibration
            },
            None => JointVibration::STILL,
        };
        Ok(())
    }

    /// Ends every vibration.
    pub(super) fn still(&mut self) {
        for leg in &mut self.legs {
            leg.vibrations = [JointVibration::STILL; J];
        }
    }

    /// Advances the vibrations by `dt` seconds.
    pub(super) fn advance_vibrations(&mut self, dt: f64) {
        for joint_vibration in self.legs.iter_mut().flat_map(|leg| &mut leg.vibrations) {
            joint_vibration.advance(dt, self.hold.is_on());
        }
    }
}

/// Limits a torque so that it does not push a joint beyond its working limit.
fn inward(torque: f64, measured: f64, joint: &Joint) -> f64 {
    if measured >= joint.limits.max {
        torque.min(0.0)
    } else if measured <= joint.limits.min {
        torque.max(0.0)
    } else {
        torque
    }
}
