//! A difference as it is told, and as a case of the language.

use lockstep::{Difference, Event, Happening, Script, Subject};
use tip_runtime::command::Port;

/// A program whose engines part, with the shortest script that shows it.
#[derive(Clone, Debug)]
pub struct Failure<'a> {
    /// The program.
    pub subject: &'a Subject,
    /// The events.
    pub script: Script,
    /// Where they part.
    pub difference: Difference,
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
        difference.cycle, difference.expected, difference.found
    );
    let sides: String = sides.lines().map(|line| format!("| {line}\n")).collect();
    let events = format!("{:?} {:?}", script.scenery, script.events);
    format!("differs {seed} {}\n| {events}\n{sides}", options(script))
}

/// The options of `tipc run` for a script. Failing hardware has none.
fn options(script: &Script) -> String {
    let keys: Vec<String> = script.events.iter().filter_map(key).collect();
    let sensors = script.events.iter().flat_map(sensors);
    let mut options = vec![format!("--cycles {}", script.limit)];
    if !keys.is_empty() {
        options.push(format!("--keys {}", keys.join(",")));
    }
    options.extend(sensors);
    options.join(" ")
}

fn key((cycle, happening): &Event) -> Option<String> {
    match happening {
        Happening::Key(byte) => Some(format!("{cycle}:{byte:#04X}").replace("0X", "0x")),
        _ => None,
    }
}

fn sensors((cycle, happening): &Event) -> Vec<String> {
    let inputs = match happening {
        Happening::Sensor(port, volts) => vec![(*port, *volts)],
        Happening::Touch(on) => (1..=4)
            .map(|leg| (Port::Paw(leg), f64::from(*on) * 2.0))
            .collect(),
        Happening::Key(_) | Happening::ReadFails | Happening::WriteFails => Vec::new(),
    };
    inputs
        .iter()
        .map(|(port, volts)| format!("--sensor {port}={volts}@{cycle}"))
        .collect()
}
