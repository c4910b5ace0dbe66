//! Verdicts on reads, against all runs.

use crate::analysis::programs::{RUNS, Runnable, all};
use tipc::analysis::assignment::{Assigned, Assignment, Read};

// clauses: 3.4
#[test]
fn no_run_contradicts_what_is_proved() {
    let seen = &RUNS.seen;
    assert!(seen[&Assigned::Always] > 20_000, "{seen:?}");
    assert!(seen[&Assigned::Sometimes] > 30, "{seen:?}");
    assert!(seen[&Assigned::Never] > 5, "{seen:?}");
}

/// The tests at runtime that the generated code of all these programs does without.
#[test]
fn nearly_all_reads_are_proved() {
    let (mut proved, mut reads) = (0, 0);
    for Runnable { name, program, .. } in all() {
        let assignment = Assignment::of(&program);
        let of_program = assignment.reads().len();
        let always = |read: &&Read| read.assigned == Assigned::Always;
        let dropped = assignment.reads().iter().filter(always).count();
        println!("{name}: {dropped} of {of_program} tests dropped");
        proved += dropped;
        reads += of_program;
    }
    println!("in all: {proved} of {reads}");
    assert!(proved * 100 > reads * 85, "{proved} of {reads}");
}
