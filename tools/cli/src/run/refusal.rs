//! Reasons why a command was refused that other parts of the program or of the robot explain: a thread that runs, a lock, a joint that
//! would turn too far.

use crate::message::Stopping;
use crate::run::emergency::{JointState, Stopped};
use tip_runtime::command::{Op, Target};
use tip_runtime::program::Program as _;
use tipc::message::Message;
use tipc::message::list::List;
use tipc::program::{Action, Argument, Mark, Operand, Step, StepId, Thread};

/// Distance from a limit up to which the joint is named as the one that ends a path, deg.
const NEAR: f64 = 3.0;

type Reason = (Message, Option<Message>);

impl Stopped<'_> {
    fn failed(&self) -> Option<&Step> {
        self.steps().get(self.emergency.step as usize)
    }

    fn steps(&self) -> &[Step] {
        self.program.program().steps()
    }

    /// Returns the thread that a step is of; none for the main program.
    fn thread_of(&self, step: StepId) -> Option<&Thread> {
        let mut threads = self.program.program().threads().iter();
        threads.find(|it| (it.first..=it.last).contains(&step))
    }

    /// Returns why a command does not fit the mode of its target, or the state of the threads.
    pub(super) fn refused_mode(&self) -> Reason {
        let found = self.failed().and_then(|step| match &step.action {
            Action::StartThread { thread } => self.running(*thread),
            Action::WaitThread { .. } => Some((Stopping::WaitsForItself.into(), None)),
            Action::Command { target, .. } => {
                self.lock(*target).or_else(|| self.occupied(&step.action))
            }
            _ => None,
        });
        found.unwrap_or((Stopping::OtherMode.into(), None))
    }

    fn running(&self, thread: usize) -> Option<Reason> {
        let name = &self.program.program().threads().get(thread)?.name;
        let number = u8::try_from(thread + 1).ok()?;
        let line = self.program.line(self.run.step_of(number));
        let name = || name.into();
        let reason = Stopping::Running { name: name(), line };
        Some((
            reason.into(),
            Some(Stopping::WaitFirst { name: name() }.into()),
        ))
    }

    /// Returns the first locked joint that a target concerns, and the LOCKs of the program that name it.
    fn lock(&self, target: Target) -> Option<Reason> {
        let locked = self.run.locked();
        let joint = locked.into_iter().find(|it| concerns(target, *it))?;
        let locks = (0..).zip(self.steps()).filter(|(_, step)| {
            matches!(&step.action, Action::Command { op: Op::Lock, target, .. } if concerns(*target, joint))
        });
        let locks: Vec<(StepId, &Step)> = locks.collect();
        let lines = List(
            locks
                .iter()
                .map(|(_, step)| step.line.to_string())
                .collect(),
        );
        let mut threads = locks.iter().map(|(step, _)| self.thread_of(*step));
        let first = threads.next()?;
        let owner = first.filter(|first| threads.all(|it| it == Some(first)));
        let reason = match owner {
            Some(thread) => {
                let name = (&thread.name).into();
                Stopping::LockedBy { joint, lines, name }
            }
            None => Stopping::Locked { joint, lines },
        };
        Some((reason.into(), Some(Stopping::Unlock { joint }.into())))
    }

    /// Returns the thread or main program that is executing a command of which only one can run at a time.
    fn occupied(&self, action: &Action) -> Option<Reason> {
        whole(action)?;
        let own = self.thread_of(self.emergency.step);
        let threads = self.program.program().threads();
        let all = [None].into_iter().chain(threads.iter().map(Some));
        let mut others = (0..).zip(all).filter(|(number, thread)| {
            *thread != own && (*number == 0 || self.run.thread_runs(*number))
        });
        others.find_map(|(number, thread)| {
            let step = self.steps().get(self.run.step_of(number) as usize)?;
            let (word, line) = (whole(&step.action)?.name(), step.line);
            let reason = match thread.map(|thread| (&thread.name).into()) {
                Some(name) => Stopping::OccupiedBy { word, line, name },
                None => Stopping::Occupied { word, line },
            };
            Some((reason.into(), None))
        })
    }

    /// Returns why a target, or the way to it, is out of reach.
    pub(super) fn out_of_reach(&self, target: Target) -> Reason {
        let found = self.destination(target).and_then(|(op, values)| {
            let limits = self.run.limits();
            self.robot.reason_out_of_reach(op, target, &values, &limits)
        });
        if let Some((reason, help)) = found {
            return (reason, Some(help));
        }
        let joints = self.joints_of(target);
        let reason = match self.nearest_limit(target) {
            Some((joint, by, limit)) => Stopping::OnTheWay {
                target,
                joint,
                by,
                limit,
            },
            None => Stopping::OutOfReach { target },
        };
        (reason.into(), joints)
    }

    /// Returns the numbers of the target of the motion that was refused, none of them relative.
    fn destination(&self, stopped: Target) -> Option<(Op, Vec<f64>)> {
        let Action::Command {
            op,
            target,
            arguments,
            ..
        } = &self.failed()?.action
        else {
            return None;
        };
        let (op, is_relative) = match op {
            Op::Ptp | Op::PtpAngle => (*op, false),
            Op::RelPtp => (Op::Ptp, true),
            Op::RelPtpAngle => (Op::PtpAngle, true),
            _ => return None,
        };
        if *target != stopped {
            return None;
        }
        // A motion that was refused leaves the leg where it is.
        let base = |index: usize| match (op, *target) {
            (Op::Ptp, Target::Foot(leg)) => {
                let leg = usize::from(leg).checked_sub(1)?;
                let limb = self.description.legs.get(leg)?;
                let angles = self.run.angles().get(leg * limb.joints.len()..)?;
                limb.foot(angles.get(..limb.joints.len())?)
                    .get(index)
                    .copied()
            }
            (Op::PtpAngle, Target::Foot(_) | Target::Joint(..)) => {
                let of_leg = |it: &JointState| concerns(*target, it.joint);
                self.joints().filter(of_leg).nth(index).map(|it| it.angle)
            }
            _ => None,
        };
        let value = |(index, argument): (usize, &Argument)| {
            let number = self.value(&argument.operand)?;
            match is_relative || argument.mark == Mark::Relative {
                true => Some(base(index)? + number),
                false => Some(number),
            }
        };
        let values: Option<Vec<f64>> = arguments.iter().enumerate().map(value).collect();
        Some((op, values?))
    }

    fn value(&self, operand: &Operand) -> Option<f64> {
        match operand {
            Operand::Constant(number) => Some(*number),
            Operand::Scalar { scalar, negative } => {
                let index = self.program.program().scalar_index(*scalar);
                let value = self.program.scalar(index)?.1?;
                Some(if *negative { -value } else { value })
            }
            _ => None,
        }
    }

    /// Returns the joint of a leg that is nearest to one of its limits, the distance and the limit, if it is near.
    fn nearest_limit(&self, target: Target) -> Option<(Target, f64, f64)> {
        let joints = self.joints().filter(|it| concerns(target, it.joint));
        let near = joints.flat_map(|it| {
            [it.min, it.max].map(|limit| (it.joint, (limit - it.angle).abs(), limit))
        });
        let nearest = near.min_by(|(_, one, _), (_, other, _)| one.total_cmp(other))?;
        let (joint, by, limit) = nearest;
        (by <= NEAR).then_some((joint, (by * 10.0).round() / 10.0, limit))
    }
}

/// Returns true if a command for a target concerns a joint.
fn concerns(target: Target, joint: Target) -> bool {
    match (target, joint) {
        (Target::All, _) => true,
        (Target::Foot(leg), Target::Joint(of, _)) => leg == of,
        (target, joint) => target == joint,
    }
}

/// Returns the command of an action, if it moves the whole robot and only one such command runs at a time.
fn whole(action: &Action) -> Option<Op> {
    match action {
        Action::Command {
            op:
                op @ (Op::InitialPosture
                | Op::StandUp
                | Op::SitDown
                | Op::DetectFloor
                | Op::DetectObject
                | Op::Special),
            ..
        } => Some(*op),
        _ => None,
    }
}
