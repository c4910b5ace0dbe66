//! The fault campaign of the files that a run writes, and of Ctrl-C: the second half of docs/faults.md.

mod bench;
mod files;
mod signals;
mod terminal;

use std::path::Path;
use std::{env, fs};

/// What went wrong, where, and what became of it.
struct Row {
    place: &'static str,
    fault: &'static str,
    outcome: &'static str,
    runs: usize,
}

const HEADING: &str = "\n## Files and Ctrl-C\n";

const HEAD: &str = "
What `tipc run PROGRAM --out-dir FOLDER --trace FILE` does where its files cannot be written, and when it is interrupted. An earlier run of the
same program had written all five files. In every case each file is the earlier one or the new one, whole; nothing half written is left.

| where | fault | outcome | runs |
|---|---|---|---|
";

const TAIL: &str = "
A read-only file is one that nobody may write, as `chmod a-w` makes it; it is refused to the system's administrator too. *Refused*: the run stops before the first cycle with `TIP_ERR:File can not write(…) (PreprocessError)`, status 1, and all earlier files stay.
*Told at the end*: the program runs to its end, what can be written is new, then the same error with status 1. *Interrupted*: status 130; the
trace ends with `INTERRUPTED`, and the logs hold all cycles until then.

A compiled program writes its logs by the same `LogFiles`. Where it reads the keys of a terminal, Ctrl-C is a key, which stops the robot as RETURN
does. The signal ends it as any process, unless its host catches it; then earlier files stay, and what was being written is left beside them
as `.NAME.PROCESS.part`. `cargo test -p walk --test interrupt` tries both.

`cargo test -p tipc-cli --test cli faults` makes these runs, on Linux, and compares this half of the page; with `TIP_BLESS=1` it
writes it anew.
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
        "docs/faults.md differs; TIP_BLESS=1 writes it anew"
    );
}
