//! `tip run --plant exec:COMMAND`: a robot that a process simulates.

use crate::dap::Client;
use crate::support::Folder;
use serde_json::json;
use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::time::{Duration, Instant};

/// Joints that are immediately where they are commanded to be; the body goes forward by 1 mm in each cycle.
const SCRIPT: &str = r#"
while read -r line; do
  n=${line#*\"n\":} n=${n%%,*}
  initial=${line#*\"initial\":} initial=${initial%%]*}]
  targets=${line#*\"targets\":} targets=${targets%%]*}]
  loads='"loads":[10,20,30,40]'
  case $line in
    *\"hello\"*) echo "{\"version\":2,\"angles\":$initial,$loads,\"pose\":[0,0,200,0,0,0]}" ;;
    *\"cycle\"*)
      if [ "$n" = "$1" ]; then eval "$2"; fi
      echo "{\"n\":$n,\"angles\":$targets,$loads,\"pose\":[0,$((n + 1)),200,0,0,0]}" ;;
    *\"bye\"*) echo "good-bye" >&2; exit 0 ;;
  esac
done
"#;

const PROGRAM: &str = "PTP_ANGLE F1 R 10 R -5 R 7.25\nWAIT_INPOS F1\nMESSAGE there\nEND";

fn folder(name: &str) -> Folder {
    Folder::new(name)
        .program("nod.prg", PROGRAM)
        .file("sim.sh", SCRIPT)
}

#[test]
fn a_process_simulates_the_robot() {
    let folder = folder("external");
    let run = [
        "run",
        "nod.prg",
        "--plant",
        "exec:sh sim.sh",
        "--trace",
        "nod.jsonl",
    ];
    let outcome = folder
        .tip(&[&run[..], &["--trace-motion"]].concat())
        .expect(0);
    assert_eq!(outcome.out, "there\n");
    // Its standard error is passed on; falls are not ours to count.
    let lines: Vec<&str> = outcome.err.lines().collect();
    let cycles = folder.read("nod.jsonl").lines().count() - 1;
    let ended = format!("nod.prg: END at line 6 after {cycles} cycles, ");
    let said: Vec<_> = lines
        .iter()
        .filter(|line| line.starts_with(&ended))
        .collect();
    assert_eq!(said.len(), 1, "{outcome:#?}");
    let travel = format!("  travel  {cycles}.0 mm forward, 0.0 mm to the right, 0.0 mm up");
    assert!(lines.contains(&travel.as_str()), "{outcome:#?}");
    assert!(lines.contains(&"good-bye"), "{outcome:#?}");
    assert!(!outcome.err.contains("falls"), "{outcome:#?}");
    let trace = folder.read("nod.jsonl");
    let first = trace.lines().next().unwrap_or_default();
    assert!(
        first.contains(r#""pose":[0.0,1.0,200.0,0.0,0.0,0.0],"angles":[["#)
            && first.ends_with(r#""loads":[10.0,20.0,30.0,40.0]}"#),
        "{first}"
    );
    // What it did can be looked at.
    folder
        .tip(&[
            "view",
            "nod.jsonl",
            "--program",
            "nod.prg",
            "-o",
            "nod.html",
        ])
        .expect(0);
    assert!(folder.has("nod.html"));
}

#[test]
fn a_fault_of_the_process_is_an_emergency_stop() {
    let folder = folder("external-fault");
    let plant =
        r#"exec:sh sim.sh 3 'echo "{\"n\":3,\"angles\":[0,0,90,NaN,0,90,0,0,90,0,0,90]}"; read x'"#;
    let run = [
        "run",
        "nod.prg",
        "--plant",
        plant,
        "--out-dir",
        "logs",
        "--quiet",
    ];
    let outcome = folder.tip(&run).expect(3);
    let said = "the external plant's answer to 'cycle 3': 'angles[3]' is not finite";
    assert!(outcome.err.contains(said), "{outcome:#?}");
    assert!(
        outcome
            .err
            .contains("TIP_ERR:Hardware fault plant: answer is not finite"),
        "{outcome:#?}"
    );
    assert!(folder.read("logs/EMG.log").contains(
        "
TIP_ERR:Hardware fault plant: answer is not finite (RobotError)
"
    ));
    let outcome = folder
        .tip(&[&run[..], &["--lang", "ja"]].concat())
        .expect(3);
    assert!(
        outcome
            .err
            .contains("'cycle 3' への外部プラントの応答: 'angles[3]' が有限の値ではありません"),
        "{outcome:#?}"
    );
}

#[test]
fn a_process_that_is_not_there() {
    let folder = folder("external-none");
    let outcome = folder
        .tip(&[
            "run",
            "nod.prg",
            "--plant",
            "exec:./none x",
            "--out-dir",
            "logs",
            "--trace",
            "nod.trace",
        ])
        .expect(1);
    assert!(!folder.has("logs") && !folder.has("nod.trace"));
    assert!(
        outcome
            .err
            .contains("the external plant './none' does not start: "),
        "{outcome:#?}"
    );
}

#[test]
fn a_signal_ends_run_and_process() {
    let folder = folder("external-signal");
    let plant = "exec:sh sim.sh 3 'echo waits >&2; exec sleep 60'";
    let mut command = folder.command(&["run", "nod.prg", "--plant", plant]);
    let begin = Instant::now();
    let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let mut child = child.expect("tip starts");
    let mut said = BufReader::new(child.stderr.take().expect("a pipe")).lines();
    let waits = said.next().expect("it says something").expect("text");
    assert_eq!(waits, "waits");
    // Its answer to cycle 3 never comes.
    let pid = child.id().to_string();
    let kill = std::process::Command::new("kill")
        .args(["-INT", &pid])
        .status();
    assert!(kill.is_ok_and(|status| status.success()));
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert!(begin.elapsed() < Duration::from_secs(20));
}

/// A command that is told twice to end does not wait, and leaves nobody behind.
#[test]
fn a_second_signal_ends_what_the_process_started() {
    let folder = folder("external-signals");
    let plant =
        "exec:sh sim.sh 3 'sleep 300 & echo $! >&2; trap : TERM INT; while :; do wait; done'";
    let mut command = folder.command(&["run", "nod.prg", "--plant", plant]);
    let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let mut child = child.expect("tip starts");
    let mut said = BufReader::new(child.stderr.take().expect("a pipe")).lines();
    let sleeper = said.next().expect("it says something").expect("text");
    let pid = child.id().to_string();
    for _ in 0..2 {
        let kill = std::process::Command::new("kill")
            .args(["-INT", &pid])
            .status();
        assert!(kill.is_ok_and(|status| status.success()));
    }
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    let begin = Instant::now();
    let lives = || {
        let shown = std::process::Command::new("ps")
            .args(["-o", "stat=", "-p", &sleeper])
            .output();
        let state = shown.expect("there is ps").stdout;
        !state.is_empty() && !state.starts_with(b"Z")
    };
    while lives() {
        assert!(begin.elapsed() < Duration::from_secs(20), "{sleeper} lives");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn what_a_process_cannot_do_is_refused_with_a_way_out() {
    let folder = folder("external-refused").file("level.toml", "[floor]\nfriction = 0.9\n");
    let plant = ["--plant", "exec:sh sim.sh"];
    let cases: [(&[&str], &str); 8] = [
        (&["verify", "nod.prg"], "`tip run`"),
        (&["debug", "nod.prg"], "`tip run`"),
        (&["serve", "nod.prg"], "`tip run`"),
        (&["view", "nod.prg"], "`tip view FILE --program PROGRAM`"),
        (
            &["log", "nod.prg", "-o", "nod.csv"],
            "`tip view FILE --program PROGRAM`",
        ),
        (
            &["plot", "nod.prg", "-o", "nod.svg"],
            "`tip view FILE --program PROGRAM`",
        ),
        (
            &["run", "nod.prg", "--scene", "level.toml"],
            "pass the scene to the process",
        ),
        (
            &["run", "nod.prg", "--deny", "falls"],
            "need a built-in plant",
        ),
    ];
    for (command, way_out) in cases {
        let outcome = folder.tip(&[command, &plant[..]].concat()).expect(2);
        assert!(outcome.err.contains(way_out), "{command:?} {outcome:#?}");
        assert!(!outcome.err.contains("good-bye"), "{command:?} started it");
    }
    assert_eq!(
        folder.names(),
        ["level.toml", "nod.prg", "sim.sh"],
        "nothing is written"
    );
}

#[test]
fn a_plant_that_is_none_is_refused() {
    let folder = folder("external-word");
    let refused = |plant: &str| {
        folder
            .tip(&["run", "nod.prg", "--plant", plant])
            .expect(2)
            .err
    };
    assert!(refused("dynamics").contains(
        "there is no plant `dynamics`; the plants are quasi-static and dynamic, and a process of your own as `exec:COMMAND`"
    ));
    assert!(refused("exec:").contains("is not a command line"));
    assert!(refused("exec:sh 'a").contains("`sh 'a` is not a command line"));
    folder
        .tip(&["run", "nod.prg", "--plant", "dynamic"])
        .expect(0);
}

#[test]
fn a_process_is_no_plant_of_a_debugger() {
    let folder = folder("external-dap");
    let program = folder.path("nod.prg");
    let mut client = Client::new();
    client.ask("initialize", json!({ "adapterID": "tip" }));
    let mut refused =
        |plant: &str| client.refusal("launch", json!({ "program": program, "plant": plant }));
    assert!(refused("exec:sh sim.sh").contains("`tip run`"));
    assert!(refused("dynamics").contains("there is no plant `dynamics`"));
}
