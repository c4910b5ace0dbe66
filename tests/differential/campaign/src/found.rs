//! A difference as it is reported, and as a case of the language.

use lockstep::{Script, Subject};
use tip_sim::lockstep::Divergence;

/// A program whose engines part, with the shortest script that shows it.
#[derive(Clone, Debug)]
pub struct Failure<'a> {
    /// The program.
    pub subject: &'a Subject,
    /// The events.
    pub script: Script,
    /// First difference.
    pub difference: Divergence,
}

/// `differs`, the seed, the options of a run by which it shows, and both sides in words.
pub fn text(failure: &Failure<'_>) -> String {
    let Failure {
        subject,
        script,
        difference,
    } = failure;
    let seed = subject.0.0;
    let sides = format!(
        "cycle {}, interpreter:\n{}generated code:\n{}",
        difference.cycle, difference.interpreted, difference.compiled
    );
    let sides: String = sides.lines().map(|line| format!("| {line}\n")).collect();
    let Script { plant, inputs } = script;
    let events = format!("{plant:?} {}", inputs.events);
    format!("differs {seed} {inputs}\n| {events}\n{sides}")
}
