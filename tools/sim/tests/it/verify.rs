//! A process that compares both engines, and what goes wrong with it.

use std::path::Path;
use tip_sim::Inputs;
use tip_sim::search::Engines as _;
use tip_sim::verify::Engines;

fn complaint(executable: &str) -> String {
    let engines = Engines::start(Path::new(executable));
    let answer = engines.and_then(|mut engines| engines.ask(&Inputs::default()));
    answer.expect_err("it is no engine").to_string()
}

#[test]
fn a_process_that_dies_or_talks_nonsense_is_named() {
    assert!(complaint("/bin/no-such-file").contains("does not start"));
    assert!(complaint("/bin/true").contains("ended (exit status: 0)"));
    assert!(complaint("/bin/cat").contains("'' is not an answer"));
}
