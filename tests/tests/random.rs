//! Random programs on both engines, one test each.

use tip_tests::{random, random_settings, run};
use tipc::interp::Interpreter;

include!(concat!(env!("OUT_DIR"), "/random_tests.rs"));

/// A batch that always ended the same way would prove little.
#[test]
fn the_batch_comes_to_every_kind_of_end() {
    let ends: Vec<String> = (0..60)
        .map(|seed| {
            let source = random::program(seed);
            let loaded = tipc::load("batch.prg", source.as_bytes(), &tipc::Options::default());
            let program = Interpreter::new(loaded.program.expect("it loads"));
            let trace = run(Box::new(program), &random_settings(seed)).expect("it runs");
            trace.lines().last().unwrap_or_default().to_owned()
        })
        .collect();
    for (end, at_least) in [
        ("\"EXIT\"", 20),
        ("\"LIMIT\"", 10),
        ("\"Domain error\"", 5),
        ("\"Possible use of Variable before definition\"", 5),
    ] {
        let count = ends.iter().filter(|record| record.contains(end)).count();
        assert!(count >= at_least, "{end} {count} times in {ends:#?}");
    }
}
