//! `tip view`.

use crate::support::Folder;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

const WAVE: &str = "MESSAGE hello\nPTP_ANGLE J11 10\nWAIT_INPOS ALL\nEND";

#[test]
fn a_program_becomes_a_page_in_this_folder() {
    let folder = Folder::new("view").program("in/wave.prg", WAVE);
    let outcome = folder.tip(&["view", "in/wave.prg"]).expect(0);
    assert!(outcome.out.is_empty());
    assert!(outcome.err.starts_with("wave.html: "), "{}", outcome.err);
    let page = folder.read("wave.html");
    assert!(page.contains("<title>test</title>"));
    folder
        .tip(&[
            "view",
            "in/wave.prg",
            "-q",
            "-o",
            "other.html",
            "--keys",
            "2:F",
        ])
        .expect(0);
    assert_ne!(folder.read("other.html"), page, "the key is in it");
}

#[test]
fn a_hyphen_is_standard_output_of_every_command_that_writes() {
    let folder = Folder::new("view-hyphen").program("wave.prg", WAVE);
    for (arguments, start) in [
        (&["view", "wave.prg"][..], "<!DOCTYPE html>"),
        (&["plot", "wave.prg"], "<svg "),
        (&["log", "wave.prg"], "cycle,time_ms,"),
        (&["emit", "label", "wave.prg"], ""),
        (&["robot", "export", "--urdf"], "<?xml "),
    ] {
        let outcome = folder.tip(&[arguments, &["-o", "-"]].concat()).expect(0);
        assert!(
            outcome.out.starts_with(start),
            "{arguments:?}: {}",
            outcome.out
        );
    }
    assert_eq!(folder.names(), ["wave.prg"]);
}

#[test]
fn a_plot_and_a_log_stand_in_this_folder_too() {
    let folder = Folder::new("view-plot").program("in/wave.prg", WAVE);
    let outcome = folder.tip(&["plot", "in/wave.prg"]).expect(0);
    assert_eq!(
        (outcome.out.as_str(), outcome.err.as_str()),
        ("", "wave.svg\n")
    );
    assert!(folder.read("wave.svg").starts_with("<svg "));
    let outcome = folder.tip(&["log", "in/wave.prg"]).expect(0);
    assert!(outcome.err.starts_with("wave.mcap: "), "{}", outcome.err);
    assert!(folder.has("wave.mcap"));
}

/// The data of an element of a page.
pub(crate) fn data<'a>(page: &'a str, id: &str) -> &'a str {
    let (_, rest) = page
        .split_once(&format!("id=\"{id}\">"))
        .expect("an element");
    rest.split('<').next().expect("text")
}

/// Returns the lines of a recording that is packed for a page.
fn lines(packed: &str) -> Vec<String> {
    let bytes = STANDARD.decode(packed).expect("base64");
    let bytes = miniz_oxide::inflate::decompress_to_vec(&bytes).expect("deflated");
    let text = String::from_utf8(bytes).expect("UTF-8");
    text.split('\n').map(str::to_owned).collect()
}

#[test]
fn two_runs_are_compared_on_one_page() {
    let folder = Folder::new("view-two")
        .program("a.prg", WAVE)
        .program("b.prg", &WAVE.replace("10", "20"));
    for name in ["a", "b"] {
        let (program, trace) = (format!("{name}.prg"), format!("{name}.jsonl"));
        folder
            .tip(&["run", &program, "--trace", &trace, "--trace-motion"])
            .expect(0);
    }
    let alone = |file: &str| {
        folder.tip(&["view", file, "-o", "alone.html"]).expect(0);
        data(&folder.read("alone.html"), "recording").to_owned()
    };
    assert_eq!(
        data(
            &{
                alone("a.prg");
                folder.read("alone.html")
            },
            "compared"
        ),
        ""
    );
    // Programs are run; traces are read, each with the program beside it.
    for ends in [
        ["a.prg", "b.prg"],
        ["a.jsonl", "b.jsonl"],
        ["a.prg", "b.jsonl"],
    ] {
        let [one, other] = ends;
        folder
            .tip(&["view", one, other, "-o", "two.html"])
            .expect(0);
        let page = folder.read("two.html");
        assert_eq!(data(&page, "recording"), alone(one), "{ends:?}");
        // The difference of the programs follows the other run.
        let compared = lines(data(&page, "compared"));
        assert_eq!(compared[..3], lines(&alone(other)), "{ends:?}");
        assert!(compared[3].contains("-PTP_ANGLE J11 10"), "{ends:?}");
        assert_ne!(alone(one), alone(other), "{ends:?}");
    }
    // A page of both has its own name, and does not take the place of one of the first run.
    folder.tip(&["view", "a.jsonl", "-q"]).expect(0);
    let alone = folder.read("a.html");
    let outcome = folder.tip(&["view", "a.jsonl", "b.prg"]).expect(0);
    assert_eq!(folder.read("a.html"), alone);
    assert!(folder.has("a-b.html"));
    // The joint of b goes twice as far and takes longer.
    let lines: Vec<_> = outcome.err.lines().collect();
    let [size, first, second] = lines.as_slice() else {
        panic!("{lines:?}");
    };
    assert!(size.starts_with("a-b.html: "), "{size}");
    assert!(first.starts_with("  a.jsonl: 0."), "{first}");
    assert!(second.starts_with("  b.prg: 0."), "{second}");
    assert_ne!(first.split_once(": "), second.split_once(": "));
    // With --program both are traces of it.
    folder
        .tip(&[
            "view",
            "a.jsonl",
            "a.jsonl",
            "--program",
            "a.prg",
            "-o",
            "two.html",
        ])
        .expect(0);
    std::fs::remove_file(folder.path("b.prg")).expect("it is there");
    let outcome = folder.tip(&["view", "a.jsonl", "b.jsonl"]).expect(2);
    assert_eq!(
        outcome.err,
        "error: b.jsonl is a trace: name the program that it is of by --program FILE.prg\n"
    );
}

