//! Ctrl-C as a key, and a signal, on a compiled program.

#[path = "../../../../tools/cli/tests/cli/faults/terminal.rs"]
mod terminal;

use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use terminal::Pty;

fn walk(arguments: &[&str], input: Stdio) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_walk"));
    command.args(arguments).stdin(input).stdout(Stdio::piped());
    command.spawn().expect("it starts")
}

fn require_running(child: &mut Child) {
    assert!(child.try_wait().expect("ours").is_none(), "it runs");
}

#[test]
fn the_key_stops_the_robot_and_the_terminal_behaves_as_before() {
    let pty = Pty::new();
    let before = pty.behaviour();
    let mut child = walk(&["--realtime"], pty.input());
    while pty.behaviour() == before {
        require_running(&mut child);
    }
    pty.press(0x03);
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(1));
    let told = String::from_utf8_lossy(&output.stdout);
    assert!(told.contains("Emergency; body"), "{told}");
    assert_eq!(pty.behaviour(), before);
}

#[test]
fn the_signal_ends_the_process_and_leaves_the_earlier_trace() {
    let folder = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("interrupted");
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder).expect("the target folder is writable");
    let trace = folder.join("interrupted.jsonl");
    fs::write(&trace, "an earlier one\n").expect("the target folder is writable");
    let name = trace.to_string_lossy();
    let mut child = walk(&["--trace", &name], Stdio::null());
    let part = loop {
        require_running(&mut child);
        let entries = fs::read_dir(folder).expect("the folder of the trace");
        let mut paths = entries.flatten().map(|entry| entry.path());
        if let Some(part) = paths.find(|path| path.extension() == Some("part".as_ref())) {
            break part;
        }
    };
    // No one catches TERM here, nor INT, which is ignored in the background jobs of a shell.
    kill_process(Pid::from_child(&child), Signal::TERM).expect("it runs");
    let status = child.wait().expect("it ends");
    assert_eq!(status.signal(), Some(Signal::TERM.as_raw()));
    let text = fs::read_to_string(&trace).expect("it is there");
    assert_eq!(text, "an earlier one\n");
    fs::remove_file(part).expect("a process that is ended leaves it");
}
