//! From commands to joint angles: control modes, trajectories, parameters, limits.
//!
//! A control cycle calls [`sense`](Controller::sense), then at most one
//! [`command`](Controller::command), then [`advance`](Controller::advance), and sends the
//! [`outputs`](Controller::outputs). Everything else answers questions.
//!
//! Moves head straight for their targets under V_MAX and A_MAX, or OMEGA_MAX and OMEGA_DOT_MAX,
//! and keep their velocity when a command changes their goal. Velocity and angular-velocity
//! control obey the limits of acceleration only. Where a leg cannot go on it stops at once: an
//! emergency under EMG_ON; under EMG_OFF it stays there until it is sent elsewhere.
//!
//! Modes are kept per leg and joint. Nothing is controlled at the start: the servos hold the
//! initial posture.
//!
//! A robot whose model has [`Forces`](crate::model::Forces) takes commands of torque, force and
//! compliance as well: joints are then told torques in place of angles. A spring's set point moves
//! as that of a move does; what it pulls goes where the forces lead it. ALL_STOP holds such joints by
//! angle where they are. No joint is pushed beyond its working limit.
//!
//! Native code may let joints vibrate. That is added to what they are told in the end: set points,
//! and thus INPOS and NEAR, know nothing of it.

mod arrival;
mod detect;
mod drive;
mod feel;
mod force;
mod motion;
mod native;
mod operands;
mod params;
mod posture;
mod sleep;
mod stand;
mod stop;
mod targets;
mod task;
mod teach;
mod trajectory;
mod vibrate;
mod watch;

use crate::command::{Command, Op, Poll};
use crate::fault::Fault;
use crate::hardware::{JointCommand, Sensors};
use crate::model::{Family, Model};
use drive::{Going, LegDrive};
use operands::Base;
use params::Params;
use stop::Hold;
use task::Task;
use trajectory::Track;
use vibrate::Shaker;

/// The controller of a robot with `L` legs of `J` joints.
#[derive(Clone, Debug)]
pub struct Controller<'m, const L: usize, const J: usize> {
    model: &'m Model<L, J>,
    params: Params<L, J>,
    drives: [LegDrive<J>; L],
    measured: Sensors<L, J>,
    /// Where the slider is to stand: mm.
    slider: Track<3>,
    /// Measured joint rates: deg/s.
    rates: [[f64; J]; L],
    /// Whether joint angles have been measured yet.
    sensed: bool,
    hold: Hold,
    shakers: [[Shaker; J]; L],
    task: Task<L>,
    /// What arose in the last advance, to be reported by the next sense.
    pending: Option<Fault>,
}

impl<'m, const L: usize, const J: usize> Controller<'m, L, J> {
    /// A robot in its initial posture with nothing controlled and standard parameters.
    #[must_use]
    pub fn new(model: &'m Model<L, J>) -> Self {
        let initial = model.legs.map(|leg| leg.initial);
        let slider = model.slider.map_or([0.0; 3], |slider| slider.initial);
        Controller {
            model,
            params: Params::standard(model),
            drives: initial.map(LegDrive::free),
            measured: Sensors {
                angles: initial,
                slider,
                ..Sensors::ZERO
            },
            slider: Track::resting(slider),
            rates: [[0.0; J]; L],
            sensed: false,
            hold: Hold::Off,
            shakers: [[Shaker::STILL; J]; L],
            task: Task::Idle,
            pending: None,
        }
    }

