//! Ctrl-C as a signal, at several moments.

use super::Row;
use super::bench::{Bench, RUN};
use super::terminal::Pty;
use crate::support::Folder;
use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::io::Read;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::Duration;

const PLACE: &str = "Ctrl-C, or SIGINT";
const INTERRUPTED: &str = "interrupted";

const WAITS: &str = "LOG_START\nMESSAGE go\nKEY_IN\nEND";
const MOVES: &str = "LOG_START\nMESSAGE go\nL1:\nPTP F1 -391 281 -160\nWAIT_INPOS F1\nPTP F1 -391 201 -200\n\
                     WAIT_INPOS F1\nGOTO L1:\nEND";
/// Talks to someone who does not listen, until the pipe is full.
const TALKS: &str =
    "LOG_START\nL1:\nMESSAGE and so on and so on and so on and so on and so on\nGOTO L1:\nEND";
/// The rows that TITAN.LOG holds at most.
const ROWS: usize = 10_000;

pub(super) fn rows() -> Vec<Row> {
    let row = |fault, outcome, runs| Row {
        place: PLACE,
        fault,
        outcome,
        runs,
    };
    vec![
        row(
            "while the run begins",
            "ends like any process if the run has not begun, all earlier files stay; else interrupted",
            times(20, at_the_start),
        ),
        row("in a wait", INTERRUPTED, times(5, |n| under_way(WAITS, n))),
        row("in motion", INTERRUPTED, times(5, |n| under_way(MOVES, n))),
        row(
            "repeatedly while the logs are written",
            INTERRUPTED,
            times(3, while_logs_are_written),
        ),
        row(
            "twice, while it is blocked on a full pipe",
            "ends at once with status 130; the earlier trace and logs stay",
            times(1, |_| stuck(Stdio::null())),
        ),
        row(
            "once, while it is blocked on a full pipe, or before a pipe that nobody reads",
            "ends within 3 s with status 130; the earlier trace and logs stay",
            times(1, |_| stuck_once()) + times(1, |_| never_read()) + times(2, never_shown),
        ),
        row(
            "another signal: SIGTERM or SIGHUP",
            "interrupted, with status 143 or 129",
            times(2, |n| by_another(n as usize)),
        ),
        row(
            "ignored before the run begins, as by `nohup` and in background jobs; SIGHUP likewise",
            "goes on; SIGTERM interrupts it",
            times(2, |n| ignored(n as usize)),
        ),
        row(
            "at a terminal, as a key",
            "interrupted; the terminal behaves as before",
            times(2, |n| at_a_terminal(n, |pty, _| pty.press(0x03))),
        ),
        row(
            "at a terminal, as a signal",
            "interrupted; the terminal behaves as before",
            times(2, |n| at_a_terminal(n, |_, child| interrupt(child))),
        ),
        row(
            "at a terminal, twice, while it is blocked on a full pipe",
            "ends at once with status 130; the earlier trace and logs stay; the terminal behaves as before",
            times(1, |_| stuck_at_a_terminal()),
        ),
    ]
}

fn times(runs: usize, run: impl Fn(u64)) -> usize {
    (0..runs as u64).for_each(run);
    runs
}

fn spawn(bench: &Bench, input: Stdio) -> Child {
    let mut command = bench.folder.command(&RUN);
    command.stdin(input).stdout(Stdio::piped());
    command.stderr(Stdio::null()).spawn().expect("tip starts")
}

/// Waits for the message that proves that the run is under way.
fn first_message(child: &mut Child) {
    let mut first = [0; 3];
    let out = child.stdout.as_mut().expect("piped");
    out.read_exact(&mut first).expect("the message");
    assert_eq!(first, *b"go\n");
}

fn pid(child: &Child) -> Pid {
    Pid::from_child(child)
}

fn interrupt(child: &Child) {
    kill_process(pid(child), Signal::INT).expect("nobody has waited for it yet");
}

/// Interrupts a run that may not have begun. Tests that ignore the signal start it through `env`, which ignores it too until it
/// replaces itself by the run: such a signal is sent again.
fn interrupted(child: &mut Child) -> ExitStatus {
    loop {
        interrupt(child);
        for _ in 0..1000 {
            if let Some(status) = child.try_wait().expect("it is a child") {
                return status;
            }
            sleep(Duration::from_millis(10));
        }
    }
}