fn trace_with_motion(folder: &Folder, trace: &str) {
    let run = ["run", "-q", "wave.prg", "--trace", trace, "--trace-motion"];
    folder.tip(&run).expect(0);
}

#[test]
fn a_cut_trace_is_shown_with_a_warning_and_a_damaged_one_is_refused() {
    let folder = Folder::new("view-cut").program("wave.prg", WAVE);
    trace_with_motion(&folder, "wave.jsonl");
    let whole = folder.read("wave.jsonl");
    let lines: Vec<&str> = whole.split_inclusive('\n').collect();
    let folder = folder
        .file("cut.jsonl", lines[..5].concat())
        .file("gap.jsonl", [&lines[..5], &lines[6..]].concat().concat());
    let tip = |command: &[&str]| folder.tip(&[command, &["--program", "wave.prg"]].concat());
    let shown = tip(&["view", "cut.jsonl", "-o", "cut.html"]).expect(0);
    let warning =
        "warning: cut.jsonl: the trace has no last record and is incomplete from cycle 5 on";
    assert!(shown.err.contains(warning), "{}", shown.err);
    for trace in ["cut.jsonl", "gap.jsonl"] {
        for pair in [[trace, "wave.jsonl"], ["wave.jsonl", trace]] {
            let compared = tip(&[&["compare"], &pair[..], &["--fail-if", "falls>0"]].concat());
            assert!(compared.err.contains(trace), "{}", compared.err);
            assert_eq!(compared.expect(1).out, "");
        }
    }
    let refused = tip(&["view", "gap.jsonl", "-o", "gap.html"]).expect(1);
    let reason = "gap.jsonl: line 6 is of cycle 6 where cycle 5 follows";
    assert!(refused.err.contains(reason), "{}", refused.err);
    assert!(!folder.has("gap.html"));
    let compared = tip(&[
        "compare",
        "wave.jsonl",
        "wave.jsonl",
        "--fail-if",
        "falls>0",
    ]);
    assert_eq!(compared.expect(0).err, "");
}

#[test]
fn a_run_without_end_stops_after_ten_minutes_and_says_so() {
    let folder =
        Folder::new("view-endless").program(
            "on.prg",
            "AGAIN:\nPTP F1 R 0 R 0 R 10\nSLEEP 30000\nPTP F1 R 0 R 0 R -10\nSLEEP 30000\nGOTO AGAIN:\nEND",
        );
    let outcome = folder.tip(&["view", "on.prg"]).expect(0);
    assert!(
        outcome
            .err
            .contains("600.000 s of robot time, 30000 cycles"),
        "{}",
        outcome.err
    );
    assert!(
        outcome.err.contains("stopped after 10 minutes"),
        "{}",
        outcome.err
    );
    let outcome = folder.tip(&["view", "on.prg", "--cycles", "50"]).expect(0);
    assert!(
        outcome.err.contains("50 cycles") && !outcome.err.contains("stopped"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_trace_with_motion_becomes_a_page_and_another_one_does_not() {
    let folder = Folder::new("view-trace").program("wave.prg", WAVE);
    trace_with_motion(&folder, "with.jsonl");
    folder
        .tip(&["run", "-q", "wave.prg", "--trace", "without.jsonl"])
        .expect(0);
    folder
        .tip(&["view", "with.jsonl", "--program", "wave.prg"])
        .expect(0);
    assert!(folder.has("with.html"));
    let outcome = folder
        .tip(&["view", "without.jsonl", "--program", "wave.prg"])
        .expect(1);
    assert!(outcome.err.contains("--trace-motion"), "{}", outcome.err);
    assert!(!folder.has("without.html"));
    folder
        .tip(&[
            "view",
            "with.jsonl",
            "--program",
            "wave.prg",
            "--cycles",
            "5",
        ])
        .expect(2);
    folder
        .tip(&["view", "missing.jsonl", "--program", "wave.prg"])
        .expect(1);
}

#[test]
fn an_emergency_has_a_page_and_a_bad_program_has_none() {
    let folder = Folder::new("view-bad")
        .program("far.prg", "REM\nPTP F1 9999 0 0\nEND")
        .program("bad.prg", "PTTP F1\nEND");
    folder.tip(&["view", "far.prg"]).expect(0);
    assert!(folder.has("far.html"));
    let outcome = folder.tip(&["view", "bad.prg"]).expect(1);
    assert!(outcome.err.contains("bad.prg:3"), "{}", outcome.err);
    assert!(!folder.has("bad.html"));
    let outcome = folder.tip(&["view", "far.prg", "-o", "far.prg"]).expect(1);
    assert!(
        outcome.err.contains("which is being read"),
        "{}",
        outcome.err
    );
}

#[test]
fn a_sensor_that_the_robot_lacks_is_refused() {
    let folder = Folder::new("view-sensor").program("wave.prg", WAVE);
    let outcome = folder
        .tip(&[
            "view", "wave.prg", "--robot", "hand", "--sensor", "PAW1=1@0",
        ])
        .expect(2);
    assert!(outcome.err.contains("has no input PAW1"), "{}", outcome.err);
    assert!(!folder.has("wave.html"));
}
