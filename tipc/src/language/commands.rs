//! The one table of every command: name, arguments, robots, documentation.
//!
//! The checker, the reserved words, the suggestions and the tables of the language reference are
//! all derived from it.

mod form;
mod outcome;
mod rows;

pub use form::{Arguments, Form, Joints, Limit, Robots, Targets, Values};
pub use outcome::{Cycles, Failure, Moves};
pub use rows::COMMANDS;

use super::{Bilingual, Edition, Keyword};
use crate::robot::Robot;
use smol_str::StrExt;
use std::collections::HashMap;
use std::sync::LazyLock;
use tip_runtime::command::{Op, Teach};

/// A command of the language.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Command {
    /// Its name.
    pub name: &'static str,
    /// Another name that older programs use.
    pub alias: Option<&'static str>,
    /// The first edition that has it.
    pub since: Edition,
    /// The section of T.I.P. that describes it.
    pub section: &'static str,
    /// The clause of the language reference.
    pub clause: &'static str,
    /// Effect of the command.
    pub meaning: Meaning,
    /// Its arguments.
    pub form: Form,
    /// Its arguments from a later edition on, if that has more forms.
    pub later_form: Option<(Edition, Form)>,
    /// The robots that have it.
    pub robots: Robots,
    /// The unit of its values, empty if they have none; `torque` is the robot's torque unit.
    pub unit: &'static str,
    /// Parts that it brings under control.
    pub moves: Moves,
    /// True if its values are added to the targets that there are.
    pub is_relative: bool,
    /// Number of control cycles it takes.
    pub cycles: Cycles,
    /// The runtime errors of its own step, besides those of its operands.
    pub failures: &'static [Failure],
    /// One line for the reference.
    pub description: Bilingual,
}

/// Effect of a command.
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
    Keyword(Keyword),
}

/// By name and alias.
static INDEX: LazyLock<HashMap<&str, &Command>> = LazyLock::new(|| {
    let names = COMMANDS.iter().map(|row| (row.name, row));
    let aliases = COMMANDS.iter().filter_map(|row| Some((row.alias?, row)));
    names.chain(aliases).collect()
});

/// Returns the command of that name or alias that every edition has, whatever the case.
pub fn find(name: &str) -> Option<&'static Command> {
    find_in(name, Edition::V3_1)
}

/// Returns the command of that name or alias that an edition has, whatever the case.
pub fn find_in(name: &str, edition: Edition) -> Option<&'static Command> {
    let row = INDEX.get(&*name.to_ascii_uppercase_smolstr()).copied();
    row.filter(|row| row.since <= edition)
}

/// Returns the names of the commands of an edition.
pub fn names(edition: Edition) -> impl Iterator<Item = &'static str> {
    let rows = COMMANDS.iter().filter(move |row| row.since <= edition);
    rows.map(|row| row.name)
}

impl Command {
    /// Creates a command of 3.1 that every robot has, that takes no argument and one cycle, and that cannot fail.
    const fn new(name: &'static str, meaning: Meaning) -> Self {
        Command {
            name,
            alias: None,
            since: Edition::V3_1,
            section: "",
            clause: "",
            meaning,
            form: Form::Robot(Arguments::BARE),
            later_form: None,
            robots: Robots::ALL,
            unit: "",
            moves: Moves::Nothing,
            is_relative: false,
            cycles: Cycles::One,
            failures: outcome::NONE,
            description: Bilingual::EMPTY,
        }
    }

    /// Creates a command that the robot carries out.
    const fn robot(op: Op) -> Self {
        Command::new(op.name(), Meaning::Robot(op))
    }

    /// Creates a command that the parser reads, without arguments.
    const fn keyword(keyword: Keyword) -> Self {
        let row = keyword.row();
        Command {
            since: row.since,
            form: Form::Words(""),
            description: row.description,
            ..Command::new(row.word, Meaning::Keyword(keyword)).place(row.section, row.clause)
        }
    }

    /// Sets its section of T.I.P. 3.1 and its clause of the language reference.
    const fn place(self, section: &'static str, clause: &'static str) -> Self {
        Command {
            section,
            clause,
            ..self
        }
    }

    /// Sets the description, one line.
    const fn does(self, english: &'static str, japanese: &'static str) -> Self {
        Command {
            description: Bilingual { english, japanese },
            ..self
        }
    }

    /// Sets another name that older programs use.
    const fn alias(self, alias: &'static str) -> Self {
        Command {
            alias: Some(alias),
            ..self
        }
    }

    /// Sets its arguments.
    const fn takes(self, arguments: Arguments) -> Self {
        self.form(Form::Robot(arguments))
    }

