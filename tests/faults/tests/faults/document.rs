//! The table as a page.

use crate::campaign::{Name, Seen};
use std::collections::BTreeSet;
use std::fmt::Write as _;

const HEAD: &str = "\
# What a fault does

The outcome of faults of sensors, hardware, keys and timing.
Each fault was injected into runs of a short program with motion, waits, inputs and, where the robot has them, torques, forces and springs.
A fault that stops the robot immediately was injected in every cycle but the first; the others in every fifth cycle, starting at a different cycle for each place; with mass (`--plant dynamic`) in every third and every fifteenth.
The same faults were injected into [compiled programs](../tests/faults/tests/faults/motions) with searches, EMG_OFF, SPECIAL commands and vibration, in every eleventh cycle and in every fifty-fifth.
A broken sensor stays broken.

In every cycle of every run

- joint commands were finite numbers: angles within the working limits, torques within TORQUE_MAX, the slider within its travel;
- in an emergency the hardware was stopped and received no other command, and the emergency was reported once;
- after END the robot came to rest, and every wait that did not end by itself was ended by a stop.

A cell with several outcomes lists all that occurred; which one depends on the step and the joint.
*Unaffected* runs give the same commands as without the fault; those that *end differently* give others and run to their end, since no program can tell a plausible wrong measurement from a right one.
A robot reads only the sensors of its model: faults of other torque, slider or sole sensors change nothing.

`cargo test -p tip-tests-faults` runs the campaign and compares this half of the page; with `TIP_BLESS=1` it rewrites it.
[Files and Ctrl-C](#files-and-ctrl-c) are the other half.

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
