//! The fault campaign for the files that a run writes and for Ctrl-C: the second half of docs/faults.md.

mod bench;
mod files;
mod parts;
mod signals;
pub(crate) mod terminal;

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

/// The next part of the page, which `endings` writes.
const NEXT: &str = "\n## A robot on servos\n";

const HEAD: &str = "
The outcome of `tip run PROGRAM --out-dir FOLDER --trace FILE` if its files cannot be written, or if it is interrupted.
An earlier run of the same program had written all five files.
In every case each file is either the complete earlier one or the complete new one; no partial file is left.

| where | fault | outcome | runs |
|---|---|---|---|
";

const TAIL: &str = "
- *Refused*: the run stops before the first cycle with `cannot write FILE: REASON`, status 1, and all earlier files stay.
- *Reported at the end*: the program runs to its end, every file that can be written is new, then the run ends with the same error and status 1.
- *Interrupted*: status 130; the trace ends with `INTERRUPTED`, and the logs hold all cycles up to that point.
- A *read-only* file is one that nobody may write, as after `chmod a-w`; it is refused to the system administrator too.

A compiled program writes its logs with the same `LogFiles`.
If it reads keys from a terminal, Ctrl-C is a key that stops the robot like RETURN.
Otherwise the signal ends the process unless the host catches it; the earlier files stay, and partial files are left next to them as `.tip-RANDOM.part`.
`cargo test -p walk --test it interrupt` tests both.

`cargo test -p tip-cli --test cli faults` makes these runs, on Linux, and compares this half of the page; with `TIP_BLESS=1` it rewrites it.

## Long programs and large numbers

Bounds on time and memory. Work is counted in bytes allocated, which is the same on every machine.

| where | input | bound | test |
|---|---|---|---|
| `tip cycles`, hovers | loops in loops, labels, calls in calls, jumps across the program | proportional to the steps: for each kind of parts at most 1,000,000 visits and 32 per node of the flow graph; then counting stops, and says so | `tools/lint/tests/it/bounded.rs` |
| `tip check` | blocks in blocks with constant conditions, many variables in messages | proportional to the steps | `tools/lint/tests/it/bounded.rs` |
| reads of variables | thousands of variables that are assigned elsewhere than they are read | while blocks times words of 64 variables are at most 2,000,000; other reads are checked at run time, and `Assignment::is_complete` returns false | `tools/lint/tests/it/bounded.rs` |
| `tip migrate` | tolerances, placeholders, names that became words | proportional to the lines | `tools/lint/tests/it/bounded.rs` |
| generated code | memory to lay it out | less than 20 kB a step | `tools/lint/tests/it/bounded.rs` |
| messages | words quoted from a program, a description or a URDF file | 80 characters, then `…`; texts of the system 4096 | `tipc/src/message/tests.rs` |
| messages | search for the nearest known name | 500 names, and words of 80 bytes | `tipc/src/suggest.rs` |
| VARIABLES.LOG | OUTPUT_VARIABLES in a loop | 16 MiB, then a line that says so | `tip-runtime/tests/it/log_files.rs` |
| TITAN.LOG | an endless run | 10,000 rows | `tools/cli/tests/cli/faults/signals.rs` |
| NORM | members whose squares are beyond the largest number | the root where it is finite; else `Domain error` | `tip-runtime/src/ops.rs`, `tests/language/cases/faults/norm-overflows` |
";

#[test]
fn whatever_happens_to_files_and_runs_has_its_outcome_and_the_table_says_which() {
    let mut text = HEAD.to_owned();
    let rows = files::rows().into_iter().chain(parts::rows());
    for row in rows.chain(signals::rows()) {
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
    let (half, after) = half.split_once(NEXT).expect("the heading of the next part");
    if env::var_os("TIP_BLESS").is_some() {
        fs::write(path, format!("{before}{HEADING}{text}{NEXT}{after}"))
            .expect("the docs can be written");
        return;
    }
    assert!(
        half == text,
        "docs/faults.md differs; TIP_BLESS=1 rewrites it"
    );
}
