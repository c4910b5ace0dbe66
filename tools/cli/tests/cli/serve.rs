//! `tip serve`: what viewers at WebSockets see and do.

pub(crate) mod client;
mod driving;
mod editing;
mod hostile;

use crate::support::Folder;
use client::{Server, Socket};
use serde_json::json;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

/// Counts its cycles; says which key was pressed and what VR1 reads.
const COUNTS: &str = "DEF_VAR N\nDEF_VAR K\nDEF_VAR V\nN = 0\nLOOP:\nN = N + 1\nAD_IN VR1 V\nIF KB_HIT THEN\nKEY_IN K\nMESSAGE key\nENDIF\nIF HALT_REQUEST THEN\nEXIT\nENDIF\nGOTO LOOP:\nEND";

fn counts(name: &str) -> Folder {
    Folder::new(name).program("counts.prg", COUNTS)
}

#[test]
fn the_page_and_the_run_are_there_until_ctrl_c() {
    let server = Server::begin(&counts("serve-page"), &["counts.prg"]);
    assert!(
        server.address().starts_with("http://127.0.0.1:"),
        "only this machine"
    );
    let reply = server.get(&server.target("/"), &[]);
    assert!(reply.starts_with("HTTP/1.1 200 OK\r\n"), "{reply:.200}");
    for part in [
        "Content-Security-Policy",
        "Referrer-Policy: no-referrer",
        "<title>tip serve</title>",
    ] {
        assert!(reply.contains(part), "{part}");
    }
    let mut viewer = server.viewer();
    let run = viewer.update("run");
    assert_eq!(
        (&run["run"], &run["robot"]["name"]),
        (&json!(1), &json!("titan8"))
    );
    assert_eq!(run["inputs"][0], "VR1");
    let first = viewer.update("more")["cycles"].as_u64();
    assert!(viewer.update("more")["cycles"].as_u64() > first, "it runs");
    assert_eq!(server.end(), Some(130));
    assert!(viewer.is_over(), "it is sent away");
}

