//! Commands of several cycles and their state: INITIAL_POSTURE (T.I.P. 3.1 §7-1-7), and STAND_UP and SIT_DOWN (§7-11-1,
//! §7-11-2), in which the feet push the body up or let it down.

use super::ControllerView;
use super::drive::{Drive, Redundancy};
use super::targets::unlocked;
use super::trajectory::Goal;
use crate::command::{Command, Poll, Target};
use crate::fault::Fault;
use crate::kinematics::{Chain, LegPoint};
use crate::model::Point;
use crate::program::THREADS;

/// The command in progress. Only one of these commands can run at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task {
    /// None.
    Idle,
    /// INITIAL_POSTURE: it brakes; true if this command holds the robot.
    Posture(bool),
    /// STAND_UP and SIT_DOWN.
    Stand(Stand),
    /// DETECT_FLOOR by soles.
    DetectFloor(FloorSearch),
    /// DETECT_FLOOR and DETECT_OBJECT by touch.
    DetectTouch,
}

/// Phase of STAND_UP or SIT_DOWN.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stand {
    /// The feet come to rest where they are.
    Settling,
    /// The feet move.
    Moving,
}

/// The operand of DETECT_FLOOR by soles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FloorSearch {
    /// One leg after the other goes down.
    DownInTurn,
    /// All legs go down together.
    DownTogether,
    /// All legs go up: the body sinks.
    Up,
}

/// The commands of several cycles that the main program (0) and threads are running.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tasks {
    /// The thread that runs a step now.
    thread: u8,
    task: Task,
    /// The thread that runs the task.
    owner: u8,
    /// The thread that runs SPECIAL.
    special: Option<u8>,
    /// The remaining cycles of SLEEP of each thread; 0 if it does not sleep.
    sleeps: [f64; THREADS + 1],
}

impl Tasks {
    pub(super) const NONE: Self = Tasks {
        thread: 0,
        task: Task::Idle,
        owner: 0,
        special: None,
        sleeps: [0.0; THREADS + 1],
    };

    /// Sets the thread that runs a step; 0 is the main program.
    pub(crate) fn select(&mut self, thread: u8) {
        self.thread = thread;
    }

    /// Returns the task of the current thread.
    pub(super) fn current(&self) -> Task {
        if self.owner == self.thread {
            self.task
        } else {
            Task::Idle
        }
    }

    /// Checks that the current thread may begin or continue a task or SPECIAL.
    ///
    /// # Errors
    /// `InvalidMode` while another thread runs a task or SPECIAL.
    pub(crate) fn begin(&self) -> Result<(), Fault> {
        let another = self.task != Task::Idle && self.owner != self.thread;
        if another || self.special.is_some_and(|special| special != self.thread) {
            return Err(Fault::InvalidMode);
        }
        Ok(())
    }

    /// Sets the task of the current thread.
    pub(super) fn set(&mut self, task: Task) {
        (self.task, self.owner) = (task, self.thread);
    }

    /// Ends the task or SPECIAL of the current thread.
    pub(super) fn give_up(&mut self) {
        if self.owner == self.thread {
            self.task = Task::Idle;
        }
        self.special = self.special.filter(|special| *special != self.thread);
    }

    /// Records that the current thread waits in SPECIAL, or has finished it.
    pub(crate) fn set_special(&mut self, waits: bool) {
        self.special = waits.then_some(self.thread);
    }

    /// Returns the remaining cycles of SLEEP of the current thread.
    pub(super) fn sleep(&mut self) -> Option<&mut f64> {
        self.sleeps.get_mut(usize::from(self.thread))
    }
}

impl<const J: usize> ControllerView<J> {
    /// Brakes, then sets off for the initial posture with standard parameters.
    ///
    /// # Errors
    /// `InvalidMode` while another thread runs a command of this kind.
    pub(super) fn initial_posture(&mut self) -> Result<Poll, Fault> {
        let holds = match self.tasks.current() {
            Task::Posture(holds) => {
                self.hold();
                holds
            }
            _ => {
                self.tasks.begin()?;
                self.take_hold()
            }
        };
        if !self.is_at_rest() {
            self.tasks.set(Task::Posture(holds));
            return Ok(Poll::Pending);
        }
        self.tasks.set(Task::Idle);
        self.standardise();
        let inverse = self.robot.inverse;
        for leg in &mut self.legs {
            let initial = Chain::new(&leg.model, &leg.model.initial);
            let target = inverse.flat(initial.foot());
            let foot = leg.drive.point(LegPoint::Tip, &leg.model, inverse);
            let line = (foot.position(), target);
            let home = Some(leg.model.initial);
            leg.drive.redundancy = Redundancy::seek(
                inverse,
                &leg.model,
                LegPoint::Tip,
                &leg.drive.angles,
                line,
                home,
            );
            leg.drive.drive = Drive::Foot(foot.towards(Goal::Point { target, hs: false }));
        }
        if let Some(slider) = self.robot.slider {
            self.slider = self.slider.towards(Goal::Point {
                target: slider.initial,
                hs: false,
            });
        }
        self.release();
        Ok(Poll::Done)
    }
}

/// V_MAX during the move, as a share of its standard value (SLOW).
const SLOW: f64 = 0.5;

impl<const J: usize> ControllerView<J> {
    /// Moves every foot by the operand times `direction` along z.
    pub(super) fn stand(&mut self, command: &Command<'_>, direction: f64) -> Result<Poll, Fault> {
        let [height] = command.values else {
            return Err(Fault::Domain);
        };
        let rise = direction * height.number();
        let stage = match self.tasks.current() {
            Task::Stand(stage) => stage,
            _ => {
                self.tasks.begin()?;
                self.settle(rise)?;
                Stand::Settling
            }
        };
        match stage {
            _ if !self.inpos(Target::All) => self.tasks.set(Task::Stand(stage)),
            Stand::Settling => {
                self.shift_feet(rise)?;
                self.set_all_v_max(SLOW);
                self.tasks.set(Task::Stand(Stand::Moving));
            }
            Stand::Moving => {
                self.set_all_v_max(1.0);
                self.tasks.set(Task::Idle);
                return Ok(Poll::Done);
            }
        }
        Ok(Poll::Pending)
    }

    /// Puts every foot under position control where it comes to rest, if it can rise from there.
    ///
    /// # Errors
    /// `InvalidMode` while a torque, force or spring decides about any joint, or one is locked;
    /// `OutOfReach`.
    fn settle(&mut self, rise: f64) -> Result<(), Fault> {
        if self.legs.iter().any(|leg| leg.drive.is_soft()) {
            return Err(Fault::InvalidMode);
        }
        self.require_unlocked_feet()?;
        for n in 1..=self.count() {
            let raised = raised(self.foot_rest_point(n)?, rise)?;
            self.require_reach(n, LegPoint::Tip, raised)?;
        }
        for n in 1..=self.count() {
            self.send_foot(n, self.foot_rest_point(n)?, false)?;
        }
        Ok(())
    }

    fn shift_feet(&mut self, rise: f64) -> Result<(), Fault> {
        self.require_unlocked_feet()?;
        for n in 1..=self.count() {
            let target = raised(self.point_target(n, LegPoint::Tip)?, rise)?;
            self.send_foot(n, target, false)?;
        }
        Ok(())
    }

    fn require_unlocked_feet(&self) -> Result<(), Fault> {
        unlocked(self.legs.iter().any(|leg| leg.switches.has_locked()))
    }
}

fn raised([x, y, z]: Point, rise: f64) -> Result<Point, Fault> {
    Ok([x, y, crate::ops::add(z, rise)?])
}
