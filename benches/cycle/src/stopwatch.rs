//! Time of each cycle of a run.

use crate::runs::Run;
use std::time::{Duration, Instant};

/// Times of the cycles of a run. A cycle's time is the least of several runs: its time when nothing
/// disturbs it.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// Half of all cycles are quicker.
    pub median: Duration,
    /// 99.9 % of all cycles are quicker.
    pub p999: Duration,
    /// The slowest cycle.
    pub worst: Duration,
    /// The slowest cycle of all runs, with whatever the operating system did in it.
    pub disturbed: Duration,
    /// Time on the robot against time on one core.
    pub real_time: f64,
}

/// Runs a machine from start to end `repeats` times.
pub fn time<R: Run + Clone>(ready: &R, repeats: usize) -> Times {
    let mut cycles: Vec<Duration> = Vec::new();
    let mut disturbed = Duration::ZERO;
    let mut simulated = 0.0;
    for _ in 0..repeats {
        let mut run = ready.clone();
        simulated = 0.0;
        for n in 0.. {
            simulated += run.period() / 1000.0;
            let start = Instant::now();
            let goes_on = run.cycle();
            let took = start.elapsed();
            disturbed = disturbed.max(took);
            match cycles.get_mut(n) {
                Some(least) => *least = took.min(*least),
                None => cycles.push(took),
            }
            if !goes_on {
                break;
            }
        }
    }
    let total: f64 = cycles.iter().map(Duration::as_secs_f64).sum();
    cycles.sort_unstable();
    let rank = |share: f64| cycles[((cycles.len() - 1) as f64 * share).ceil() as usize];
    Times {
        median: rank(0.5),
        p999: rank(0.999),
        worst: rank(1.0),
        disturbed,
        real_time: simulated / total,
    }
}