#[test]
fn the_runs_of_a_table_open_from_its_page() {
    let folder = Folder::new("serve-table").program(
        "lift.prg",
        "DEF_VAR Z\nZ = 20\nSTAND_UP Z\nWAIT_INPOS ALL\nEND",
    );
    let sweep = [
        "sweep", "lift.prg", "--vary", "Z=10,30", "-q", "-o", "runs.csv",
    ];
    folder.tip(&sweep).expect(0);
    let body = |reply: &str| {
        let (head, body) = reply.split_once("\r\n\r\n").expect("a response");
        assert!(head.starts_with("HTTP/1.1 200 OK"), "{head}");
        body.to_owned()
    };
    let server = Server::begin(&folder, &["runs.csv"]);
    let table = body(&server.get(&server.target("/"), &[]));
    assert!(table.contains(r#""is_served":true"#) && table.contains("<title>runs.csv</title>"));
    folder
        .tip(&["view", "runs.csv", "--case", "1", "-o", "one.html"])
        .expect(0);
    let run = body(&server.get(&server.target("/case/1"), &[]));
    assert!(
        run == folder.read("one.html"),
        "the page that tip view writes"
    );
    for (target, status) in [
        (server.target("/case/2"), "404"),
        (server.target("/case/"), "404"),
        (server.target("/case/-1"), "404"),
        (server.target("/live"), "404"),
        ("/case/1".to_owned(), "403"),
    ] {
        let reply = server.get(&target, &[]);
        assert!(
            reply.starts_with(&format!("HTTP/1.1 {status} ")),
            "{target}: {reply:.100}"
        );
    }
    // The table is read again for each request.
    std::fs::write(folder.path("runs.csv"), "a,b\n").expect("it is a file");
    let reply = server.get(&server.target("/case/1"), &[]);
    assert!(reply.starts_with("HTTP/1.1 500 "), "{reply:.100}");
    assert_eq!(server.end(), Some(130));
    // A file without the columns of a table, options that a table fixes, its specification, and a table that does not exist are refused.
    folder.tip(&["serve", "runs.csv"]).expect(1);
    for options in [
        &["--hardware", "robot.toml"][..],
        &["--paused"],
        &["--robot", "a1"],
        &["--keys", "3:F"],
    ] {
        let refused = folder.tip(&[&["serve", "runs.csv"], options].concat());
        let refused = refused.expect(2).err;
        assert!(
            refused.contains(&format!("leave out {}", options[0])),
            "{refused}"
        );
    }
    let refused = folder.tip(&["serve", "runs.sweep.json"]).expect(2).err;
    assert!(refused.contains("give the table runs.csv"), "{refused}");
    folder.tip(&["serve", "none.csv"]).expect(1);
}

#[test]
fn it_runs_in_real_time() {
    let server = Server::begin(&counts("serve-time"), &["counts.prg"]);
    let mut viewer = server.viewer();
    viewer.until(|viewer| viewer.cycles >= 5);
    let (begin, first) = (std::time::Instant::now(), viewer.cycles);
    viewer.until(|viewer| viewer.cycles >= first + 100);
    let cycles = (viewer.cycles - first) as f64;
    let took = begin.elapsed().as_secs_f64();
    // 20 ms each; a busy machine may be late, nobody is early by more than an update.
    assert!(took > 0.02 * cycles - 0.2, "{cycles} cycles in {took} s");
}

#[test]
fn a_key_a_knob_and_a_halt_reach_the_program() {
    let server = Server::begin(&counts("serve-key"), &["counts.prg", "--paused"]);
    let mut viewer = server.viewer();
    viewer.does(json!({"do": "event", "event": "key F"}));
    viewer.does(json!({"do": "event", "event": "VR1=7.5"}));
    viewer.does(json!({"do": "step", "cycles": 20}));
    viewer.until(|viewer| viewer.cycles == 21);
    assert_eq!(viewer.messages, ["key"]);
    assert_eq!(viewer.value("V"), Some(7.5));
    assert_eq!(viewer.value("K"), Some(70.0));
    viewer.does(json!({"do": "play"}));
    viewer.does(json!({"do": "event", "event": "halt"}));
    viewer.until(|viewer| viewer.status["over"] == true);
    assert_eq!(viewer.status["outcome"]["how"], "EXIT");
}

#[test]
fn an_emergency_stop_ends_the_run_and_it_begins_again() {
    let server = Server::begin(&counts("serve-stop"), &["counts.prg"]);
    let mut viewer = server.viewer();
    viewer.until(|viewer| viewer.cycles > 10);
    viewer.does(json!({"do": "event", "event": "key 0x0D"}));
    viewer.until(|viewer| viewer.status["over"] == true);
    assert_eq!(viewer.status["outcome"]["how"], "emergency");
    assert_eq!(viewer.ask(json!({"do": "play"}))["error"], "over");
    viewer.does(json!({"do": "restart"}));
    viewer.until(|viewer| viewer.run == 2);
}

/// Each connection restarts the run, as often as it can; the stop of another viewer ends the run nonetheless.
#[test]
fn a_viewer_that_restarts_all_the_time_does_not_undo_a_stop() {
    let server = Server::begin(&counts("serve-flood"), &["counts.prg"]);
    let mut viewer = server.viewer();
    viewer.until(|viewer| viewer.cycles > 10);
    let is_over = AtomicBool::new(false);
    let refused = AtomicU64::new(0);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !is_over.load(Ordering::Relaxed) {
                let answer = server.viewer().ask(json!({"do": "restart"}));
                if answer["error"] == "over" {
                    refused.fetch_add(1, Ordering::Relaxed);
                }
            }
        });
        viewer.until(|viewer| viewer.run > 5);
        viewer.does(json!({"do": "event", "event": "key 0x0D"}));
        viewer.until(|viewer| viewer.status["over"] == true);
        let run = viewer.run;
        while refused.load(Ordering::Relaxed) < 50 {
            std::thread::sleep(Duration::from_millis(5));
        }
        // What was sent before the answer has arrived with it.
        viewer.ask(json!({"do": "pause"}));
        assert_eq!((viewer.run, &viewer.status["over"]), (run, &json!(true)));
        is_over.store(true, Ordering::Relaxed);
    });
    // The one that stopped the robot moves it on when it wants to.
    let run = viewer.run;
    viewer.does(json!({"do": "restart"}));
    viewer.until(|viewer| viewer.run > run);
}

