//! Ctrl-C as a key, and a signal, on a compiled program.

use rustix::process::{Pid, Signal, kill_process};
use rustix::pty::{OpenptFlags, grantpt, ioctl_tiocgptpeer, openpt, unlockpt};
use rustix::termios::tcgetattr;
use std::fs;
use std::os::fd::OwnedFd;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// Returns both ends of a pseudo terminal: that of the fingers, and that of the process.
fn terminal() -> (OwnedFd, OwnedFd) {
    let flags = OpenptFlags::RDWR | OpenptFlags::NOCTTY;
    let fingers = openpt(flags).expect("a pseudo terminal");
    grantpt(&fingers).expect("ours");
    unlockpt(&fingers).expect("ours");
    let line = ioctl_tiocgptpeer(&fingers, flags).expect("its other end");
    (fingers, line)
}

/// Returns the settings for keys, in words that can be compared.
fn behaviour(line: &OwnedFd) -> String {
    format!("{:?}", tcgetattr(line).expect("a terminal"))
}

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
    let (fingers, line) = terminal();
    let before = behaviour(&line);
    let input = line.try_clone().expect("another handle");
    let mut child = walk(&["--realtime"], input.into());
    while behaviour(&line) == before {
        require_running(&mut child);
    }
    assert_eq!(rustix::io::write(&fingers, b"\x03"), Ok(1));
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(1));
    let told = String::from_utf8_lossy(&output.stdout);
    assert!(told.contains("Emergency; body"), "{told}");
    assert_eq!(behaviour(&line), before);
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