fn at_the_start(n: u64) {
    let bench = Bench::endless("signal-start", WAITS);
    let mut child = spawn(&bench, Stdio::null());
    sleep(Duration::from_micros(300 * n));
    let status = interrupted(&mut child);
    if status.code().is_some() {
        require_complete(&bench, status);
    } else {
        assert_eq!(bench.texts(), bench.earlier);
        bench.require_no_parts();
    }
}

fn under_way(statements: &str, n: u64) {
    let bench = Bench::endless("signal-run", statements);
    let mut child = spawn(&bench, Stdio::null());
    first_message(&mut child);
    sleep(Duration::from_millis(3 * n));
    interrupt(&child);
    require_complete(&bench, child.wait().expect("it ends"));
}

fn by_another(n: usize) {
    let bench = Bench::endless("signal-other", WAITS);
    let mut child = spawn(&bench, Stdio::null());
    first_message(&mut child);
    let (signal, status) = [(Signal::TERM, 143), (Signal::HUP, 129)][n];
    kill_process(pid(&child), signal).expect("nobody has waited for it yet");
    require_ended(&bench, child.wait().expect("it ends"), status);
}

/// Signals that are ignored from the beginning do nothing, and the one that ends the run is the one that the status names.
fn ignored(n: usize) {
    let bench = Bench::endless("signal-ignored", WAITS);
    let mut command = Command::new("sh");
    command.args(["-c", "trap '' INT HUP; exec \"$@\"", "sh"]);
    command.arg(env!("CARGO_BIN_EXE_tip")).args(RUN);
    command.current_dir(bench.folder.path("."));
    command.stdin(Stdio::null()).stdout(Stdio::piped());
    let mut child = command.stderr(Stdio::null()).spawn().expect("it starts");
    first_message(&mut child);
    let signal = [Signal::INT, Signal::HUP][n];
    for _ in 0..3 {
        kill_process(pid(&child), signal).expect("nobody has waited for it yet");
        sleep(Duration::from_millis(50));
    }
    assert!(child.try_wait().expect("ours").is_none(), "it goes on");
    kill_process(pid(&child), Signal::TERM).expect("it goes on");
    require_ended(&bench, child.wait().expect("it ends"), 143);
}

/// A folder goes away while a run is under way; later Ctrl-C ends it.
pub(super) fn folder_vanishes(folder: &str) -> Bench {
    let bench = Bench::endless("vanished", WAITS);
    let mut child = spawn(&bench, Stdio::null());
    first_message(&mut child);
    fs::remove_dir_all(bench.folder.path(folder)).expect("ours");
    interrupt(&child);
    assert_eq!(child.wait().expect("it ends").code(), Some(1));
    bench.require_no_parts();
    bench
}

fn while_logs_are_written(_: u64) {
    let bench = Bench::endless("signal-logs", WAITS);
    let mut child = spawn(&bench, Stdio::null());
    first_message(&mut child);
    sleep(Duration::from_millis(100));
    interrupt(&child);
    let logs = bench.folder.path("logs");
    let is_part = |name: &str| name.ends_with(".part");
    let has_part = || {
        let entries = fs::read_dir(&logs).expect("the folder of the logs");
        entries
            .flatten()
            .any(|entry| is_part(&entry.file_name().to_string_lossy()))
    };
    while !has_part() && child.try_wait().expect("ours").is_none() {}
    let status = interrupt_to_its_end(&mut child, Duration::from_micros(100));
    require_complete(&bench, status);
}

fn interrupt_to_its_end(child: &mut Child, pause: Duration) -> ExitStatus {
    loop {
        if let Some(status) = child.try_wait().expect("ours") {
            return status;
        }
        interrupt(child);
        sleep(pause);
    }
}

fn stuck(input: Stdio) {
    let bench = Bench::endless("signal-stuck", TALKS);
    let mut child = spawn(&bench, input);
    while !sleeps(&child) {
        assert!(child.try_wait().expect("ours").is_none(), "it runs");
    }
    let status = interrupt_to_its_end(&mut child, Duration::from_millis(5));
    assert_eq!(status.code(), Some(130));
    // WARNING.LOG is written before the run.
    assert_eq!(bench.texts()[1..], bench.earlier[1..]);
    bench.require_no_parts();
}