    /// The robot that is controlled.
    #[must_use]
    pub const fn model(&self) -> &'m Model<L, J> {
        self.model
    }

    /// The sampling time: ms.
    #[must_use]
    pub const fn period(&self) -> f64 {
        self.params.period
    }

    /// What every joint is told.
    #[must_use]
    pub fn outputs(&self) -> [[JointCommand; J]; L] {
        self.shaken(self.drives.each_ref().map(LegDrive::outputs))
    }

    /// How many of the robot's torque unit one N·m is.
    fn torque_unit(&self) -> f64 {
        let forces = self.model.forces.as_ref();
        forces.map_or(1.0, |forces| forces.unit.per_newton_metre())
    }

    /// Where the slider is told to stand: mm; zeros where there is none.
    #[must_use]
    pub const fn slider(&self) -> [f64; 3] {
        self.slider.position()
    }

    /// Starts or continues a command. A command that answers `Pending` is asked again, unchanged,
    /// in each cycle until it is done.
    ///
    /// Commands of the console, lamps and logs, and SPECIAL, are not the controller's: `Domain`.
    ///
    /// # Errors
    /// The fault of the command, which then had no effect.
    pub fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        if is_of_force(command.op) && self.model.forces.is_none() {
            return Err(Fault::Domain);
        }
        if let Some(set) = self.set_parameter(command) {
            return set.map(|()| Poll::Done);
        }
        let family = self.model.family;
        match command.op {
            Op::Ptp => self.move_point(command, Base::Operand)?,
            Op::RelPtp => self.move_point(command, Base::Target)?,
            Op::PtpAngle => self.move_joints(command, Base::Operand)?,
            Op::RelPtpAngle => self.move_joints(command, Base::Target)?,
            Op::VelControl => self.drive_foot(command)?,
            Op::OmegaControl => self.drive_joints(command)?,
            Op::Torque => self.torque(command)?,
            Op::Force => self.force(command)?,
            Op::ComplianceAngle => self.soften_joints(command, Base::Operand)?,
            Op::RelComplianceAngle => self.soften_joints(command, Base::Target)?,
            Op::CompliancePosition => self.soften_point(command, Base::Operand)?,
            Op::RelCompliancePosition => self.soften_point(command, Base::Target)?,
            Op::NoCompliance => self.stiffen(command.target)?,
            Op::AllStop => self.hold(),
            Op::AllStopRelease => self.release(),
            Op::InitialPosture => return Ok(self.initial_posture()),
            Op::StandUp if family == Family::Titan => return self.stand(command, -1.0),
            Op::SitDown if family == Family::Titan => return self.stand(command, 1.0),
            Op::DetectFloor if family == Family::Titan => {
                return self.detect_floor_by_soles(command);
            }
            Op::DetectFloor if family == Family::Hand => {
                return self.feel(command, Self::floor_search);
            }
            Op::DetectObject if family == Family::Hand => {
                return self.feel(command, Self::object_search);
            }
            Op::Sleep => return self.sleep(command),
            Op::WaitInpos => return Ok(self.wait_inpos(command.target)),
            Op::WaitNear => return self.wait_near(command.target),
            _ => return Err(Fault::Domain),
        }
        Ok(Poll::Done)
    }

    /// Moves every joint command on by one sampling time. What goes wrong is reported by the next
    /// [`sense`](Self::sense).
    pub fn advance(&mut self) {
        let dt = self.params.period / 1000.0;
        let torque_unit = self.torque_unit();
        let legs = self.model.legs.iter().zip(&mut self.drives);
        let params = self.params.feet.iter().zip(&self.params.joints);
        let states = params.zip(&self.measured.angles);
        for (n, ((leg, drive), ((foot, joints), measured))) in legs.zip(states).enumerate() {
            let going = Going {
                inverse: self.model.inverse,
                torque_unit,
                number: targets::number(n),
                dt,
                held: self.hold.is_on(),
                measured,
                foot,
                joints,
            };
            if let (Err(fault), true) = (drive.advance(leg, &going), self.params.emg) {
                self.pending.get_or_insert(fault);
            }
        }
        self.slider
            .advance(self.params.slider.limits(), dt, self.hold.is_on());
        self.shake(dt);
        self.end_if_finished();
    }
}

/// Commands of torque, force and compliance.
const fn is_of_force(op: Op) -> bool {
    matches!(
        op,
        Op::Torque
            | Op::Force
            | Op::ComplianceAngle
            | Op::RelComplianceAngle
            | Op::CompliancePosition
            | Op::RelCompliancePosition
            | Op::NoCompliance
            | Op::SetTorqueMax
            | Op::SetTorqueMaxRate
            | Op::SetTorqueMaxSoft
            | Op::SetTorqueMaxFirmly
            | Op::SetTorqueMaxNormal
            | Op::SetAngleStiffness
            | Op::SetPositionStiffness
            | Op::SetComplianceTorqueLimit
            | Op::ResetComplianceTorqueLimit
            | Op::SetComplianceForceLimit
            | Op::ResetComplianceForceLimit
            | Op::DetectObject
    )
}
