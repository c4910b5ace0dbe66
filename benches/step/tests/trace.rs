//! Every entrant asks for the same commands with the same values in the same control cycles.

use native::motion::Motion;
use native::{Name, entrant};
use step::roster::roster;
use step::trace;

/// More than one turn of the longest motion.
const CYCLES: u64 = 15_000;

fn expected(motion: Motion) -> u64 {
    let mut interpreter = entrant(Name::Interpreter, motion, true);
    trace(&mut *interpreter, CYCLES)
}

#[test]
fn all_traces_are_one() {
    for motion in Motion::ALL {
        for entry in roster() {
            let found = trace(&mut *entry.entrant(motion, true), CYCLES);
            assert_eq!(found, expected(motion), "{} in {motion:?}", entry.name);
        }
    }
}

#[test]
fn motions_have_traces_of_their_own() {
    let mut traces: Vec<u64> = Motion::ALL.into_iter().map(expected).collect();
    traces.sort_unstable();
    traces.dedup();
    assert_eq!(traces.len(), Motion::ALL.len());
}

#[test]
fn generated_motions_are_as_long_as_they_say() {
    for (motion, steps) in [
        (Motion::Steps100, 100),
        (Motion::Steps1000, 1_000),
        (Motion::Steps10000, 10_000),
    ] {
        assert_eq!(motion.program().steps().len(), steps);
    }
}
