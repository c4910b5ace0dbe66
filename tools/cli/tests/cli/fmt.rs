//! `tip fmt`

use crate::support::{Folder, Outcome};
use std::fs::File;

const UNTIDY: &str = "3.1\nwalk\nif kb_hit then\nsleep 1//ms\nendif\nend";
const TIDY: &str = "3.1\nwalk\nIF KB_HIT THEN\n  SLEEP 1  //ms\nENDIF\nEND\n";

#[test]
fn files_are_rewritten_in_silence() {
    let folder = Folder::new("fmt")
        .file("a.prg", UNTIDY)
        .file("b.prg", TIDY)
        .file("hand.prg", "3.1\nt\ntorque j11 1\nend\n");
    let outcome = folder.tip(&["fmt", "a.prg", "b.prg", "hand.prg"]).expect(0);
    assert_eq!((outcome.out.as_str(), outcome.err.as_str()), ("", ""));
    assert_eq!(folder.read("a.prg"), TIDY);
    assert_eq!(folder.read("b.prg"), TIDY);
    assert_eq!(folder.read("hand.prg"), "3.1\nt\nTORQUE J11 1\nEND\n");
    // Nothing is left beside them.
    assert_eq!(folder.names(), ["a.prg", "b.prg", "hand.prg"]);
}

#[cfg(unix)]
#[test]
fn a_file_in_the_style_is_not_touched() {
    use std::os::unix::fs::MetadataExt;
    let folder = Folder::new("fmt-same").file("b.prg", TIDY);
    let number = || folder.path("b.prg").metadata().expect("a file").ino();
    let before = number();
    folder.tip(&["fmt", "b.prg"]).expect(0);
    assert_eq!(number(), before);
}

#[test]
fn a_check_names_the_files_and_writes_nothing() {
    let folder = Folder::new("fmt-check")
        .file("a.prg", UNTIDY)
        .file("b.prg", TIDY);
    let outcome = folder.tip(&["fmt", "--check", "a.prg", "b.prg"]).expect(1);
    assert_eq!(
        (outcome.out.as_str(), outcome.err.as_str()),
        ("a.prg\n", "")
    );
    assert_eq!(folder.read("a.prg"), UNTIDY);
    folder.tip(&["fmt", "--check", "b.prg"]).expect(0);
    folder.tip(&["fmt", "--check", "--diff", "b.prg"]).expect(2);
}

#[test]
fn a_diff_shows_what_would_change() {
    let folder = Folder::new("fmt-diff")
        .file("a.prg", "3.1\nt\nREM\nsleep 1\nEND\n")
        .file("b.prg", TIDY);
    let outcome = folder.tip(&["fmt", "--diff", "a.prg", "b.prg"]).expect(1);
    let expected = "--- a.prg\n+++ a.prg (formatted)\n@@ -1,5 +1,5 @@\n 3.1\n t\n REM\n-sleep 1\n+SLEEP 1\n END\n";
    assert_eq!((outcome.out.as_str(), outcome.err.as_str()), (expected, ""));
    assert!(folder.read("a.prg").contains("sleep"));
}

/// Formats a program on standard input.
fn of_standard_input(folder: &Folder, name: &str, arguments: &[&str]) -> Outcome {
    let program = File::open(folder.path(name)).expect("a program");
    let mut command = folder.command(arguments);
    Outcome::of(command.stdin(program).output().expect("tip runs"))
}

#[test]
fn standard_input_goes_to_standard_output() {
    let folder = Folder::new("fmt-stdin")
        .file("a.prg", UNTIDY)
        .file("b.prg", TIDY)
        .program("bad.prg", "FOO\nEND");
    for name in ["a.prg", "b.prg"] {
        assert_eq!(
            of_standard_input(&folder, name, &["fmt", "-"])
                .expect(0)
                .out,
            TIDY
        );
    }
    let check = of_standard_input(&folder, "a.prg", &["fmt", "--check", "-"]).expect(1);
    assert_eq!(check.out, "standard input\n");
    let bad = of_standard_input(&folder, "bad.prg", &["fmt", "-"]).expect(1);
    assert_eq!(bad.out, "");
    assert!(bad.err.contains("`FOO` is not a command"), "{bad:#?}");
}

#[test]
fn what_cannot_be_formatted_is_left_with_a_word() {
    let long = format!("DEF_VAR A\n{}A=1\nEND", "A=1;".repeat(255));
    let folder = Folder::new("fmt-left")
        .program("bad.prg", "foo\nend")
        .program("long.prg", &long)
        .file("bytes.prg", b"3.1\nt\n// \xFF\nend\n")
        .file("good.prg", UNTIDY);
    let arguments = [
        "fmt",
        "bad.prg",
        "long.prg",
        "bytes.prg",
        "none.prg",
        "good.prg",
    ];
    let outcome = folder.tip(&arguments).expect(1);
    assert_eq!(outcome.out, "");
    for text in [
        "bad.prg:3:1",
        "bad.prg: left as it is: a program with errors cannot be formatted\n",
        "long.prg: left as it is: line 4 would be longer than 1023 bytes; break it in two\n",
        "bytes.prg: left as it is: a program with errors cannot be formatted\n",
        "File not found(none.prg)",
    ] {
        assert!(outcome.err.contains(text), "{text}: {outcome:#?}");
    }
    assert_eq!(folder.read("bad.prg"), "3.1\ntest\nfoo\nend\n");
    // The others are formatted all the same.
    assert_eq!(folder.read("good.prg"), TIDY);
    let japanese = folder.tip(&["fmt", "--lang", "ja", "long.prg"]).expect(1);
    assert!(
        japanese.err.starts_with("long.prg: そのままにしました。"),
        "{japanese:#?}"
    );
}

#[test]
fn shift_jis_stays_as_it_is() {
    let folder = Folder::new("fmt-sjis").file("a.prg", b"3.1\n\x95\xE0\nrem//\xEE\xF9\nend\n");
    folder.tip(&["fmt", "a.prg"]).expect(0);
    let bytes = std::fs::read(folder.path("a.prg")).expect("readable");
    assert_eq!(bytes, b"3.1\n\x95\xE0\nREM  //\xEE\xF9\nEND\n");
}
