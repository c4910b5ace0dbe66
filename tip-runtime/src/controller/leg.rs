//! Everything that the controller keeps of one leg.

use super::drive::{CycleParams, LegDrive, MovingLeg};
use super::params::LegParams;
use super::switches::LegSwitches;
use super::trajectory::Track;
use super::vibrate::{JointVibration, VibrationContext};
use crate::fault::Fault;
use crate::hardware::JointCommand;
use crate::kinematics::{Chain, LegPoint};
use crate::model::{Inverse, Leg, ModelFacts, Point};

/// One leg: what it is, what it is to do, and what it measured.
#[derive(Clone, Copy, Debug)]
pub struct LegState<'m, const J: usize> {
    /// The leg as the robot has it.
    pub(super) own: &'m Leg<J>,
    /// The leg with the working limits in force.
    pub(super) model: Leg<J>,
    pub(super) switches: LegSwitches<J>,
    pub(super) params: LegParams<J>,
    pub(super) drive: LegDrive<J>,
    pub(super) vibrations: [JointVibration; J],
    /// Measured joint angles, deg.
    pub(super) angles: [f64; J],
    /// Measured joint rates, deg/s.
    pub(super) rates: [f64; J],
    /// Measured, in the robot's torque unit.
    pub(super) torques: [f64; J],
    /// Voltage of the sole's pressure sensor, V.
    pub(super) paw: f64,
    /// Number of cycles that the leg has been still in a search; `None` if it does not search.
    pub(super) search: Option<u16>,
}

impl<'m, const J: usize> LegState<'m, J> {
    /// Creates a leg in its initial posture, not controlled, with standard parameters.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn new(model: &'m Leg<J>, robot: &ModelFacts<'_>) -> Self {
        LegState {
            own: model,
            model: *model,
            switches: LegSwitches::STANDARD,
            params: LegParams::standard(robot),
            drive: LegDrive::free(model.initial),
            vibrations: [JointVibration::STILL; J],
            angles: model.initial,
            rates: [0.0; J],
            torques: [0.0; J],
            paw: 0.0,
            search: None,
        }
    }

    /// Moves leg `number` on by one sampling time.
    ///
    /// # Errors
    /// The errors of its drive.
    pub(super) fn advance(&mut self, number: u8, cycle: &CycleParams) -> Result<(), Fault> {
        let room;
        let model = if self.switches.has_outside() {
            room = self.room();
            &room
        } else {
            &self.model
        };
        let leg = MovingLeg {
            number,
            model,
            params: &self.params,
            measured: &self.angles,
        };
        self.drive.advance(&leg, cycle)
    }

    /// Returns the leg where it is measured.
    pub(super) fn chain(&self) -> Chain<J> {
        Chain::new(&self.model, &self.angles)
    }

    /// Returns the measured place of one of its points, mm.
    pub(super) fn place(&self, point: LegPoint, inverse: Inverse) -> Result<Point, Fault> {
        let place = self.chain().point(point).ok_or(Fault::Domain)?;
        Ok(inverse.flat(place))
    }

    /// Returns a point's target, or where the point is if it has none, mm.
    pub(super) fn target(&self, point: LegPoint, inverse: Inverse) -> Result<Point, Fault> {
        let own = self.drive.own_point(point);
        match own.and_then(|track| track.goal().target()) {
            Some(target) => Ok(target),
            None => self.place(point, inverse),
        }
    }

    /// Returns the angles at which its joints stay where they are: those measured, but within the
    /// working limits. A joint that new limits left outside may stay there.
    pub(super) fn stays(&self) -> [f64; J] {
        let mut stays = self.model.within_limits(&self.angles);
        if self.switches.has_outside() {
            let joints = self.switches.outside.iter().zip(&self.angles);
            for (stay, (outside, angle)) in stays.iter_mut().zip(joints) {
                if *outside {
                    *stay = *angle;
                }
            }
        }
        stays
    }

    /// Returns the joints' set points, in the motion that the leg is commanded now. Joints that
    /// served a point are to stay where they are measured.
    pub(super) fn joints(&self, inverse: Inverse) -> [Track<1>; J] {
        self.drive.joints(&self.model, &self.stays(), inverse)
    }

    /// Returns the commands of its joints, vibrations included.
    pub(super) fn outputs(&self, robot: &ModelFacts<'_>) -> [JointCommand; J] {
        let mut commands = self.drive.outputs();
        let Some(per_volt) = robot.vibration else {
            return commands;
        };
        let joints = self.model.joints.iter().zip(&self.params.joints);
        let states = self.vibrations.iter().zip(&self.angles);
        for (command, ((joint, params), (vibration, measured))) in
            commands.iter_mut().zip(joints.zip(states))
        {
            let state = VibrationContext {
                per_volt,
                most_torque: params.most_torque(joint, robot.torque_unit()),
                measured: *measured,
            };
            *command = vibration.vibrated(*command, joint, &state);
        }
        commands
    }
}
