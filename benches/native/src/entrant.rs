//! The implementations that are compared.

use crate::machines::Cycle;
use crate::motion::Motion;
use crate::{by_hand, compiled, machines, switches, walk_by_hand};
use statig::blocking::{IntoStateMachineExt, StateMachine};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow, Program};
use tip_sim::Interpreter;

/// A motion that runs one step in each control cycle.
pub trait Entrant {
    /// Runs one step.
    ///
    /// # Errors
    /// The fault that the step found.
    fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault>;

    /// Memory of its run, bytes; 0 where it is not counted.
    fn state_bytes(&self) -> usize {
        0
    }
}

/// The native entrants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// Compiled by tipc.
    Compiled,
    /// Rust by hand.
    ByHand,
    /// C by hand.
    Switch,
    /// The crate `statig`.
    Statig,
    /// tipc's interpreter.
    Interpreter,
}

impl Name {
    /// All of them.
    pub const ALL: [Name; 5] = [
        Name::Compiled,
        Name::ByHand,
        Name::Switch,
        Name::Statig,
        Name::Interpreter,
    ];

    /// Returns its name in tables and benchmarks.
    pub fn name(self) -> &'static str {
        match self {
            Name::Compiled => "compiled",
            Name::ByHand => "by_hand",
            Name::Switch => "c_switch",
            Name::Statig => "statig",
            Name::Interpreter => "interpreter",
        }
    }
}

/// An entrant at its first step; `is_traced` if its trace is wanted.
pub fn entrant(name: Name, motion: Motion, is_traced: bool) -> Box<dyn Entrant> {
    match (name, motion) {
        (Name::Compiled, Motion::WalkLoop) => Box::new(compiled::WalkLoop::new()),
        (Name::Compiled, Motion::Steps100) => Box::new(compiled::Steps100::new()),
        (Name::Compiled, Motion::Steps1000) => Box::new(compiled::Steps1000::new()),
        (Name::Compiled, Motion::Steps10000) => Box::new(compiled::Steps10000::new()),
        (Name::ByHand, Motion::WalkLoop) => Box::new(walk_by_hand::Walk::new()),
        (Name::ByHand, Motion::Steps100) => Box::new(by_hand::steps100::ByHand::default()),
        (Name::ByHand, Motion::Steps1000) => Box::new(by_hand::steps1000::ByHand::default()),
        (Name::ByHand, Motion::Steps10000) => Box::new(by_hand::steps10000::ByHand::default()),
        (Name::Switch, Motion::WalkLoop) => Box::new(switches::walk_loop(is_traced)),
        (Name::Switch, Motion::Steps100) => Box::new(switches::steps100(is_traced)),
        (Name::Switch, Motion::Steps1000) => Box::new(switches::steps1000(is_traced)),
        (Name::Switch, Motion::Steps10000) => Box::new(switches::steps10000(is_traced)),
        (Name::Statig, Motion::WalkLoop) => {
            Box::new(machines::walk_loop::Machine::default().state_machine())
        }
        (Name::Statig, Motion::Steps100) => {
            Box::new(machines::steps100::Machine::default().state_machine())
        }
        (Name::Statig, Motion::Steps1000) => {
            Box::new(machines::steps1000::Machine::default().state_machine())
        }
        (Name::Statig, Motion::Steps10000) => {
            Box::new(machines::steps10000::Machine::default().state_machine())
        }
        (Name::Interpreter, motion) => Box::new(Interpreter::new(motion.program())),
    }
}

macro_rules! programs {
    ($($program:ty)*) => { $(
        impl Entrant for $program {
            fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault> {
                Program::step(self, robot)
            }

            fn state_bytes(&self) -> usize {
                size_of::<Self>()
            }
        }
    )* };
}

programs!(compiled::WalkLoop compiled::Steps100 compiled::Steps1000 compiled::Steps10000);

impl Entrant for Interpreter {
    fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault> {
        self.step(robot)
    }
}

macro_rules! steps {
    ($($by_hand:ty)*) => { $(
        impl Entrant for $by_hand {
            fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault> {
                self.step(robot)
            }

            fn state_bytes(&self) -> usize {
                size_of::<Self>()
            }
        }
    )* };
}

steps! {
    walk_by_hand::Walk
    by_hand::steps100::ByHand
    by_hand::steps1000::ByHand
    by_hand::steps10000::ByHand
}

macro_rules! machines {
    ($($machine:ty)*) => { $(
        impl Entrant for StateMachine<$machine> {
            fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault> {
                let mut cycle = Cycle { robot, fault: None };
                self.handle_with_context(&(), &mut cycle);
                cycle.fault.map_or(Ok(Flow::Next), Err)
            }

            fn state_bytes(&self) -> usize {
                size_of::<Self>()
            }
        }
    )* };
}

machines! {
    machines::walk_loop::Machine
    machines::steps100::Machine
    machines::steps1000::Machine
    machines::steps10000::Machine
}
