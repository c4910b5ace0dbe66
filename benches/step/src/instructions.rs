//! Instructions, counted by valgrind: this program runs itself for fewer and for more cycles, and what
//! lies between is the cycles'. Scripts are left out; their interpreters take minutes to start there.

use native::motion::Motion;
use native::robot::{Answering, Count};
use native::{Name, entrant};
use std::error::Error;
use std::process::Command;
use step::drive;

const FEWER: u64 = 15_000;
const MORE: u64 = 45_000;

/// Runs an entrant: what valgrind watches.
pub(crate) fn run(name: &str, motion: &str, cycles: u64) -> Result<(), Box<dyn Error>> {
    let name = named(name).ok_or("no such entrant")?;
    let motion = Motion::ALL.into_iter().find(|it| it.name() == motion);
    let motion = motion.ok_or("no such motion")?;
    let mut entrant = entrant(name, motion, false);
    let mut robot = Answering(Count::default());
    drive(&mut *entrant, &mut robot, cycles);
    Ok(())
}

/// Instructions of a cycle.
pub(crate) fn count(name: &str, motion: Motion) -> Option<f64> {
    named(name)?; // scripts are not counted
    let cycles = (MORE - FEWER) as f64;
    Some((collected(name, motion, MORE)? - collected(name, motion, FEWER)?) / cycles)
}

fn named(name: &str) -> Option<Name> {
    Name::ALL.into_iter().find(|it| it.name() == name)
}

fn collected(name: &str, motion: Motion, cycles: u64) -> Option<f64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args([name, motion.name(), &cycles.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find(|line| line.contains("Collected"))?;
    line.rsplit(' ').next()?.parse().ok()
}
