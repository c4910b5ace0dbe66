//! No form costs more than in proportion when it is repeated, and none takes more stack or panics. Forms of every kind are repeated on
//! lines and pieces along a line, in both editions, and go through all that reads programs. All statements of the tables are read too,
//! without a measurement: a form with other words costs the same.
//!
//! Work is counted in processor time of the thread, which other processes do not add to, as a ratio: four times the text may cost five
//! times as much, where a square costs sixteen. A ratio that is too high is measured again, the least of several runs, and at four
//! times the size: a square stays, noise goes. No absolute time is compared. Stacks are those of threads, 2 MiB; a thread has the name of
//! its unit, which the message of an overflow shows.

use super::units::{FORMS, HEAD, PIECES, statements};
use robustness::{dap, lsp};
use rustix::time::{ClockId, clock_gettime};
use std::borrow::Borrow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;
use tip_lint::cycles::{Sampling, human, parts};
use tip_lint::migrate::migrate_to;
use tip_lint::repair::{confirm, preview};
use tip_lint::{format, load};
use tipc::diagnostic::Applicability;
use tipc::emit;
use tipc::language::Edition;
use tipc::source::Encoding;
use tipc::{Options, Robot};

/// A reader of any text.
type TextReader = fn(&str);

/// A reader of programs and its name. It returns false if it has nothing to do with a program.
type Reader = (&'static str, fn(&str) -> bool);

const CHECK: Reader = ("check", check);
const FMT: Reader = ("fmt", fmt);
const LSP: Reader = ("lsp", edit);
const CYCLES: Reader = ("cycles", cycles);
const MIGRATE: Reader = ("migrate", migrate);
const DAP: Reader = ("dap", debug);
const EMIT: Reader = ("emit", emit);

const ALL: [Reader; 7] = [CHECK, FMT, LSP, CYCLES, MIGRATE, DAP, EMIT];

fn options() -> Options {
    Options::default()
}

fn check(text: &str) -> bool {
    drop(load("test.prg", text.as_bytes(), &options()));
    true
}

/// Tries all fixes. Their number is bounded by the bytes that are read again, not by the text (`bounded` of tip-lint).
fn fix(text: &str) {
    let loaded = load("test.prg", text.as_bytes(), &options());
    if !loaded.diagnostics.is_empty() {
        drop(confirm(loaded.clone(), &options()));
        drop(preview(loaded, &options(), Applicability::Likely));
    }
}

fn fmt(text: &str) -> bool {
    drop(format::format("test.prg", text.as_bytes(), &options()));
    true
}

fn cycles(text: &str) -> bool {
    let program = tipc::load("test.prg", text.as_bytes(), &options()).program;
    let Some(program) = program else {
        return false;
    };
    let sampling = Sampling::of(Robot::default());
    drop(human(&program, &parts(&program, sampling), sampling));
    true
}

fn emit(text: &str) -> bool {
    let program = tipc::load("test.prg", text.as_bytes(), &options()).program;
    let Some(program) = program else {
        return false;
    };
    assert!(emit::pretty(&program, &emit::Options::default()).is_ok());
    true
}

fn migrate(text: &str) -> bool {
    let Some(rest) = text.strip_prefix("3.1") else {
        return false;
    };
    drop(migrate_to(
        Edition::V3_2,
        "test.prg",
        text.as_bytes(),
        Encoding::Auto,
    ));
    let older = format!("2.0{rest}");
    drop(migrate_to(
        Edition::V3_1,
        "test.prg",
        older.as_bytes(),
        Encoding::Auto,
    ));
    true
}

fn edit(text: &str) -> bool {
    lsp::edit(text);
    true
}

fn debug(text: &str) -> bool {
    dap::debug(text, &["V > 3", "V + 1", "C1 + C2", "NONE"])
}

/// A form that is repeated.
struct Unit {
    edition: Edition,
    text: String,
    between: &'static str,
    /// Number of repetitions of the shorter program.
    count: usize,
}

impl Unit {
    fn name(&self) -> String {
        format!("{} {:?} {:?}", self.edition, self.text, self.between)
    }

    /// Returns a program with so many repetitions.
    fn program(&self, count: usize) -> String {
        let mut text = format!("{}\nT\n{HEAD}", self.edition);
        for number in 0..count {
            let scattered = number * 7_919 % count;
            let one = self.text.replace("{n}", &number.to_string());
            let one = one.replace("{m}", &scattered.to_string());
            text += &one.replace("{t}", &(number + 1).to_string());
            text += self.between;
        }
        text + "\nEND\n"
    }
}

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

/// Requires work in proportion of units, each under some readers.
fn examine(units: &[(Unit, Vec<Reader>)]) {
    let pairs = units.iter();
    let pairs = pairs.flat_map(|(unit, readers)| readers.iter().map(move |it| (unit, *it)));
    on_two_threads(&pairs.collect::<Vec<_>>(), |(unit, reader)| {
        judge(unit, *reader)
    });
}

/// Judges units under readers, each on a thread of its own, two at a time.
fn on_two_threads<U: Borrow<Unit> + Sync>(
    pairs: &[(U, Reader)],
    judge: impl Fn(&(U, Reader)) -> Option<String> + Sync,
) {
    let next = AtomicUsize::new(0);
    let failures = Mutex::new(Vec::new());
    let work = || {
        while let Some(pair) = pairs.get(next.fetch_add(1, Ordering::Relaxed)) {
            let name = format!("{} of {}", pair.1.0, pair.0.borrow().name());
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

fn unit(edition: Edition, text: &str, between: &'static str, count: usize) -> Unit {
    Unit {
        edition,
        text: text.to_owned(),
        between,
        count,
    }
}

/// Takes a unit under every reader, each in one edition; what 3.1 lacks is an unknown word there.
#[test]
fn forms_on_lines_cost_in_proportion() {
    let units = FORMS.iter().enumerate().flat_map(|(index, text)| {
        ALL.into_iter().enumerate().map(move |(turn, reader)| {
            let edition = match (index + turn) % 2 {
                0 => Edition::V3_1,
                _ => Edition::V3_2,
            };
            (unit(edition, text, "\n", 30), vec![reader])
        })
    });
    examine(&units.collect::<Vec<_>>());
}

/// Statements are many, so each goes through one reader on lines and one along a line.
#[test]
fn every_statement_is_read_without_a_panic() {
    let of = |edition: &Edition| {
        let statements = statements(*edition).into_iter().enumerate();
        let units = statements.flat_map(|(index, text)| {
            let turn = index + usize::from(*edition == Edition::V3_2);
            let lines = unit(*edition, &text, "\n", 3);
            let between = if index % 2 == 0 { "; " } else { " " };
            let line = unit(*edition, &text, between, 8);
            [
                (lines, ALL[turn % ALL.len()]),
                (line, [CHECK, FMT][turn % 2]),
            ]
        });
        units.collect::<Vec<_>>()
    };
    let units: Vec<_> = Edition::ALL.iter().flat_map(of).collect();
    on_two_threads(&units, |(unit, (_, reader))| {
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
    let of = |edition: &Edition| {
        let units = PIECES.iter().map(|piece| {
            let readers = vec![CHECK, FMT];
            (unit(*edition, piece, "", 300), readers)
        });
        units.collect::<Vec<_>>()
    };
    examine(&Edition::ALL.iter().flat_map(of).collect::<Vec<_>>());
}

/// Forms whose cost shows in long programs only.
#[test]
fn long_programs_cost_in_proportion() {
    let [first, next] = [Edition::V3_1, Edition::V3_2];
    examine(&[
        (unit(first, "SET_A_MAX F1 -1", "\n", 2_000), vec![MIGRATE]),
        (unit(first, "A_", "", 15_000), vec![CHECK, FMT]),
        (unit(first, "A\u{FF1A}", "", 5_000), vec![CHECK, FMT]),
        (unit(first, "DEF_VAR A ", "", 5_000), vec![CHECK, FMT]),
        (
            unit(first, "L{n}: REM\nIF KB_HIT GOTO L{m}:", "\n", 400),
            vec![CYCLES],
        ),
        (
            unit(first, "FOR V = 0.5 TO 999{n}.7 STEP 0.01\nNEXT", "\n", 100),
            vec![CYCLES],
        ),
        (unit(next, "DEFINE C{n} {n}", "\n", 500), vec![CHECK]),
        (
            unit(next, "DEFINE C{n} {n} ; SLEEP C{n}", "\n", 500),
            vec![DAP],
        ),
    ]);
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