    /// Sets its arguments, in a form of its own.
    const fn form(self, form: Form) -> Self {
        Command { form, ..self }
    }

    /// Sets its arguments from a later edition on.
    const fn later(self, edition: Edition, arguments: Arguments) -> Self {
        Command {
            later_form: Some((edition, Form::Robot(arguments))),
            ..self
        }
    }

    /// Marks it as a command that 3.2 brought.
    const fn since_3_2(self) -> Self {
        Command {
            since: Edition::V3_2,
            ..self
        }
    }

    /// Sets its arguments as the parser reads them.
    const fn words(self, text: &'static str) -> Self {
        self.form(Form::Words(text))
    }

    /// Sets the unit of its values.
    const fn unit(self, unit: &'static str) -> Self {
        Command { unit, ..self }
    }

    /// Sets what it brings under control.
    const fn moves(self, moves: Moves) -> Self {
        Command { moves, ..self }
    }

    /// Sets the robots that have it.
    const fn relative(self) -> Self {
        Command {
            is_relative: true,
            ..self
        }
    }

    const fn only(self, robots: Robots) -> Self {
        Command { robots, ..self }
    }

    /// Marks it as no step.
    const fn no_step(self) -> Self {
        Command {
            cycles: Cycles::Zero,
            ..self
        }
    }

    /// Sets the condition until which the program stays on it.
    const fn until(self, english: &'static str, japanese: &'static str) -> Self {
        Command {
            cycles: Cycles::Until(Bilingual { english, japanese }),
            ..self
        }
    }

    /// Sets the runtime errors of its own step.
    const fn fails(self, failures: &'static [Failure]) -> Self {
        Command { failures, ..self }
    }

    /// Returns its arguments in an edition.
    pub fn form_in(&self, edition: Edition) -> Form {
        match self.later_form {
            Some((since, form)) if since <= edition => form,
            _ => self.form,
        }
    }
}

/// Returns true if a command of the robot can take more than one control cycle.
pub fn waits(op: Op) -> bool {
    let mut rows = COMMANDS.iter();
    rows.any(|command| {
        command.meaning == Meaning::Robot(op) && matches!(command.cycles, Cycles::Until(_))
    })
}

/// Returns true if a command of the robot adds its values to the targets that there are.
pub fn is_relative(op: Op) -> bool {
    let mut rows = COMMANDS.iter();
    rows.any(|command| command.meaning == Meaning::Robot(op) && command.is_relative)
}

/// Returns true if the robot can measure a quantity.
pub fn senses(robot: Robot, what: Teach) -> bool {
    let mut rows = COMMANDS.iter();
    rows.any(|row| row.meaning == Meaning::Teach(what) && row.robots.contains(robot))
}

/// Returns the command that does to joints what this one does to feet.
pub fn of_joints(word: &str) -> Option<&'static str> {
    let op = Op::ALL.iter().find(|op| op.name() == word)?;
    let other = match op {
        Op::Ptp => Op::PtpAngle,
        Op::RelPtp => Op::RelPtpAngle,
        Op::VelControl => Op::OmegaControl,
        Op::Force => Op::Torque,
        Op::CompliancePosition => Op::ComplianceAngle,
        Op::RelCompliancePosition => Op::RelComplianceAngle,
        Op::SetVMax => Op::SetOmegaMax,
        Op::SetAMax => Op::SetOmegaDotMax,
        Op::SetJustPosition => Op::SetJustAngle,
        Op::SetNearPosition => Op::SetNearAngle,
        Op::SetPositionStiffness => Op::SetAngleStiffness,
        _ => return None,
    };
    Some(other.name())
}

/// Returns the present name of an older version's command (T.I.P. 3.1 §1-1).
pub fn renamed(word: &str) -> Option<&'static str> {
    let bare = word.strip_prefix("SET_").unwrap_or(word);
    let name = match word {
        // Some names in the tables of contents and of changes.
        _ if bare.starts_with("T_MAX") => format!("SET_TORQUE{}", &bare[1..]),
        _ if bare.starts_with("OMEGA_") && !bare.contains("_MAX") => {
            let (limit, rate) = bare.rsplit_once('_')?;
            format!("SET_{limit}_MAX_{rate}")
        }
        "SET_NEAR_POSITION_ANGLE" => return Some(Op::SetNearAngle.name()),
        "SET_NEAR_POSITION_POSITION" => return Some(Op::SetNearPosition.name()),
        "SET_INPOS" => return Some(Op::SetJustPosition.name()),
        "SET_NEAR" => return Some(Op::SetNearPosition.name()),
        "COMPLIANCE" => return Some(Op::ComplianceAngle.name()),
        _ => format!("SET_{word}"),
    };
    find(&name).map(|command| command.name)
}
