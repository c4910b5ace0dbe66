//! `--plant`: what simulates the robot.

use super::choices::PlantName;
use super::error::Error;
use super::report;
use super::usage::Wrong;
use crate::message::Using;
use clap::ValueEnum;
use std::str::FromStr;
use tip_sim::ExternalPlant;
use tipc::message::Lang;
use tipc::message::list::Each;

/// What a process is written after.
const EXEC: &str = "exec:";

/// One of our plants, or a process.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum PlantChoice {
    Ours(PlantName),
    /// A program and its arguments.
    Process(String, Vec<String>),
}

impl FromStr for PlantChoice {
    type Err = Wrong;

    /// A command is split into words as a shell does, without one: blanks, quotes and backslashes count, nothing else does.
    fn from_str(text: &str) -> Result<Self, Wrong> {
        if let Some(command) = text.strip_prefix(EXEC) {
            let words = shlex::split(command).unwrap_or_default();
            return match words.split_first() {
                Some((program, arguments)) if !program.is_empty() => {
                    Ok(PlantChoice::Process(program.clone(), arguments.to_vec()))
                }
                _ => Err(Wrong(Using::NoProcess {
                    command: command.to_owned(),
                })),
            };
        }
        PlantName::from_str(text, true)
            .map(PlantChoice::Ours)
            .map_err(|_| {
                let names = PlantName::value_variants().iter();
                Wrong(Using::NoPlant {
                    word: text.to_owned(),
                    plants: Each(names.map(|plant| plant.name()).collect()),
                })
            })
    }
}

/// Why a command takes our plants alone.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ours {
    /// It runs programs more than once, or backwards.
    Again(&'static str),
    /// It records what it runs.
    Recorded(&'static str),
}

impl Ours {
    fn message(self) -> Using {
        match self {
            Ours::Again(command) => Using::ProcessRunsOnce { command },
            Ours::Recorded(command) => Using::ProcessIsRun { command },
        }
    }
}

/// Which of our plants it is.
///
/// # Errors
/// It is a process.
pub(super) fn ours(
    choice: Option<&PlantChoice>,
    why: Ours,
    lang: Lang,
) -> Result<Option<PlantName>, Error> {
    match choice {
        None => Ok(None),
        Some(PlantChoice::Ours(name)) => Ok(Some(*name)),
        Some(PlantChoice::Process(..)) => {
            Err(Error::Usage(why.message().in_lang(lang).to_string()))
        }
    }
}

impl PlantChoice {
    /// One of our plants, if it is one.
    pub(super) fn name(&self) -> Option<PlantName> {
        match self {
            PlantChoice::Ours(name) => Some(*name),
            PlantChoice::Process(..) => None,
        }
    }

    /// The process, if it is one; what it writes to its standard error goes to ours.
    pub(super) fn process(&self) -> Option<ExternalPlant> {
        match self {
            PlantChoice::Ours(_) => None,
            PlantChoice::Process(program, arguments) => {
                let plant = ExternalPlant::new(program, arguments);
                Some(plant.with_listener(|line| report::complain(&format!("{line}\n"))))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Option<Vec<String>> {
        match text.parse() {
            Ok(PlantChoice::Process(program, arguments)) => {
                Some([vec![program], arguments].concat())
            }
            _ => None,
        }
    }

    #[test]
    fn a_command_is_split_as_a_shell_splits_it() {
        let split = |text| words(text).unwrap_or_default();
        assert_eq!(split("exec:python3 sim.py"), ["python3", "sim.py"]);
        assert_eq!(
            split("exec:  sim  'a b' \"c d\"e f\\ g ''"),
            ["sim", "a b", "c de", "f g", ""]
        );
        // No shell is between.
        assert_eq!(
            split("exec:sim $HOME *.xml | cat"),
            ["sim", "$HOME", "*.xml", "|", "cat"]
        );
        for none in ["exec:", "exec:  ", "exec:sim 'a", "exec:''", "exec"] {
            assert_eq!(words(none), None, "{none}");
        }
    }

    #[test]
    fn our_plants_have_their_names() {
        assert_eq!(
            "dynamic"
                .parse::<PlantChoice>()
                .ok()
                .and_then(|it| it.name()),
            Some(PlantName::Dynamic)
        );
        assert_eq!(
            "Quasi-Static"
                .parse::<PlantChoice>()
                .ok()
                .and_then(|it| it.name()),
            Some(PlantName::QuasiStatic)
        );
        assert!("dynamics".parse::<PlantChoice>().is_err());
    }
}
