//! The time of a control cycle: the least of many short measurements that all entrants take in turn, so
//! that whatever else the machine does disturbs none of them more than the others.

use native::motion::Motion;
use native::robot::{Answering, Count};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};
use step::drive;
use step::roster::roster;

/// Measurements of each entrant.
const ROUNDS: usize = 60;
/// Control cycles of one measurement; the longest motion has fewer in one turn.
const CYCLES: u64 = 15_000;

/// Nanoseconds of a cycle of each entrant.
pub(crate) fn measure(motion: Motion) -> BTreeMap<&'static str, f64> {
    let mut robot = Answering(Count::default());
    let mut runs: Vec<_> = roster()
        .iter()
        .map(|entry| (entry.name, entry.entrant(motion, false), Duration::MAX))
        .collect();
    for _ in 0..ROUNDS {
        for (_, entrant, least) in &mut runs {
            let start = Instant::now();
            drive(&mut **entrant, &mut robot, CYCLES);
            *least = start.elapsed().min(*least);
        }
    }
    runs.iter()
        .map(|(name, _, least)| (*name, least.as_secs_f64() * 1e9 / CYCLES as f64))
        .collect()
}
