//! The table as a page.

use crate::campaign::{Name, Seen};
use std::collections::BTreeSet;
use std::fmt::Write as _;

const HEAD: &str = "\
# What a fault does

How a program ends, or goes on, after a fault of sensors, hardware, keys or timing. Each fault was injected into runs of a short program
with motion, waits, inputs and, where the robot has them, torques, forces and springs. A fault that stops the robot at once was injected
in every cycle but the first; the others in every fifth cycle, starting at a different cycle for each place. A broken sensor stays broken.
On robots with mass (`--plant dynamic`) it was every third cycle, and every fifteenth.
The same faults were injected into [compiled programs](../tests/faults/tests/faults/motions) with searches, EMG_OFF, SPECIAL commands and
vibration, in every eleventh cycle and in every fifty-fifth.

In every cycle of every run the joint commands were numbers: angles within the working limits, torques within TORQUE_MAX, the slider
within its travel. In every emergency stop the hardware was stopped in each cycle and received no other command, and the emergency was
reported once. After every END the robot came to rest. Every wait that did not end by itself was ended by a stop.

Where a cell lists several outcomes, each was seen. Which one occurs depends on the step that runs and on the joint. *Goes on to its
end* means with other commands than without the fault: no program can tell a wrong measurement from a right one if it is plausible.
A robot reads only the sensors that its model has: a fault of a torque, slider or sole sensor that it lacks changes nothing.

`cargo test -p tip-tests-faults` runs the campaign and compares this half of the page; with `TIP_BLESS=1` it rewrites
it. [Files and Ctrl-C](#files-and-ctrl-c) are the other half.

";

pub(crate) fn document(robots: &[(&str, Seen)]) -> String {
    let mut page = String::from(HEAD);
    let names: BTreeSet<Name> = robots
        .iter()
        .flat_map(|(_, seen)| seen.keys().copied())
        .collect();
    page.push_str("| where | fault |");
    for (robot, _) in robots {
        let _ = write!(page, " {robot} |");
    }
    page.push_str(" runs |\n|---|---|");
    page.extend(robots.iter().map(|_| "---|"));
    page.push_str("---|\n");
    for name in &names {
        row(&mut page, *name, robots);
    }
    let runs: usize = robots
        .iter()
        .flat_map(|(_, seen)| seen.values())
        .map(|cell| cell.trials)
        .sum();
    let _ = writeln!(page, "\n{} rows, {runs} runs.", names.len());
    page
}

fn row(page: &mut String, name: Name, robots: &[(&str, Seen)]) {
    let (place, fault) = name;
    let _ = write!(page, "| {place} | {fault} |");
    let mut runs = 0;
    for (_, seen) in robots {
        let cell = seen.get(&name);
        let outcomes =
            cell.map(|cell| cell.outcomes.iter().map(String::as_str).collect::<Vec<_>>());
        let _ = write!(page, " {} |", outcomes.unwrap_or_default().join("; "));
        runs += cell.map_or(0, |cell| cell.trials);
    }
    let _ = writeln!(page, " {runs} |");
}
