//! Inputs from outside that can change the path of a program, read off its steps.

use crate::event::Event;
use std::collections::BTreeSet;
use tip_runtime::command::Port;
use tipc::language::flags::{self, Cause};
use tipc::program::{Action, Condition, Operand, Program};

/// Key codes beyond these are none that a program can get.
const KEYS: std::ops::RangeInclusive<f64> = 32.0..=126.0;
/// Range of the inputs' readings, V.
const VOLTS: std::ops::RangeInclusive<f64> = -10.0..=10.0;

/// Returns every single event that may happen to a program and matter to it.
pub fn inputs(program: &Program) -> Vec<Event> {
    let mut takes_keys = false;
    let mut takes_halts = false;
    let mut ports = Vec::new();
    let mut numbers = Vec::new();
    for step in program.steps() {
        match step.action {
            Action::KeyIn { .. } => takes_keys = true,
            // Channels have no name that a command line could give.
            Action::AdIn { port, .. } if !matches!(port, Port::Channel(_)) => ports.push(port),
            _ => {}
        }
        match step.action.condition() {
            Some(Condition::Flag { flag, .. }) => match flags::row(*flag).map(|row| row.cause) {
                Some(Cause::Key) => takes_keys = true,
                Some(Cause::Halt) => takes_halts = true,
                Some(Cause::Input(port)) => ports.push(port),
                Some(Cause::Robot) | None => {}
            },
            Some(Condition::Compare { left, right, .. }) => {
                numbers.extend([left, right].into_iter().filter_map(constant));
            }
            None => {}
        }
    }
    ports.sort_by_key(|port| format!("{port:?}"));
    ports.dedup();
    let keys = if takes_keys {
        keys(&numbers)
    } else {
        BTreeSet::new()
    };
    let keys = keys.into_iter().map(Event::Key);
    let halt = takes_halts.then_some(Event::Halt);
    let volts = volts(&numbers);
    let sensors = ports
        .iter()
        .flat_map(|port| volts.iter().map(|volts| Event::Sensor(*port, *volts)));
    keys.chain(halt).chain(sensors).collect()
}

fn constant(operand: &Operand) -> Option<f64> {
    match operand {
        Operand::Constant(number) => Some(*number),
        Operand::Scalar { .. } | Operand::Reading { .. } => None,
    }
}

/// Returns the keys that conditions ask for, and one that none asks for.
fn keys(numbers: &[f64]) -> BTreeSet<u8> {
    let codes = numbers.iter().filter(|number| KEYS.contains(number));
    let mut keys: BTreeSet<u8> = codes.map(|number| *number as u8).collect();
    keys.extend((b'A'..=b'Z').rev().find(|key| !keys.contains(key)));
    keys
}

/// Returns values below, at and above each number that conditions ask for, and both ends.
fn volts(numbers: &[f64]) -> Vec<f64> {
    let around = numbers
        .iter()
        .flat_map(|number| [number - 0.5, *number, number + 0.5]);
    let mut volts: Vec<f64> = around
        .chain([0.0, 5.0, 10.0])
        .filter(|volts| VOLTS.contains(volts))
        .collect();
    volts.sort_by(f64::total_cmp);
    volts.dedup();
    volts
}
