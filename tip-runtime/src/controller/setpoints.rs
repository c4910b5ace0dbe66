//! A readable view of the set points of every leg.

use super::drive::{Drive, THIRD};
use super::leg::LegState;
use super::trajectory::{Goal, SetPoint};
use super::{ControllerView, targets};
use crate::command::Target;
use crate::model::Range;

/// Control mode of a foot or joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// No control: it stays where it is.
    Rest,
    /// Control of position or angle: it heads for a target.
    Position,
    /// A spring pulls it to a position or angle.
    Compliance,
    /// Control of velocity or angular velocity, which it keeps.
    Velocity,
    /// Control of force or torque.
    Effort,
}

/// Control mode and target of a foot, a joint or the slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setpoint {
    /// The foot, the joint or the slider.
    pub of: Target,
    /// The control mode.
    pub mode: Mode,
    goal: [f64; 3],
    axes: usize,
}

impl Setpoint {
    fn of_track<const N: usize>(of: Target, track: &SetPoint<N>) -> Self {
        let (mode, goal) = match track.goal() {
            Goal::Rest => (Mode::Rest, None),
            Goal::Point { target, .. } => (Mode::Position, Some(target)),
            Goal::Spring { target, .. } => (Mode::Compliance, Some(target)),
            Goal::Speed(velocity) => (Mode::Velocity, Some(velocity)),
            Goal::Effort(effort) => (Mode::Effort, Some(effort)),
        };
        let mut setpoint = Setpoint {
            of,
            mode,
            goal: [0.0; 3],
            axes: goal.map_or(0, |goal| goal.len().min(3)),
        };
        for (place, value) in setpoint.goal.iter_mut().zip(goal.iter().flatten()) {
            *place = *value;
        }
        setpoint
    }

    /// Its target: three numbers of a foot or the slider, one of a joint, none at rest. Positions are mm and deg, velocities
    /// mm/s and deg/s, efforts N and the robot's torque unit.
    #[must_use]
    pub fn goal(&self) -> &[f64] {
        self.goal.get(..self.axes).unwrap_or(&[])
    }
}

impl<const J: usize> ControllerView<J> {
    /// Iterates over the set points of every leg, F1 first: that of its foot, if that is controlled, or else those of
    /// its joints; then that of the slider, if there is one.
    pub fn setpoints(&self) -> impl Iterator<Item = Setpoint> {
        let legs = self.legs.iter().enumerate();
        let legs = legs.flat_map(|(index, leg)| of_leg(targets::number(index), leg));
        let slider = self.robot.slider.is_some();
        let slider = slider.then(|| Setpoint::of_track(Target::Floor, &self.slider));
        legs.chain(slider)
    }

    /// Iterates over the working limits in force of every joint, leg by leg, deg (SET_LIMIT).
    pub fn limits(&self) -> impl Iterator<Item = Range> {
        let joints = self.legs.iter().flat_map(|leg| &leg.model.joints);
        joints.map(|joint| joint.limits)
    }

    /// Iterates over the locked joints of every leg, F1 first (LOCK).
    pub fn locked(&self) -> impl Iterator<Item = Target> {
        let legs = self.legs.iter().enumerate();
        legs.flat_map(|(index, leg)| {
            let locked = (0..J).filter(|joint| leg.switches.is_locked(*joint));
            let n = targets::number(index);
            locked.map(move |joint| Target::Joint(n, targets::number(joint)))
        })
    }
}

fn of_leg<const J: usize>(n: u8, leg: &LegState<J>) -> impl Iterator<Item = Setpoint> {
    let point = match &leg.drive.drive {
        Drive::Joints(_) => None,
        Drive::Foot(foot) => Some(Setpoint::of_track(Target::Foot(n), foot)),
        Drive::Third(third, _) => {
            let joint = Target::Joint(n, targets::number(THIRD));
            Some(Setpoint::of_track(joint, third))
        }
    };
    let (first, joints) = leg.drive.own_joints();
    let joints = (first..).zip(joints).map(move |(index, joint)| {
        Setpoint::of_track(Target::Joint(n, targets::number(index)), joint)
    });
    point.into_iter().chain(joints)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::{Mode, Target};
    use crate::command::{Command, Op, Value};
    use crate::controller::Controller;
    use crate::hardware::Sensors;
    use crate::model::titan8;
    use std::vec;
    use std::vec::Vec;

    #[test]
    fn aims_are_what_commands_asked_for() {
        let mut controller = Controller::new(&titan8::MODEL);
        let angles = titan8::MODEL.legs.map(|leg| leg.initial);
        let sensed = controller.sense(&Sensors {
            angles,
            ..Sensors::ZERO
        });
        assert_eq!(sensed, Ok(()));
        assert_eq!(controller.setpoints().count(), 12);
        assert!(
            controller
                .setpoints()
                .all(|setpoint| setpoint.mode == Mode::Rest && setpoint.goal().is_empty())
        );
        for (op, target, values) in [
            (Op::PtpAngle, Target::Joint(1, 2), &[10.0][..]),
            (Op::OmegaControl, Target::Joint(1, 1), &[-3.0]),
            (Op::VelControl, Target::Foot(2), &[1.0, 2.0, 3.0]),
        ] {
            let values: Vec<Value> = values.iter().copied().map(Value::Absolute).collect();
            let done = controller.command(&Command {
                op,
                hs: false,
                target,
                values: &values,
            });
            assert!(done.is_ok(), "{op:?}");
        }
        let setpoints: Vec<_> = controller.setpoints().collect();
        let shown = |place: usize| {
            (
                setpoints[place].of,
                setpoints[place].mode,
                setpoints[place].goal().to_vec(),
            )
        };
        assert_eq!(shown(0), (Target::Joint(1, 1), Mode::Velocity, vec![-3.0]));
        assert_eq!(shown(1), (Target::Joint(1, 2), Mode::Position, vec![10.0]));
        // A leg whose foot is controlled has no joints of its own.
        assert_eq!(
            shown(3),
            (Target::Foot(2), Mode::Velocity, vec![1.0, 2.0, 3.0])
        );
        assert_eq!(setpoints.len(), 10);
    }
}
