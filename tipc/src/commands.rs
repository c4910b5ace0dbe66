//! The one table of every command: name, arguments, robots, documentation.
//!
//! The checker, the reserved words, the suggestions and the tables of the language reference are
//! all derived from it.

mod form;
mod outcome;
mod table;
mod usage;

pub use form::{Arguments, Form, Joints, Limit, Robots, Targets, Values};
pub use outcome::{Cycles, Failure};
pub use table::COMMANDS;
use tip_runtime::command::{Op, Teach};

/// A command of the language.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Command {
    /// Its name.
    pub name: &'static str,
    /// Another name that older programs use.
    pub alias: Option<&'static str>,
    /// The section of T.I.P. 3.1 that describes it.
    pub section: &'static str,
    /// The clause of the language reference.
    pub clause: &'static str,
    /// What it does.
    pub meaning: Meaning,
    /// Its arguments.
    pub form: Form,
    /// The robots that have it.
    pub robots: Robots,
    /// The unit of its values, empty if they have none; `torque` is the robot's torque unit.
    pub unit: &'static str,
    /// How many control cycles it takes.
    pub cycles: Cycles,
    /// The run-time errors of its own step, beside those of its operands.
    pub failures: &'static [Failure],
    /// One line for the reference.
    pub description: &'static str,
}

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// The robot carries it out.
    Robot(Op),
    /// It measures into a variable.
    Teach(Teach),
    /// It reads an input into a variable.
    AdIn,
    /// It waits for a key.
    KeyIn,
    /// It clears the message line.
    MessageClear,
    /// The parser reads it: control words, declarations, MESSAGE and REM.
    Word,
}

/// The command of that name or alias.
pub fn find(name: &str) -> Option<&'static Command> {
    COMMANDS
        .iter()
        .find(|command| command.name == name || command.alias == Some(name))
}

/// Whether a command of the robot can take more than one control cycle.
pub fn waits(op: Op) -> bool {
    let mut rows = COMMANDS.iter();
    rows.any(|command| {
        command.meaning == Meaning::Robot(op) && matches!(command.cycles, Cycles::Until(_))
    })
}

/// What an older version's command is called now (T.I.P. 3.1 §1-1).
pub fn renamed(word: &str) -> Option<&'static str> {
    let name = match word {
        "SET_INPOS" => "SET_JUST_POSITION".to_owned(),
        "SET_NEAR" => "SET_NEAR_POSITION".to_owned(),
        "COMPLIANCE" => "COMPLIANCE_ANGLE".to_owned(),
        _ => format!("SET_{word}"),
    };
    find(&name).map(|command| command.name)
}

/// The event flags without a number in their names.
pub const FLAGS: &[&str] = &["HALT_REQUEST", "KB_HIT", "ANTENNA_ON"];

/// The event flags that a number or target follows.
pub const FLAG_FAMILIES: &[&str] = &["INPOS_", "NEAR_", "SPECIAL_FLAG"];

/// Words that belong to other statements.
pub const PARTICLES: &[&str] = &["THEN", "TO", "STEP"];

/// The inputs besides joints.
pub const PORTS: &[&str] = &[
    "VR1", "VR2", "VR3", "PAW1", "PAW2", "PAW3", "PAW4", "ANTENNA",
];

/// The flags of motion arguments.
pub const MOTION_FLAGS: &[&str] = &["R", "A", "HS"];