#[test]
fn stepping_back_shows_the_state_that_was() {
    let server = Server::begin(&counts("serve-back"), &["counts.prg", "--paused"]);
    let mut viewer = server.viewer();
    viewer.does(json!({"do": "step", "cycles": 40}));
    viewer.until(|viewer| viewer.cycles == 41);
    let earlier = viewer.shown();
    viewer.does(json!({"do": "step", "cycles": 30}));
    viewer.until(|viewer| viewer.cycles == 71);
    assert_ne!(viewer.shown(), earlier);
    viewer.does(json!({"do": "step", "cycles": -30}));
    viewer.until(|viewer| viewer.cycles == 41);
    assert_eq!(viewer.shown(), earlier);
}

#[test]
fn viewers_see_the_same_run_and_one_that_comes_back_sees_it_whole() {
    let server = Server::begin(&counts("serve-two"), &["counts.prg"]);
    let (mut one, mut other) = (server.viewer(), server.viewer());
    one.until(|viewer| viewer.cycles > 10);
    other.does(json!({"do": "pause"}));
    one.until(|viewer| viewer.status["playing"] == false);
    other.until(|viewer| viewer.status["playing"] == false);
    one.does(json!({"do": "step", "cycles": 3}));
    let cycles = one.settled();
    assert_eq!(other.settled(), cycles);
    assert_eq!(one.shown(), other.shown());
    drop(other);
    one.does(json!({"do": "step", "cycles": 2}));
    one.until(|viewer| viewer.cycles == cycles + 2);
    let mut again = server.viewer();
    assert_eq!(again.settled(), cycles + 2);
    assert_eq!(again.shown(), one.shown());
}

#[test]
fn a_viewer_that_takes_nothing_holds_up_nobody() {
    let server = Server::begin(&counts("serve-slow"), &["counts.prg"]);
    let sleeper: Socket = server.viewer();
    let mut viewer = server.viewer();
    viewer.does(json!({"do": "speed", "times": 50}));
    viewer.until(|viewer| viewer.cycles > 2000);
    drop(sleeper);
    viewer.does(json!({"do": "pause"}));
}

/// A page that drives a robot would stop driving it if it lost its connection.
#[test]
fn a_server_that_is_suspended_for_a_moment_keeps_its_viewers() {
    let server = Server::begin(&counts("serve-suspended"), &["counts.prg"]);
    let mut viewer = server.viewer();
    for _ in 0..20 {
        let cycles = viewer.cycles;
        viewer.until(|viewer| viewer.cycles > cycles + 2);
        server.suspend();
    }
    viewer.does(json!({"do": "pause"}));
}

#[test]
fn what_cannot_be_served_is_said() {
    let folder = counts("serve-not").program("bad.prg", "PTTP F1\nEND");
    let outcome = folder.tip(&["serve", "bad.prg"]).expect(1);
    assert!(
        outcome.err.contains("bad.prg:3") && outcome.out.is_empty(),
        "{outcome:?}"
    );
    folder.tip(&["serve", "-"]).expect(2);
    folder
        .tip(&["serve", "counts.prg", "--listen", "nowhere"])
        .expect(2);
    let outcome = folder
        .tip(&["serve", "counts.prg", "--listen", "203.0.113.1:0"])
        .expect(1);
    assert!(outcome.err.contains("203.0.113.1:0"), "{outcome:?}");
    folder
        .tip(&[
            "serve",
            "counts.prg",
            "--robot",
            "hand",
            "--sensor",
            "PAW1=1@0",
        ])
        .expect(2);
}
