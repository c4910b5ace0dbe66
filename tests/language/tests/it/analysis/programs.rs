//! Programs that run, the language cases and the random ones, and what their runs do.
#![expect(clippy::disallowed_methods, reason = "tests read their cases")]

use crate::analysis::watched::{Seen, Watched};
use lockstep::Script;
use random_programs::{Edition, Specimen};
use std::sync::{Arc, LazyLock, Mutex};
use std::{env, fs};
use tip_sim::{Event, Inputs, Plant};
use tip_tests::{Settings, cases, root, run};
use tipc::program::Program;
use tipc::{Options, Robot};

/// Default number of random programs of each edition: enough to reach reads that find a value on some paths only.
/// `TIP_PROGRAMS=50000` before a run of `no_run_contradicts` in release mode takes so many.
const SEEDS: u64 = 1_000;

/// Maximum number of traces that are kept.
const KEPT: usize = 5_000;

/// Observations of the runs of all programs.
pub(crate) struct Runs {
    /// The reads that they came to.
    pub(crate) seen: Seen,
    /// The first programs that were run to their ends or limits, with their traces.
    pub(crate) traces: Vec<(Runnable, String)>,
}

/// Every program run once, its reads watched.
pub(crate) static RUNS: LazyLock<Runs> = LazyLock::new(|| {
    let seen = Arc::new(Mutex::new(Seen::new()));
    let mut traces = Vec::new();
    for one in all() {
        let watched = Watched::new(&one.name, one.program.clone(), Arc::clone(&seen));
        // A program that never ends by itself has no whole trace.
        if let Ok(trace) = run(watched, &one.settings)
            && traces.len() < KEPT
        {
            traces.push((one, trace));
        }
    }
    let seen = std::mem::take(&mut *seen.lock().expect("no read panics"));
    Runs { seen, traces }
});

/// A program, and what happens around it.
pub(crate) struct Runnable {
    pub(crate) name: String,
    pub(crate) program: Program,
    pub(crate) settings: Settings,
}

/// Every case with a trace, then every random program.
pub(crate) fn all() -> impl Iterator<Item = Runnable> {
    let folder = root().join("cases");
    let names = cases(&folder);
    let of_case = move |name: String| {
        let expectation = folder.join(format!("{name}.trace"));
        let header = fs::read_to_string(&expectation).unwrap_or_default();
        let beside = expectation.parent().expect("a case stands in a folder");
        let runs = Settings::of_header(&header, beside).expect("a header");
        let source = fs::read(folder.join(format!("{name}.prg"))).expect("a program");
        let of_robot = move |settings| runnable(name.clone(), &source, settings);
        // A case without a trace does not run.
        let runs = runs.into_iter().filter(move |_| !header.is_empty());
        runs.filter_map(of_robot)
    };
    let of_seed = |Specimen {
                       seed,
                       robot,
                       source,
                   }: Specimen| {
        let settings = random_settings(robot, seed);
        runnable(format!("seed {seed}"), source.as_bytes(), settings)
    };
    let asked = env::var("TIP_PROGRAMS").ok();
    let seeds = asked.map_or(SEEDS, |count| count.parse().expect("a number"));
    let random = Edition::ALL.iter().flat_map(move |edition| {
        (0..seeds).map(move |seed| random_programs::program(*edition, seed))
    });
    let of_cases = names.into_iter().flat_map(of_case);
    of_cases.chain(random.filter_map(of_seed))
}

/// Keys are typed while a random program runs.
fn random_settings(robot: Robot, seed: u64) -> Settings {
    let script = Script::random(robot, seed, 0, 800, Plant::Simulated);
    let events = script.inputs.events.into_iter();
    // A halt request is the ESC key.
    let typed = events.filter(|timed| matches!(timed.event, Event::Key(_) | Event::Halt));
    let inputs = Inputs {
        events: typed.collect(),
        cycles: script.inputs.cycles,
    };
    Settings {
        load: Options {
            robot,
            ..Options::default()
        },
        inputs: inputs.to_string(),
        ..Settings::default()
    }
}

fn runnable(name: String, source: &[u8], settings: Settings) -> Option<Runnable> {
    let program = tipc::load(&name, source, &settings.load).program?;
    Some(Runnable {
        name,
        program,
        settings,
    })
}
