//! The options of the example.

use walk::options::Options;

fn parsed(words: &str) -> Result<Options, String> {
    Options::parse(words.split_whitespace().map(str::to_owned))
}

#[test]
fn values_and_switches_are_understood() {
    let options = parsed("--cycles 20000 --trace-state --trace a.jsonl").unwrap();
    assert_eq!(options.cycles, Some(20000));
    assert_eq!(options.trace, Some("a.jsonl".into()));
    assert!(options.trace_state && !options.realtime && !options.help);
}

#[test]
fn what_is_wrong_is_named() {
    assert_eq!(parsed("--fast").unwrap_err(), "unknown option --fast");
    assert_eq!(parsed("--trace").unwrap_err(), "--trace needs a value");
    assert_eq!(
        parsed("--cycles many").unwrap_err(),
        "many is not a number of cycles"
    );
    assert!(parsed("--realtime --trace a").is_err());
}
