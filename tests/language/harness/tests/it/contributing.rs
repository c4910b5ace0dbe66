//! The case of CONTRIBUTING.md holds, as those who follow it will see.

use std::fs;
use tip_harness::{matches, root};
use tip_sim::{Limit, Robot, Run, load};

/// The text of the first block of this kind.
fn block(text: &str, kind: &str) -> String {
    let (_, rest) = text.split_once(&format!("\n```{kind}\n")).expect("a block");
    rest.split("```").next().unwrap_or_default().to_owned()
}

#[test]
fn the_first_case_holds_and_can_fail() {
    let text = fs::read_to_string(root().join("../../CONTRIBUTING.md")).expect("the page");
    let robot = Robot::named("titan8").expect("it is built in");
    let program = load("first.prg", &block(&text, "tip"), &robot).expect("it loads");
    let mut run = Run::new(program, robot).expect("it fits").with_trace(false);
    run.to_end(Limit::cycles(100));
    let trace = run.trace();
    let records: Vec<&str> = trace.lines().collect();
    let holds = |case: &str| {
        let expected: Vec<&str> = case.lines().filter(|line| !line.starts_with('#')).collect();
        matches(&expected, &records)
    };
    let case = block(&text, "json");
    assert_eq!(holds(&case), Ok(()));
    assert!(holds(&case.replace("42", "43")).is_err());
}
