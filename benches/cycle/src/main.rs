//! Prints the table of docs/performance.md; with the name of a run, runs that once for callgrind to count.
#![forbid(unsafe_code)]

use cycle::runs::{self, Run, finish};
use cycle::stopwatch::{Times, time};
use std::env;
use std::io::{self, Write};

/// Runs of each machine.
const REPEATS: usize = 50;

fn main() -> io::Result<()> {
    let mut out = io::stdout();
    match env::args().nth(1) {
        Some(name) => once(&mut out, &name),
        None => table(&mut out),
    }
}

fn once(out: &mut impl Write, name: &str) -> io::Result<()> {
    let cycles = match name {
        "walk" => finish(&mut runs::walk()),
        "heavy-walk" => finish(&mut runs::heavy_walk()),
        "walk-replayed" => finish(&mut runs::walk_replayed()),
        "six-legs" => finish(&mut runs::six_legs()),
        "heavy-six-legs" => finish(&mut runs::heavy_six_legs()),
        "six-legs-replayed" => finish(&mut runs::six_legs_replayed()),
        "grasp" => finish(&mut runs::grasp()),
        "grasp-replayed" => finish(&mut runs::grasp_replayed()),
        _ => return writeln!(out, "no run is called {name}"),
    };
    writeln!(out, "{cycles} cycles")
}

fn table(out: &mut impl Write) -> io::Result<()> {
    writeln!(
        out,
        "| run | median, µs | p99.9, µs | worst, µs | worst with disturbances, µs | × real time |\n\
         |---|---|---|---|---|---|"
    )?;
    row(out, "TITAN VIII walks", &runs::walk())?;
    row(out, "with mass", &runs::heavy_walk())?;
    row(out, "without the plant", &runs::walk_replayed())?;
    row(out, "a hexapod walks", &runs::six_legs())?;
    row(out, "with mass", &runs::heavy_six_legs())?;
    row(out, "without the plant", &runs::six_legs_replayed())?;
    row(out, "Hiroshima Hand grasps", &runs::grasp())?;
    row(out, "without the plant", &runs::grasp_replayed())
}

fn row<R: Run + Clone>(out: &mut impl Write, name: &str, ready: &R) -> io::Result<()> {
    let Times {
        median,
        p999,
        worst,
        disturbed,
        real_time,
    } = time(ready, REPEATS);
    let [median, p999, worst, disturbed] =
        [median, p999, worst, disturbed].map(|time| time.as_nanos() as f64 / 1000.0);
    writeln!(
        out,
        "| {name} | {median:.2} | {p999:.2} | {worst:.2} | {disturbed:.0} | {real_time:.0} |"
    )
}
