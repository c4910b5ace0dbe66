//! No form costs more than in proportion when it is repeated, and none takes more stack or panics. Forms of every kind are repeated on
//! lines and pieces along a line, in both editions, and go through all that reads programs. All statements of the tables are read too,
//! without a measurement: a form with other words costs the same.
//!
//! Work is measured here in processor time of the thread, which other processes hardly add to, as a ratio: four times the text may
//! cost five times as much, where a square costs sixteen. A ratio that is too high is measured again, the least of several runs, and
//! at four times the size: a square stays, noise goes. No absolute time is compared. This is an alarm: squares with a small factor
//! show only in the instructions that `tests/external/operations/run` counts. Stacks are those of threads, 2 MiB; a thread has the
//! name of its unit, which the message of an overflow shows.

use robustness::repetitions::{
    CHECK, CYCLES, Reader, Unit, all_statements, fix, forms, long_programs, pieces,
};
use robustness::{dap, lsp};
use rustix::time::{ClockId, clock_gettime};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

/// A reader of any text.
type TextReader = fn(&str);

/// Returns the processor time of a reader on this thread; `None` if it has nothing to do.
fn cost((_, reader): Reader, text: &str) -> Option<Duration> {
    let now = || {
        let now = clock_gettime(ClockId::ThreadCPUTime);
        Duration::new(now.tv_sec as u64, now.tv_nsec as u32)
    };
    let before = now();
    reader(text).then(|| now() - before)
}

fn least_cost(reader: Reader, text: &str, runs: usize) -> Option<Duration> {
    (0..runs).filter_map(|_| cost(reader, text)).min()
}

/// Returns how many times as much four times the text costs, if that is too much.
fn excess(unit: &Unit, reader: Reader) -> Option<f64> {
    let mut ratio = 0.0;
    // Below that, caches and the allocator count for more than the text.
    let noise = Duration::from_micros(200);
    for (size, runs) in [(1, 1), (1, 3), (4, 3)] {
        let count = size * unit.count;
        let (short, long) = (unit.program(count), unit.program(4 * count));
        let short = least_cost(reader, &short, runs)?.max(noise);
        let long = least_cost(reader, &long, runs)?;
        ratio = long.as_secs_f64() / short.as_secs_f64();
        if ratio <= 5.0 {
            return None;
        }
    }
    Some(ratio)
}

/// Returns what is wrong with a reader of a unit.
fn judge(unit: &Unit, reader: Reader) -> Option<String> {
    if let Some(ratio) = excess(unit, reader) {
        return Some(format!("{ratio:.1} times"));
    }
    if reader.0 == CYCLES.0 {
        // What is in proportion may still be far too much for each line.
        let text = unit.program(4 * unit.count);
        let [counting, checking] = [CYCLES, CHECK].map(|reader| least_cost(reader, &text, 1));
        let (counting, checking) = (counting?, checking?);
        let dear = counting > 30 * checking + Duration::from_millis(50);
        return dear.then(|| format!("{counting:?}"));
    }
    None
}

/// Requires work in proportion of units, each under a reader.
fn examine(pairs: &[(Unit, Reader)]) {
    on_two_threads(pairs, |(unit, reader)| judge(unit, *reader));
}

/// Judges units under readers, each on a thread of its own, two at a time.
fn on_two_threads(
    pairs: &[(Unit, Reader)],
    judge: impl Fn(&(Unit, Reader)) -> Option<String> + Sync,
) {
    let next = AtomicUsize::new(0);
    let failures = Mutex::new(Vec::new());
    let work = || {
        while let Some(pair) = pairs.get(next.fetch_add(1, Ordering::Relaxed)) {
            let name = format!("{} of {}", pair.1.0, pair.0.name());
            let failure = thread::scope(|scope| {
                let named = thread::Builder::new()
                    .name(name.clone())
                    .stack_size(2 << 20);
                let worker = named.spawn_scoped(scope, || judge(pair)).expect("a thread");
                worker.join().unwrap_or_else(|_| Some("a panic".to_owned()))
            });
            let failure = failure.map(|failure| format!("{name}: {failure}"));
            failures.lock().expect("no panic").extend(failure);
        }
    };
    thread::scope(|scope| {
        scope.spawn(work);
        work();
    });
    let failures = failures.into_inner().expect("no panic");
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn forms_on_lines_cost_in_proportion() {
    examine(&forms());
}

#[test]
fn every_statement_is_read_without_a_panic() {
    on_two_threads(&all_statements(), |(unit, (_, reader))| {
        let text = unit.program(unit.count);
        if unit.between == "\n" {
            fix(&text);
        }
        reader(&text);
        None
    });
}

#[test]
fn pieces_on_a_line_cost_in_proportion() {
    examine(&pieces());
}

#[test]
fn long_programs_cost_in_proportion() {
    examine(&long_programs());
}

/// Every other reader of files and texts takes deep and long input without more stack.
#[test]
fn no_reader_recurses_with_the_length_of_its_input() {
    let openers = [
        "[", "{", "(", "<a>", "<a><b>", "\"", "'", "a.", "a=", "a={", "a=[", "-", "!", "{\"a\":",
        "[[a]]\n", "[a]\n", "<!--", "&", "1,",
    ];
    let readers: [(&str, TextReader); 6] = [
        ("description", |text| {
            robustness::description::examine(text.as_bytes())
        }),
        ("scene", |text| robustness::scene::examine(text.as_bytes())),
        ("urdf", |text| robustness::urdf::examine(text.as_bytes())),
        ("requests", |text| {
            robustness::requests::examine(text.as_bytes())
        }),
        ("lsp", |text| lsp::examine(text.as_bytes())),
        ("events", |text| drop(text.parse::<tip_sim::Events>())),
    ];
    for opener in openers {
        let text = opener.repeat(20_000);
        for (name, reader) in readers {
            let named = thread::Builder::new().name(format!("{name} of {opener:?}"));
            let text = text.clone();
            let worker = named.spawn(move || reader(&text)).expect("a thread");
            assert!(worker.join().is_ok(), "{name} of {opener:?}");
        }
        // An expression of the debugger.
        let named = thread::Builder::new().name(format!("dap of {opener:?}"));
        let worker = named.spawn(move || dap::debug("3.1\nT\nREM\nEND\n", &[&text]));
        assert!(
            worker.expect("a thread").join().is_ok(),
            "dap of {opener:?}"
        );
    }
}
