//! The state that a command of several cycles keeps between them.

use crate::fault::Fault;
use crate::program::THREADS;

/// The command in progress, of those of which there is one at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task {
    /// None.
    Idle,
    /// INITIAL_POSTURE: braking; true if it is what holds the robot.
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
    /// All legs go down at once.
    DownTogether,
    /// All legs go up: the body sinks.
    Up,
}

/// The commands of several cycles in which the main program (0) and threads stand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tasks {
    /// The one that runs a step.
    thread: u8,
    task: Task,
    /// The one that stands in the task.
    owner: u8,
    /// The one that stands in SPECIAL.
    special: Option<u8>,
    /// The cycles of SLEEP that are left; 0 for who does not sleep.
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

    /// Lets the main program (0) or a thread run a step.
    pub(super) fn select(&mut self, thread: u8) {
        self.thread = thread;
    }

    /// Returns the task that who runs a step stands in.
    pub(super) fn current(&self) -> Task {
        if self.owner == self.thread {
            self.task
        } else {
            Task::Idle
        }
    }

    /// Checks that a task may begin.
    ///
    /// # Errors
    /// `InvalidMode` while another stands in a task or in SPECIAL.
    pub(super) fn begin(&self) -> Result<(), Fault> {
        let another = self.task != Task::Idle && self.owner != self.thread;
        if another || self.special.is_some_and(|special| special != self.thread) {
            return Err(Fault::InvalidMode);
        }
        Ok(())
    }

    /// Sets the task of who runs a step.
    pub(super) fn set(&mut self, task: Task) {
        (self.task, self.owner) = (task, self.thread);
    }

    /// Ends the task or SPECIAL that who runs a step stands in.
    pub(super) fn give_up(&mut self) {
        if self.owner == self.thread {
            self.task = Task::Idle;
        }
        self.special = self.special.filter(|special| *special != self.thread);
    }

    /// Notes that who runs a step stands in SPECIAL, or has done it.
    pub(super) fn set_special(&mut self, waits: bool) {
        self.special = waits.then_some(self.thread);
    }

    /// Returns the cycles of SLEEP that are left for who runs a step.
    pub(super) fn sleep(&mut self) -> Option<&mut f64> {
        self.sleeps.get_mut(usize::from(self.thread))
    }
}
