//! The fault campaign for the files that a run writes and for Ctrl-C: the second half of docs/faults.md.

mod bench;
mod files;
mod signals;
mod terminal;

use std::path::Path;
use std::{env, fs};

/// A fault, where it was, and its outcome.
struct Row {
    place: &'static str,
    fault: &'static str,
    outcome: &'static str,
    runs: usize,
}

const HEADING: &str = "\n## Files and Ctrl-C\n";

const HEAD: &str = "
What `tipc run PROGRAM --out-dir FOLDER --trace FILE` does if its files cannot be written, or if it is interrupted. An earlier run of the
same program had written all five files. In every case each file is either the complete earlier one or the complete new one; no partial file is
left.

| where | fault | outcome | runs |
|---|---|---|---|
";

const TAIL: &str = "
A read-only file is one that nobody may write, as after `chmod a-w`; it is refused to the system administrator too. *Refused*: the run stops before
the first cycle with `TIP_ERR:File can not write(…) (PreprocessError)`, status 1, and all earlier files stay. *Reported at the end*: the program runs
to its end, every file that can be written is new, then the run ends with the same error and status 1. *Interrupted*: status 130; the trace ends with
`INTERRUPTED`, and the logs hold all cycles up to that point.

A compiled program writes its logs with the same `LogFiles`. Where it reads the keys of a terminal, Ctrl-C is a key, which stops the robot like
RETURN. The signal ends it like any process, unless its host catches it; then the earlier files stay, and partial files are left next to them
as `.tip-RANDOM.part`. `cargo test -p walk --test interrupt` tests both.

`cargo test -p tipc-cli --test cli faults` makes these runs, on Linux, and compares this half of the page; with `TIP_BLESS=1` it
rewrites it.
";

#[test]
fn whatever_happens_to_files_and_runs_has_its_outcome_and_the_table_says_which() {
    let mut text = HEAD.to_owned();
    for row in files::rows().into_iter().chain(signals::rows()) {
        let Row {
            place,
            fault,
            outcome,
            runs,
        } = row;
        text += &format!("| {place} | {fault} | {outcome} | {runs} |\n");
    }
    text += TAIL;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/faults.md");
    let page = fs::read_to_string(&path).expect("the page of faults");
    let (before, half) = page.split_once(HEADING).expect("the heading of this half");
    if env::var_os("TIP_BLESS").is_some() {
        fs::write(path, format!("{before}{HEADING}{text}")).expect("the docs can be written");
        return;
    }
    assert!(
        half == text,
        "docs/faults.md differs; TIP_BLESS=1 rewrites it"
    );
}
