//! Every language case on the interpreter alone: in seconds what the differential tests, whose programs have to be
//! compiled, prove in minutes. Most mutants of the compiler die here.

use std::path::Path;
use tip_harness::{cases, checked, root, stopped, traced};

/// Holds each case that has an expectation of this kind.
fn hold(folder: &Path, kind: &str, verdict: fn(&str)) {
    for case in cases(folder) {
        if folder.join(format!("{case}.{kind}")).exists() {
            println!("{case}");
            verdict(&case);
        }
    }
}

/// One test, so that the first case that fails ends it; the quick ones come first.
#[test]
fn every_case() {
    let folder = root().join("cases");
    hold(&folder, "check", checked);
    hold(&folder, "trace", |case| traced(case, None));
    hold(&folder, "stops", |case| stopped(case, None));
}
