//! The controller, which turns commands into joint angles: control modes, trajectories, parameters, limits.
//!
//! A control cycle calls [`sense`](Controller::sense), then at most one [`command`](Core::command), then
//! [`advance`](Core::advance), and sends the [`outputs`](Controller::outputs). All other methods are queries.
//!
//! Moves head straight for their targets under V_MAX and A_MAX, or OMEGA_MAX and OMEGA_DOT_MAX, and keep their velocity
//! when a command changes their goal. Velocity and angular-velocity control obey the limits of acceleration only. Where
//! a leg cannot go on it stops immediately: an emergency under EMG_ON; under EMG_OFF it stays there until it is sent
//! elsewhere.
//!
//! Modes are kept per leg and joint. Nothing is controlled at the start: the servos hold the
//! initial posture.
//!
//! A robot whose model has [`Forces`](crate::model::Forces) takes commands of torque, force and
//! compliance as well: joints are then commanded torques in place of angles. A spring's set point moves
//! as that of a move does; what it pulls goes where the forces lead it. ALL_STOP holds such joints by
//! angle where they are. No joint is pushed beyond its working limit.
//!
//! Native code may let joints vibrate. The vibration is added to the final joint command: set points,
//! and thus INPOS and NEAR, ignore it.
//!
//! A joint that has 10 deg to go with 360 deg/s² does not reach its 90 deg/s: it speeds up for half of the turn and slows
//! down for the other half, √(4 · 10 / 360) = ⅓ s in all.
//!
//! ```
//! use tip_runtime::command::{Command, Op, Poll, Target, Value};
//! use tip_runtime::controller::Controller;
//! use tip_runtime::hardware::Sensors;
//! use tip_runtime::model::titan8;
//!
//! let mut controller = Controller::new(&titan8::MODEL);
//! let angles = titan8::MODEL.legs.map(|leg| leg.initial);
//! controller.sense(&Sensors { angles, ..Sensors::ZERO })?;
//! let turn = Command {
//!     op: Op::PtpAngle,
//!     hs: false,
//!     target: Target::Joint(1, 1),
//!     values: &[Value::Absolute(10.0)],
//! };
//! assert_eq!(controller.command(&turn)?, Poll::Done);
//!
//! let mut commanded = [0.0; 17];
//! for angle in &mut commanded {
//!     controller.advance();
//!     *angle = controller.outputs()[0][0].value();
//! }
//! // 20 ms a cycle: ½ · 360 · 0.16² after 8 of them, there after 17.
//! assert!((commanded[7] - 4.608).abs() < 1e-9);
//! assert!(commanded[15] < 10.0 && (commanded[16] - 10.0).abs() < 1e-9);
//! # Ok::<(), tip_runtime::fault::Fault>(())
//! ```

mod arrival;
mod detection;
mod drive;
mod force;
mod leg;
mod motion;
mod native;
mod params;
mod sensing;
mod setpoints;
mod stop;
mod switches;
mod targets;
mod task;
mod trajectory;

pub use setpoints::{Mode, Setpoint};

use crate::command::{Command, Op, Poll};
use crate::fault::Fault;
use crate::hardware::{JointCommand, Sensors};
use crate::model::{Family, Joint, Leg, Model, ModelFacts, Point};
use core::ops::{Deref, DerefMut};
use drive::CycleParams;
use leg::LegState;
use params::Params;
use stop::Hold;
use targets::Base;
use task::Tasks;
use trajectory::SetPoint;

/// The controller of a robot with `L` legs of `J` joints: everything that a [`ControllerView`] can do.
#[derive(Clone, Debug)]
pub struct Controller<const L: usize, const J: usize> {
    core: Core<[LegState<J>; L]>,
}

/// The controller of a robot with any number of legs of `J` joints. A [`Controller`] dereferences to it
/// as an array coerces to a slice, so that one of each `J` is compiled, whatever the number of legs.
pub type ControllerView<const J: usize> = Core<[LegState<J>]>;

/// A controller over its legs: an array of them, or a slice.
#[derive(Clone, Debug)]
pub struct Core<S: ?Sized> {
    robot: ModelFacts,
    params: Params,
    /// Set point of the slider, mm.
    slider: SetPoint<3>,
    /// Measured place of the slider, mm.
    slider_at: Point,
    /// True once joint angles have been measured.
    sensed: bool,
    hold: Hold,
    pub(crate) tasks: Tasks,
    /// Fault of the last advance, for the next sense to report.
    pending: Option<Fault>,
    legs: S,
}

impl<const L: usize, const J: usize> Controller<L, J> {
    /// Creates a robot in its initial posture with nothing controlled and standard parameters.
    #[must_use]
    pub fn new(model: &Model<L, J>) -> Self {
        let robot = ModelFacts::of(model);
        let core = Core::resting(robot).with([LegState::new(Leg::BLANK, &robot); L]);
        let mut controller = Controller { core };
        controller.put_legs(&model.legs);
        controller
    }

    /// Returns the command of every joint.
    #[must_use]
    pub fn outputs(&self) -> [[JointCommand; J]; L] {
        let mut outputs = [[JointCommand::at(0.0); J]; L];
        self.put_outputs(&mut outputs);
        outputs
    }

    /// Takes the readings of the sensors.
    ///
    /// # Errors
    /// An invalid reading of a joint sensor; a joint beyond the limits of its potentiometer, or under EMG_ON
    /// beyond its working limits; the fault of the last advance.
    pub fn sense(&mut self, sensors: &Sensors<L, J>) -> Result<(), Fault> {
        (**self).sense_view(&sensors.view())
    }
}

