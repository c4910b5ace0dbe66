//! A divergence, shown: where, the two records, and how to see it again.

use super::super::loader::Checked;
use super::super::shown::place;
use std::env;
use tip_runtime::printable::Printable;
use tip_sim::lockstep::Divergence;
use tip_sim::search::Diverging;

/// The options that the shortest inputs take the place of.
const INPUTS: [&str; 6] = [
    "--keys", "--sensor", "--halt", "--events", "--cycles", "--runs",
];

/// The text of a divergence.
pub(super) fn finding(checked: &Checked, diverging: &Diverging) -> String {
    let Diverging { inputs, divergence } = diverging;
    let Divergence {
        cycle,
        step,
        interpreted,
        compiled,
    } = divergence;
    let name = Printable::line(checked.source.name());
    let place = place(&checked.source, &checked.program, *step);
    let command = Printable::line(without_inputs(env::args().skip(1)));
    format!(
        "{name}: compiled code and interpreter DIFFER in cycle {cycle}, step {step}\n\
         {place}interpreter  {interpreted}\ncompiled     {compiled}\n\
         again        tip {command} {inputs}\n"
    )
}

/// A command line without the options that are inputs.
fn without_inputs(arguments: impl Iterator<Item = String>) -> String {
    let mut words = Vec::new();
    let mut skips_value = false;
    for argument in arguments {
        let is_input = INPUTS.iter().any(|option| {
            let value = argument.strip_prefix(option);
            value.is_some_and(|value| value.is_empty() || value.starts_with('='))
        });
        if is_input {
            skips_value = !argument.contains('=');
        } else if !std::mem::take(&mut skips_value) {
            words.push(quoted(&argument));
        }
    }
    words.join(" ")
}

/// As a shell takes it for one word.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "/._-=".contains(c);
    if word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_line_loses_its_inputs_and_keeps_the_rest() {
        let words =
            "verify --keys 3:a --robot six legs.toml --halt=5 p.prg --cycles 9 --sensor VR1=2@3";
        let words = words.replace("six legs", "six\u{1}legs");
        let words = words.split(' ').map(|word| word.replace('\u{1}', " "));
        assert_eq!(
            without_inputs(words),
            "verify --robot 'six legs.toml' p.prg"
        );
    }
}