/// One signal, and nothing else.
fn stuck_once() {
    let bench = Bench::endless("signal-stuck-once", TALKS);
    let mut child = spawn(&bench, Stdio::null());
    while !sleeps(&child) {
        assert!(child.try_wait().expect("ours").is_none(), "it runs");
    }
    interrupt(&child);
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert_eq!(bench.texts()[1..], bench.earlier[1..]);
    bench.require_no_parts();
}

/// The trace goes to a pipe that nobody reads.
fn never_read() {
    let bench = Bench::endless("signal-unread", WAITS);
    let mut arguments = RUN;
    arguments[5] = "pipe";
    wait_for_a_reader(&bench.folder, &arguments);
    assert_eq!(bench.texts(), bench.earlier);
}

/// A page or a plot of a run that is over goes to a pipe that nobody reads.
fn never_shown(n: u64) {
    let folder = Folder::new("signal-unshown").program("short.prg", "ALL_STOP\nEND");
    let command = ["view", "plot"][n as usize];
    wait_for_a_reader(&folder, &[command, "short.prg", "-o", "pipe"]);
}

/// Runs a command that writes to the pipe, until one signal ends it.
fn wait_for_a_reader(folder: &Folder, arguments: &[&str]) {
    let made = Command::new("mkfifo").arg(folder.path("pipe")).status();
    assert!(made.expect("mkfifo starts").success());
    let mut command = folder.command(arguments);
    let mut child = command.stdout(Stdio::null()).spawn().expect("tip starts");
    // It catches the signal before it looks for a reader.
    sleep(Duration::from_millis(500));
    assert!(child.try_wait().expect("ours").is_none(), "it waits");
    interrupt(&child);
    let status = child.wait().expect("it ends");
    assert!(matches!(status.code(), Some(130) | None), "{status}");
}

/// Returns true if the first thread sleeps, now and for a while.
fn sleeps(child: &Child) -> bool {
    let stat = format!("/proc/{}/stat", child.id());
    (0..10).all(|_| {
        sleep(Duration::from_millis(5));
        let stat = fs::read_to_string(&stat).expect("it runs");
        stat.rsplit(')').next().expect("a name").starts_with(" S")
    })
}

fn at_a_terminal(n: u64, press: impl Fn(&Pty, &Child)) {
    let bench = Bench::endless("signal-terminal", MOVES);
    let pty = Pty::new();
    let before = pty.behaviour();
    let mut child = spawn(&bench, pty.input());
    first_message(&mut child);
    assert_ne!(pty.behaviour(), before, "keys arrive one by one");
    sleep(Duration::from_millis(3 * n));
    press(&pty, &child);
    require_complete(&bench, child.wait().expect("it ends"));
    assert_eq!(pty.behaviour(), before);
}

fn stuck_at_a_terminal() {
    let pty = Pty::new();
    let before = pty.behaviour();
    stuck(pty.input());
    assert_eq!(pty.behaviour(), before);
}

/// The run was interrupted, and its files hold every cycle until then.
fn require_complete(bench: &Bench, status: ExitStatus) {
    require_ended(bench, status, 130);
}

fn require_ended(bench: &Bench, status: ExitStatus, code: i32) {
    assert_eq!(status.code(), Some(code));
    bench.require_no_parts();
    require_logs(bench, require_trace(bench));
}

/// The trace is complete; returns its number of cycles.
pub(super) fn require_trace(bench: &Bench) -> usize {
    let [.., trace] = bench.texts();
    let trace = trace.expect("a trace");
    let cycles = trace.lines().count() - 1;
    let end = format!(r#"{{"end":"INTERRUPTED","cycles":{cycles}}}"#);
    assert_eq!(trace.lines().last(), Some(end.as_str()));
    cycles
}

/// TITAN.LOG holds so many cycles, and nothing is of the earlier run.
fn require_logs(bench: &Bench, cycles: usize) {
    let [_, titan, variables, emergency, _] = bench.texts();
    assert_eq!((variables, emergency), (None, None), "of the earlier run");
    let titan = titan.unwrap_or_default();
    let mut lines = titan.lines().skip(1);
    let columns = |line: &str| line.split('\t').count();
    let headings = lines.next().map_or(0, columns);
    let rows: Vec<_> = lines.collect();
    assert_eq!(rows.len(), cycles.min(ROWS));
    assert!(rows.iter().all(|row| columns(row) == headings));
    assert!(rows.is_empty() || titan.ends_with('\n'));
}
