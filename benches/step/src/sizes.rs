//! Sizes: machine code from the symbols of this program, state from the types.

use native::motion::Motion;
use native::{Name, entrant};
use std::process::Command;

/// Bytes of machine code for each step.
pub(crate) fn code(name: &str, motion: Motion) -> Option<f64> {
    let module = motion.name();
    let compiled = match motion {
        Motion::WalkLoop => "compiled::WalkLoop",
        Motion::Steps100 => "compiled::Steps100",
        Motion::Steps1000 => "compiled::Steps1000",
        Motion::Steps10000 => "compiled::Steps10000",
    };
    let part = match (name, motion) {
        ("compiled", _) => compiled.to_owned(),
        ("by_hand", Motion::WalkLoop) => "walk_by_hand::".to_owned(),
        ("by_hand", _) => format!("by_hand::{module}::"),
        ("c_switch", _) => format!(" step_{module}"),
        ("statig", _) => format!("machines::{module}::"),
        _ => return None,
    };
    let bytes: u64 = symbols()?
        .lines()
        .filter(|line| mentions(line, &part) && !is_apart(line))
        .filter_map(text_bytes)
        .sum();
    (bytes > 0).then(|| bytes as f64 / motion.program().steps().len() as f64)
}

/// Bytes of the value that a run changes.
pub(crate) fn state(name: &str, motion: Motion) -> Option<f64> {
    let name = Name::ALL.into_iter().find(|it| it.name() == name)?;
    let bytes = entrant(name, motion, false).state_bytes();
    (bytes > 0).then_some(bytes as f64)
}

fn symbols() -> Option<String> {
    let output = Command::new("nm")
        .args(["-S", "-C"])
        .arg(std::env::current_exe().ok()?)
        .output()
        .ok()?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Returns true if a symbol has the part in its path, and not a longer name that begins like it.
fn mentions(symbol: &str, part: &str) -> bool {
    let mut rests = symbol.split(part).skip(1);
    rests.any(|rest| !rest.starts_with(|next: char| next.is_ascii_digit()))
}

/// Returns true if a symbol is of what a cycle does not run, and only compiled programs have: names of steps and
/// variables, lines, how they print.
fn is_apart(symbol: &str) -> bool {
    [" as tip_runtime::", " as core::"]
        .iter()
        .any(|of_trait| symbol.contains(of_trait))
}

/// The size on a line `address size kind name`, if it is of machine code.
fn text_bytes(line: &str) -> Option<u64> {
    let mut words = line.split(' ');
    let (_, size, kind) = (words.next()?, words.next()?, words.next()?);
    let is_code = kind.eq_ignore_ascii_case("t");
    is_code.then(|| u64::from_str_radix(size, 16).ok())?
}
