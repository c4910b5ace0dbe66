//! Every language case on the interpreter alone: in seconds what the differential tests, whose programs have to be
//! compiled, prove in minutes. Most mutants of the compiler die here.

use tip_harness::{cases, checked, root, stopped, traced};

/// Holds each case that has an expectation of this kind; the first one that fails ends it.
fn hold(kind: &str, verdict: fn(&str)) {
    let folder = root().join("cases");
    for case in cases(&folder) {
        if folder.join(format!("{case}.{kind}")).exists() {
            println!("{case}");
            verdict(&case);
        }
    }
}

#[test]
fn findings() {
    hold("check", checked);
}

#[test]
fn traces() {
    hold("trace", |case| traced(case, None));
}

#[test]
fn stops() {
    hold("stops", |case| stopped(case, None));
}
