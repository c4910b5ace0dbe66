//! Both sides of a comparison for each robot.

use crate::native::Native;
use crate::notes::Notes;
use crate::rig::Rig;
use crate::script::Script;
use crate::typist::Typist;
use tip_runtime::machine::{Emergency, Machine, Status};
use tip_runtime::model::{Model, generic, hand, titan8};
use tip_runtime::program::Program;
use tip_runtime::special::Special;
use tip_runtime::special::hand::HandSpecials;
use tipc::Robot;

/// One side of a comparison.
pub(crate) struct Side {
    pub(crate) notes: Notes,
    pub(crate) status: Status,
    pub(crate) emergency: Option<Emergency>,
    /// Hash of the console.
    pub(crate) shown: u64,
}

impl Side {
    pub(crate) fn new(steps: usize) -> Self {
        Side {
            notes: Notes::new(steps),
            status: Status::Running,
            emergency: None,
            shown: 0,
        }
    }

    /// Whether nothing tells it from the other side.
    pub(crate) fn equals(&self, other: &Side) -> bool {
        self.notes.hash == other.notes.hash
            && self.status == other.status
            && self.emergency == other.emergency
            && self.shown == other.shown
    }
}

/// Two sides that go on in lock-step.
pub(crate) trait Pair {
    /// One cycle of both sides; `false` when they differ or the run is over.
    fn cycle(&mut self, sides: &mut [Side; 2]) -> bool;
}

/// Both programs on robots of their own. `then` gets them, ready to run.
pub(crate) fn with_pair<'m, T>(
    robot: Robot,
    script: &'m Script,
    programs: [&'m mut dyn Program; 2],
    then: impl FnOnce(&mut dyn Pair) -> T,
) -> T {
    match robot {
        Robot::Titan8 => then(&mut pair(&titan8::MODEL, script, programs, Native::default)),
        Robot::Generic => then(&mut pair(
            &generic::MODEL,
            script,
            programs,
            Native::default,
        )),
        Robot::Hand => {
            let special = || HandSpecials::beside(Native::default());
            then(&mut pair(&hand::MODEL, script, programs, special))
        }
        Robot::Described(_) => unreachable!("random programs are for robots with names"),
    }
}

type Half<'m, S, const L: usize, const J: usize> =
    Machine<'m, &'m mut dyn Program, Rig<'m, L, J>, Typist<'m>, S, L, J>;

fn pair<'m, S: Special, const L: usize, const J: usize>(
    model: &'m Model<L, J>,
    script: &'m Script,
    programs: [&'m mut dyn Program; 2],
    special: fn() -> S,
) -> [Half<'m, S, L, J>; 2] {
    programs.map(|program| {
        let rig = Rig::new(model, script.scenery, &script.events);
        let console = Typist::new(&script.events);
        Machine::new(program, model, rig, console, special()).expect("a program for this robot")
    })
}

impl<S: Special, const L: usize, const J: usize> Pair for [Half<'_, S, L, J>; 2] {
    fn cycle(&mut self, sides: &mut [Side; 2]) -> bool {
        for (half, side) in self.iter_mut().zip(sides.iter_mut()) {
            side.status = half.cycle_traced(&mut side.notes);
            side.emergency = half.emergency().copied();
            side.shown = half.console().shown.value();
        }
        let [a, b] = sides;
        a.equals(b) && a.status.is_running()
    }
}
