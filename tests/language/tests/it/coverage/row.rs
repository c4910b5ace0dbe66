//! The rows of the table: every form of every statement.

use super::form::Form;
use super::outcome::Outcome;
use super::rule::{self, Possible};
use super::sentence::{self, Sentence};
use tipc::Robot;
use tipc::language::Edition;
use tipc::language::commands::{COMMANDS, Form as Shape, find_in};

/// A form of a statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Row {
    /// A command with arguments.
    Command(Form),
    /// Any other statement.
    Sentence(Sentence),
}

impl Row {
    /// Every row, in the order of the table of commands.
    pub fn all() -> Vec<Row> {
        let sentences = sentence::all();
        let named = |name: &str| {
            let mine = sentences.iter().filter(|form| form.name == name);
            mine.cloned().map(Row::Sentence).collect::<Vec<_>>()
        };
        let mut rows = Vec::new();
        for command in COMMANDS {
            match command.form {
                Shape::Words(_) => rows.extend(named(command.name)),
                _ => rows.extend(Form::all(command).into_iter().map(Row::Command)),
            }
        }
        for name in [
            sentence::NATIVE,
            sentence::LABEL,
            sentence::CONDITION,
            sentence::EQUATION,
        ] {
            rows.extend(named(name));
        }
        rows
    }

    /// Returns true if it is only a part of statements, of which other parts may fail.
    pub fn is_part(&self) -> bool {
        [sentence::CONDITION, sentence::NATIVE].contains(&self.name())
    }

    /// Returns the first edition that has it.
    pub fn since(&self) -> Edition {
        match self {
            Row::Command(form) => form.since,
            Row::Sentence(form) => {
                let command = find_in(form.name, Edition::V3_2);
                command.map_or(Edition::V3_1, |command| command.since)
            }
        }
    }

    /// The statement's name.
    pub fn name(&self) -> &'static str {
        match self {
            Row::Command(form) => form.name,
            Row::Sentence(form) => form.name,
        }
    }

    /// Returns the part after the name.
    pub fn text(&self) -> String {
        match self {
            Row::Command(form) => form.text(),
            Row::Sentence(form) => form.text.clone(),
        }
    }

    /// Returns the possibility of an outcome for a statement of this form on a robot.
    pub fn possible(&self, robot: Robot, outcome: Outcome) -> Possible {
        match self {
            Row::Command(form) => rule::of_command(form, robot, outcome),
            Row::Sentence(form) => rule::of_sentence(form, robot, outcome),
        }
    }
}
