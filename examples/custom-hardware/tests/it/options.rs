//! The command line.

use custom_hardware::options::Options;

fn parsed(words: &str) -> Result<Options, String> {
    Options::parse(words.split_whitespace().map(str::to_owned))
}

#[test]
fn files_and_switches_are_understood() {
    let options = parsed("--robot r.toml --csv t.csv --fast").unwrap();
    assert_eq!(options.robot, Some("r.toml".into()));
    assert_eq!(options.csv.to_str(), Some("t.csv"));
    assert!(options.fast && !options.help);
}

#[test]
fn real_time_is_the_default() {
    assert!(!parsed("").unwrap().fast);
}

#[test]
fn an_unknown_word_or_a_missing_file_is_named() {
    assert_eq!(parsed("--slow").unwrap_err(), "unknown option --slow");
    assert_eq!(parsed("--csv").unwrap_err(), "--csv needs a file name");
}

#[test]
fn a_file_that_cannot_be_used_is_named() {
    for option in ["--robot", "--csv"] {
        let outcome = std::process::Command::new(env!("CARGO_BIN_EXE_custom-hardware"))
            .args(["--fast", option, "no/such/folder/file"])
            .output()
            .expect("it starts");
        assert_eq!(outcome.status.code(), Some(1));
        let told = String::from_utf8_lossy(&outcome.stderr);
        assert!(told.contains("no/such/folder/file"), "{told}");
    }
}