impl<const L: usize, const J: usize> Deref for Controller<L, J> {
    type Target = ControllerView<J>;

    fn deref(&self) -> &Self::Target {
        &self.core
    }
}

impl<const L: usize, const J: usize> DerefMut for Controller<L, J> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.core
    }
}

impl Core<()> {
    /// Returns the part of a controller that does not depend on the legs, with nothing controlled.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn resting(robot: ModelFacts) -> Self {
        let slider = robot.slider.map_or([0.0; 3], |slider| slider.initial);
        Core {
            robot,
            params: Params::standard(&robot),
            slider: SetPoint::resting(slider),
            slider_at: slider,
            sensed: false,
            hold: Hold::Off,
            tasks: Tasks::NONE,
            pending: None,
            legs: (),
        }
    }

    /// Adds the legs. Only this function is compiled for each number of legs.
    fn with<S>(self, legs: S) -> Core<S> {
        Core {
            robot: self.robot,
            params: self.params,
            slider: self.slider,
            slider_at: self.slider_at,
            sensed: self.sensed,
            hold: self.hold,
            tasks: self.tasks,
            pending: self.pending,
            legs,
        }
    }
}

impl<const J: usize> ControllerView<J> {
    /// Puts every leg in its initial posture.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn put_legs(&mut self, models: &[Leg<J>]) {
        for (leg, model) in self.legs.iter_mut().zip(models) {
            *leg = LegState::new(model, &self.robot);
        }
    }

    /// Returns the sampling time, ms.
    #[must_use]
    pub const fn period(&self) -> f64 {
        self.params.period
    }

    /// Returns the facts of the model that hold for the whole robot.
    pub(crate) const fn robot(&self) -> &ModelFacts {
        &self.robot
    }

    /// Returns a joint's model, with the working limits in force; leg and joint count from 0.
    pub(crate) fn joint(&self, leg: usize, joint: usize) -> Option<&Joint> {
        self.legs.get(leg)?.model.joints.get(joint)
    }

    /// Writes the command of every joint, leg by leg.
    pub(crate) fn put_outputs(&self, outputs: &mut [[JointCommand; J]]) {
        for (outputs, leg) in outputs.iter_mut().zip(&self.legs) {
            *outputs = leg.outputs(&self.robot);
        }
    }

    /// Returns the commanded place of the slider, mm; zeros without a slider.
    #[must_use]
    pub const fn slider(&self) -> Point {
        self.slider.position()
    }

    /// Returns the number of legs.
    pub(crate) fn count(&self) -> u8 {
        u8::try_from(self.legs.len()).unwrap_or(u8::MAX)
    }

    fn leg(&self, n: u8) -> Result<&LegState<J>, Fault> {
        self.legs.get(targets::index(n)).ok_or(Fault::Domain)
    }

    /// Starts or continues a command. A command that answers `Pending` is asked again, unchanged,
    /// in each cycle until it is done.
    ///
    /// The controller refuses commands of the console, lamps and logs, and SPECIAL, by `Domain`.
    ///
    /// # Errors
    /// The fault of the command, which then had no effect.
    pub fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        if is_of_force(command.op) && self.robot.forces.is_none() {
            return Err(Fault::Domain);
        }
        if let Some(set) = self.set_parameter(command) {
            return set.map(|()| Poll::Done);
        }
        let family = self.robot.family;
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
            Op::InitialPosture => return self.initial_posture(),
            Op::StandUp if family == Family::Titan => return self.stand(command, -1.0),
            Op::SitDown if family == Family::Titan => return self.stand(command, 1.0),
            Op::DetectFloor if family == Family::Titan => {
                return self.detect_floor_by_soles(command);
            }
            Op::DetectFloor if family == Family::Hand => {
                return self.detect_touch(command, Self::floor_search);
            }
            Op::DetectObject if family == Family::Hand => {
                return self.detect_touch(command, Self::object_search);
            }
            Op::Direct => self.switch_direct(command.target, true)?,
            Op::Trajectory => self.switch_direct(command.target, false)?,
            Op::Lock => self.switch_lock(command.target, true)?,
            Op::Unlock => self.switch_lock(command.target, false)?,
            Op::SetLimit => self.set_limits(command)?,
            Op::ResetLimit => self.reset_limits(command.target)?,
            Op::Sleep => return self.sleep(command),
            Op::WaitInpos => return Ok(self.wait_inpos(command.target)),
            Op::WaitNear => return self.wait_near(command.target),
            _ => return Err(Fault::Domain),
        }
        Ok(Poll::Done)
    }

    /// Advances every joint command by one sampling time. A fault is reported by the next [`sense`](Controller::sense).
    pub fn advance(&mut self) {
        let dt = self.params.period / 1000.0;
        let cycle = CycleParams {
            inverse: self.robot.inverse,
            torque_unit: self.robot.torque_unit(),
            dt,
            per_second: if dt > 0.0 { 1.0 / dt } else { 0.0 },
            held: self.hold.is_on(),
        };
        for (n, leg) in self.legs.iter_mut().enumerate() {
            if let (Err(fault), true) = (leg.advance(targets::number(n), &cycle), self.params.emg) {
                self.pending.get_or_insert(fault);
            }
        }
        self.slider
            .advance(self.params.slider.limits(), dt, self.hold.is_on());
        self.advance_vibrations(dt);
        self.end_if_finished();
    }
}

/// Returns true for commands of torque, force and compliance.
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
