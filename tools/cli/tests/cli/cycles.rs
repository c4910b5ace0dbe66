//! `tip cycles`

use crate::support::Folder;
use std::fs;
use std::path::Path;

/// Returns the text after `start` in the code block of docs/analysis.md that begins with it.
fn shown(kind: &str, start: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/analysis.md");
    let text = fs::read_to_string(path).expect("docs/analysis.md is part of the repository");
    let fence = format!("```{kind}\n");
    let mut blocks = text.split(&fence);
    let block = blocks.find_map(|block| block.strip_prefix(start));
    let (code, _) = block
        .and_then(|block| block.split_once("```"))
        .expect("a block");
    code.to_owned()
}

/// The program of docs/analysis.md.
fn step(test: &str) -> Folder {
    Folder::new(test).file("step.prg", format!("3.1\n{}", shown("tip", "3.1\n")))
}

// clauses: 2.12 2.13 2.15 2.17
#[test]
fn the_table_tells_least_and_most() {
    let outcome = step("cycles-table").tip(&["cycles", "step.prg"]).expect(0);
    // LIFT: SUBROUTINE, IF, perhaps MESSAGE, ENDIF, SUBEND. A turn of FOR: CALL, LIFT, NEXT; FOR and REM around three.
    let lines = outcome.lines();
    assert_eq!(lines[0], "step.prg for titan8, 20 ms a cycle");
    let rows: Vec<String> = lines[1..].iter().map(|line| words(line)).collect();
    assert_eq!(
        rows,
        [
            "part lines cycles ms",
            "subroutine LIFT 10 4 to 5 80 to 100",
            "turn of FOR I = 1 TO 3, 3 in all 4-6 6 to 7 120 to 140",
            "turn of LOOP 8-9 3 60 and waits",
            "start to LOOP 4-8 20 to 23 400 to 460",
            "LOOP to LOOP 8 3 60 and waits",
            "LIFT to RETURN 10 4 to 5 80 to 100",
        ]
    );
    assert_eq!(outcome.err, "");
    assert_eq!(outcome.out, shown("text", "$ tip cycles step.prg\n"));
}

fn words(line: &str) -> String {
    line.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn tools_get_one_object_a_line() {
    let outcome = step("cycles-json").tip(&["cycles", "--message-format", "json", "step.prg"]);
    let outcome = outcome.expect(0);
    let objects: Vec<serde_json::Value> = outcome
        .lines()
        .iter()
        .map(|line| serde_json::from_str(line).expect("an object"))
        .collect();
    assert_eq!(objects.len(), 6);
    assert_eq!(objects[1]["turns"], 3);
    assert_eq!(objects[3]["to"], "LOOP");
    assert_eq!(
        (&objects[3]["min"], &objects[3]["max_ms"]),
        (&20.into(), &460.into())
    );
    assert_eq!(objects[4]["waits"], true);
}

#[test]
fn the_robot_gives_the_sampling_time() {
    let folder = Folder::new("cycles-robot").program("rest.prg", "REM\nEND");
    let arguments = [
        "cycles",
        "--robot",
        "hand",
        "--message-format",
        "short",
        "rest.prg",
    ];
    let outcome = folder.tip(&arguments).expect(0);
    assert_eq!(
        outcome.lines(),
        ["rest.prg:3: start to END: 2 cycles, 4 ms"]
    );
}

#[test]
fn a_program_that_does_not_load_is_not_counted() {
    let folder = Folder::new("cycles-broken").program("broken.prg", "NONSENSE\nEND");
    let outcome = folder.tip(&["cycles", "broken.prg"]).expect(1);
    assert!(outcome.err.contains("Unknown command"), "{outcome:?}");
    assert_eq!(outcome.out, "");
    let outcome = folder.tip(&["cycles", "missing.prg"]).expect(1);
    assert!(outcome.err.contains("File not found"), "{outcome:?}");
}
