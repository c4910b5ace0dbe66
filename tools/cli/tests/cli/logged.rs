//! `tip log` and `tip plot`.

use crate::support::Folder;
use rustix::process::{Pid, Signal, kill_process};
use std::process::Stdio;
use std::time::{Duration, Instant};

const TEXT: &str =
    "DEF_VAR COUNT\nCOUNT = 3\nMESSAGE count is %COUNT%\nPTP_ANGLE J11 9\nWAIT_INPOS ALL\nEND";

#[test]
fn the_ending_says_what_a_log_is() {
    let folder = Folder::new("logged").program("turn.prg", TEXT);
    let table = folder.tip(&["log", "turn.prg", "-o", "turn.csv"]).expect(0);
    assert!(table.err.contains("turn.csv: "), "{}", table.err);
    let csv = folder.read("turn.csv");
    let mut lines = csv.lines();
    assert!(
        lines
            .next()
            .is_some_and(|head| head.starts_with("cycle,time_ms,step,line,"))
    );
    let cycles = lines.count();
    folder
        .tip(&["log", "turn.prg", "-o", "few.csv", "--every", "4"])
        .expect(0);
    // Every fourth one from 0, and the last.
    let expected = (cycles - 1).div_ceil(4) + 1;
    assert_eq!(folder.read("few.csv").lines().count() - 1, expected);
    folder
        .tip(&["log", "turn.prg", "-o", "turn.mcap"])
        .expect(0);
    let mcap = std::fs::read(folder.path("turn.mcap")).expect("it is written");
    assert!(mcap.starts_with(b"\x89MCAP0\r\n") && mcap.ends_with(b"\x89MCAP0\r\n"));
    let other = folder.tip(&["log", "turn.prg", "-o", "turn.txt"]).expect(2);
    assert!(other.err.contains(".mcap or .csv"), "{}", other.err);
    assert!(!folder.has("turn.txt"));
}

#[test]
fn a_plot_speaks_the_language_that_is_asked_for() {
    let folder = Folder::new("plotted").program("turn.prg", TEXT);
    folder
        .tip(&["plot", "turn.prg", "-o", "turn.svg", "--lang", "ja"])
        .expect(0);
    assert!(folder.read("turn.svg").contains("各脚の第1関節の角度"));
    let gait = [
        "plot", "turn.prg", "-o", "gait.svg", "--of", "gait", "--lang", "en",
    ];
    folder.tip(&gait).expect(0);
    let svg = folder.read("gait.svg");
    assert!(
        svg.contains("Gait diagram") && !svg.contains("Angle of joint"),
        "{svg}"
    );
}

#[test]
fn how_the_run_ends_is_the_exit_status() {
    let folder = Folder::new("log-ends")
        .program("stops.prg", "PTP F1 0 0 0\nEND")
        .program("endless.prg", "AGAIN:\nGOTO AGAIN:\nEND")
        .program("wrong.prg", "NOTHING\nEND");
    let stops = folder
        .tip(&["log", "stops.prg", "-o", "stops.csv"])
        .expect(3);
    assert!(stops.err.contains("emergency stop"), "{}", stops.err);
    assert!(folder.has("stops.csv"));
    let endless = ["plot", "endless.prg", "-o", "endless.svg", "--of", "angles"];
    let still = folder.tip(&endless).expect(0).err;
    let reason = "stopped after 60 s without a motion: lines 3 to 4 have repeated";
    assert!(still.contains(reason), "{still}");
    let few = folder
        .tip(&[&endless[..], &["--cycles", "9"]].concat())
        .expect(0);
    assert!(!few.err.contains("stopped after"), "{}", few.err);
    folder
        .tip(&["log", "wrong.prg", "-o", "wrong.csv"])
        .expect(1);
    assert!(!folder.has("wrong.csv"));
    let itself = folder
        .tip(&["plot", "stops.prg", "-o", "stops.prg"])
        .expect(1);
    assert!(itself.err.contains("which is being read"), "{}", itself.err);
}

/// Ctrl-C ends the command soon, whether it records or writes; the earlier file stays, or the new one is complete.
#[test]
fn ctrl_c_ends_a_log_soon_and_leaves_no_part() {
    let folder = Folder::new("logged-ctrl-c").program("on.prg", "AGAIN:\nREM\nGOTO AGAIN:\nEND");
    for wait in [0, 100, 600] {
        std::fs::write(folder.path("on.csv"), "earlier").expect("it is ours");
        let mut command =
            folder.command(&["log", "on.prg", "--cycles", "100000000", "-o", "on.csv"]);
        let mut child = command.stderr(Stdio::null()).spawn().expect("tip starts");
        std::thread::sleep(Duration::from_millis(300 + wait));
        let began = Instant::now();
        while child.try_wait().expect("it was started").is_none() {
            kill_process(Pid::from_child(&child), Signal::INT)
                .expect("nobody has waited for it yet");
            std::thread::sleep(Duration::from_millis(20));
        }
        assert!(began.elapsed() < Duration::from_secs(3), "{wait}");
        assert_eq!(child.wait().expect("it ends").code(), Some(130));
        assert_eq!(folder.names(), ["on.csv", "on.prg"]);
        let table = folder.read("on.csv");
        assert!(table == "earlier" || table.ends_with("\r\n"), "{wait}");
    }
}
