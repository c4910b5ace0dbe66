//! `tip check`

use crate::support::Folder;
use serde_json::Value;

/// Ten statements, each wrong in another way.
const TEN: &str = "\
DEF_VAR A
A = 1
  FOO 1
PTP F9 0 0 0
A = SQRT A + 1
GOTO NOWHERE:
A = B
あ
PTP F1 0 0
MESSAGE 12345678901234567890123456789012345678901234567890123456789012345678901
WEND
TWICE:
TWICE:
END";

// clauses: 8.1
#[test]
fn ten_errors_are_reported_each_at_its_place() {
    let folder = Folder::new("ten").program("ten.prg", TEN);
    let outcome = folder
        .tip(&["check", "--message-format", "short", "ten.prg"])
        .expect(1);
    let expected = [
        ("5:3", "Unknown command \"FOO\""),
        ("6:5", "Wrong argument"),
        ("7:", "Wrong equation format"),
        ("8:6", "Label \"NOWHERE\" does not exist"),
        ("9:5", "unknown variable \"B\""),
        ("10:1", "Format error"),
        ("11:", "Wrong argument"),
        // The first character beyond the 70 that fit.
        ("12:79", "too much long string"),
        ("13:1", "Control structure mismatch"),
        ("15:1", "Duplicated label name"),
    ];
    let errors: Vec<_> = outcome
        .lines()
        .into_iter()
        .filter(|line| line.contains(": error["))
        .collect();
    assert_eq!(errors.len(), expected.len(), "{errors:#?}");
    for (line, (place, message)) in errors.iter().zip(expected) {
        assert!(
            line.starts_with(&format!("ten.prg:{place}")),
            "{line} is not at {place}"
        );
        assert!(line.ends_with(&format!(" (TIP_ERR:{message})")), "{line}");
    }
}

// clauses: 8.1 1.3
#[test]
fn json_has_one_object_a_line_with_the_keys_in_order() {
    let folder = Folder::new("json").file("old.prg", "3.0\ntitle\nEND\n");
    let outcome = folder
        .tip(&["check", "--message-format", "json", "old.prg"])
        .expect(1);
    let [line] = outcome.lines()[..] else {
        panic!("{outcome:#?}")
    };
    assert!(
        line.starts_with(r#"{"level":"error","kind":"PreprocessError","message":"Wrong version number","code":"E108","file":"old.prg","line":1,"column":1"#),
        "{line}"
    );
    let object: Value = serde_json::from_str(line).expect("valid JSON");
    assert_eq!(object["line"], 1);
}

#[test]
fn json_warnings_have_no_kind_of_error() {
    let folder = Folder::new("json-warning").program("w.prg", "DEF_VAR N\nEND");
    let outcome = folder
        .tip(&["check", "--message-format", "json", "w.prg"])
        .expect(0);
    let object: Value = serde_json::from_str(outcome.lines()[0]).expect("valid JSON");
    assert_eq!(object["level"], "warning");
    assert_eq!(object["line"], 3);
    assert_eq!(object["column"], 9);
}

#[test]
fn a_good_program_passes_in_silence_for_tools() {
    let folder = Folder::new("good").program("good.prg", "ALL_STOP\nEND");
    for format in ["short", "json"] {
        let outcome = folder
            .tip(&["check", "--message-format", format, "good.prg"])
            .expect(0);
        assert_eq!((outcome.out.as_str(), outcome.err.as_str()), ("", ""));
    }
    let outcome = folder.tip(&["check", "good.prg"]).expect(0);
    assert_eq!(outcome.out, "");
    assert_eq!(outcome.err, "good.prg: 2 steps for titan8, 0 warnings\n");
}

// clauses: 8.1
#[test]
fn a_file_that_is_not_there_is_an_error_of_its_own() {
    let folder = Folder::new("missing").program("good.prg", "END");
    let arguments = ["check", "--message-format", "short", "nope.prg", "good.prg"];
    let outcome = folder.tip(&arguments).expect(1);
    assert_eq!(
        outcome.lines(),
        [
            "nope.prg:1:1: error[E103]: there is no such file: check its name and its folder (TIP_ERR:File not found(nope.prg))"
        ]
    );
    let outcome = folder.tip(&["check", "nope.prg"]).expect(1);
    assert!(
        outcome.err.starts_with(
            "error[E103]: nope.prg: there is no such file: check its name and its folder\n  = note: TIP_ERR:File not found(nope.prg) (PreprocessError)\n"
        ),
        "{outcome:#?}"
    );
}

#[test]
fn one_bad_file_of_several_fails_the_command() {
    let folder = Folder::new("several")
        .program("good.prg", "END")
        .program("bad.prg", "ALL_STOP");
    folder.tip(&["check", "good.prg", "bad.prg"]).expect(1);
    folder.tip(&["check", "bad.prg", "good.prg"]).expect(1);
    folder.tip(&["check", "good.prg", "good.prg"]).expect(0);
}

#[test]
fn people_see_the_line_without_colour_in_a_pipe() {
    let folder = Folder::new("human").program("bad.prg", "ALL_STOPP\nEND");
    let outcome = folder.tip(&["check", "bad.prg"]).expect(1);
    assert_eq!(outcome.out, "");
    for part in [
        "bad.prg:3:1",
        "ALL_STOPP",
        "Unknown command \"ALL_STOPP\"",
        "ALL_STOP",
    ] {
        assert!(outcome.err.contains(part), "{part} in {}", outcome.err);
    }
    assert!(!outcome.err.contains('\x1b'), "{}", outcome.err);
    assert!(
        outcome.err.contains("\n\nbad.prg: 1 error, 0 warnings\n"),
        "{}",
        outcome.err
    );
}

// clauses: 7.1
#[test]
fn the_robot_decides_which_commands_exist() {
    let folder = Folder::new("robot").program("torque.prg", "TORQUE J11 1\nEND");
    folder.tip(&["check", "torque.prg"]).expect(1);
    folder
        .tip(&["check", "--robot", "hand", "torque.prg"])
        .expect(0);
    folder
        .tip(&["check", "--robot", "generic", "torque.prg"])
        .expect(0);
}

// clauses: 1.1 1.6
#[test]
fn shift_jis_is_found_out_or_forced() {
    // 全角 between full-width spaces, then an error after them: MESSAGE 前; FOO in CP932.
    let text = b"3.1\ntitle\n\x81\x40MESSAGE \x91\x4F ; FOO\nEND\n";
    let folder = Folder::new("shift-jis").file("sj.prg", text);
    let short = ["check", "--message-format", "short", "sj.prg"];
    let outcome = folder.tip(&short).expect(1);
    assert_eq!(
        outcome.lines(),
        ["sj.prg:3:14: error[E204-01]: `FOO` is not a command (TIP_ERR:Unknown command \"FOO\")"]
    );
    let forced = folder
        .tip(&[&short[..], &["--encoding", "shift_jis"]].concat())
        .expect(1);
    assert_eq!(forced.out, outcome.out);
    let wrong = folder
        .tip(&[&short[..], &["--encoding", "utf-8"]].concat())
        .expect(1);
    assert!(wrong.out.contains("(TIP_ERR:Format error)"), "{wrong:#?}");
}

// clauses: 1.3
#[test]
fn another_version_of_the_language_can_be_asked_for() {
    let folder = Folder::new("version").file("v.prg", "2.5\ntitle\nEND\n");
    folder.tip(&["check", "v.prg"]).expect(1);
    folder
        .tip(&["check", "--tip-version", "2.5", "v.prg"])
        .expect(0);
}

#[test]
fn wrong_usage_exits_with_two() {
    let folder = Folder::new("usage").program("good.prg", "END");
    let wrong: [&[&str]; 7] = [
        &[],
        &["check"],
        &["chekc", "good.prg"],
        &["check", "--robot", "asimo", "good.prg"],
        &["check", "--encoding", "ebcdic", "good.prg"],
        &["check", "--tip-version", "x", "good.prg"],
        &["check", "--message-format", "xml", "good.prg"],
    ];
    for arguments in wrong {
        folder.tip(arguments).expect(2);
    }
}

#[test]
fn help_teaches_by_example() {
    let folder = Folder::new("help");
    let outcome = folder.tip(&["help"]).expect(0);
    assert!(
        outcome.out.contains("tip check walk.prg"),
        "{}",
        outcome.out
    );
    let outcome = folder.tip(&["run", "--help"]).expect(0);
    assert!(
        outcome.out.contains("\n  tip run walk.prg --halt 300 "),
        "{}",
        outcome.out
    );
    let outcome = folder.tip(&["help", "run"]).expect(0);
    for option in [
        "--robot",
        "--cycles",
        "--trace",
        "--keys",
        "--halt",
        "--sensor",
        "--trace-state",
        "--tip-version",
        "--encoding",
        "--out-dir",
        "VR1=8@300",
    ] {
        assert!(outcome.out.contains(option), "{option} in {}", outcome.out);
    }
    folder.tip(&["--version"]).expect(0);
}

#[test]
fn people_choose_their_language() {
    let folder = Folder::new("lang").program("p.prg", "IF KB_HIT\nENDIF\nEND");
    let short = ["check", "--message-format", "short", "p.prg"];
    let english =
        "p.prg:3:10: error[E205-17]: THEN, GOTO or GOSUB belongs here (TIP_ERR:Wrong argument)";
    let japanese = "p.prg:3:10: error[E205-17]: ここにはTHEN、GOTO、GOSUBのどれかを書きます (TIP_ERR:Wrong argument)";
    for (language, line) in [("en", english), ("ja", japanese)] {
        let chosen = [&short[..], &["--lang", language]].concat();
        assert_eq!(folder.tip(&chosen).expect(1).lines(), [line]);
    }
    let of_locale = folder
        .command(&short)
        .env("LC_ALL", "ja_JP.UTF-8")
        .output()
        .expect("tip runs");
    assert_eq!(
        String::from_utf8_lossy(&of_locale.stdout).trim_end(),
        japanese
    );
}

#[test]
fn a_code_is_explained_in_both_languages() {
    let folder = Folder::new("explain");
    let page = |arguments: &[&str]| folder.tip(arguments).expect(0).out;
    let english = page(&["explain", "e206"]);
    assert!(english.starts_with("# E206: unknown variable"), "{english}");
    assert!(english.contains("DEF_VAR N"), "{english}");
    let class = page(&["explain", "E205"]);
    assert!(class.contains("- `E205-03`: a missing target\n"), "{class}");
    let finer = page(&["explain", "e205-03"]);
    assert!(finer.starts_with("# E205-03: a missing target"), "{finer}");
    assert!(
        finer.ends_with("`tip explain E205` lists the other codes of E205.\n"),
        "{finer}"
    );
    let japanese = page(&["explain", "E206", "--lang", "ja"]);
    assert!(japanese.contains("宣言されていない"), "{japanese}");
    let unknown = folder.tip(&["explain", "E999"]).expect(2);
    assert!(unknown.err.contains("such as E205"), "{unknown:#?}");
    for (code, near) in [
        ("foo", "such as E205"),
        ("E409", "E401, E402"),
        ("E205-99", "near it are E205"),
    ] {
        let unknown = folder.tip(&["explain", code]).expect(2);
        assert!(
            unknown.err.contains(near) && unknown.err.len() < 200,
            "{unknown:#?}"
        );
    }
}

#[test]
fn many_diagnostics_are_cut_and_counted_over_all_files() {
    let wrong = "FOO\n".repeat(60) + "END";
    let folder = Folder::new("many")
        .program("many.prg", &wrong)
        .program("one.prg", "BAR\nEND");
    let outcome = folder.tip(&["check", "many.prg", "one.prg"]).expect(1);
    assert_eq!(
        outcome.err.matches("is not a command\n").count(),
        51,
        "{outcome:#?}"
    );
    for line in [
        "... and 10 more findings",
        "many.prg: 60 errors, 0 warnings",
        "one.prg: 1 error, 0 warnings",
        "2 files: 61 errors, 0 warnings",
    ] {
        assert!(
            outcome.err.lines().any(|one| one == line),
            "{line}: {outcome:#?}"
        );
    }
    let short = ["check", "--message-format", "short", "many.prg"];
    assert_eq!(folder.tip(&short).expect(1).lines().len(), 60);
}

#[test]
fn diagnostics_beyond_a_thousand_are_omitted_and_counted() {
    let mut naps: String = (0..1_200).map(|n| format!("DEF_VAR V{n}\n")).collect();
    naps += "SLEEP 1\nMESSAGE done\nEND";
    let folder = Folder::new("omitted")
        .program("wrong.prg", &("FOO\n".repeat(1_500) + "END"))
        .program("naps.prg", &naps);
    let tip = |arguments: &[&str]| folder.tip(arguments);
    let human = tip(&["check", "wrong.prg"]).expect(1);
    for line in [
        "... and 1450 more findings",
        "wrong.prg: 1500 errors, 0 warnings",
    ] {
        assert!(human.err.lines().any(|one| one == line), "{line}");
    }
    let short = tip(&["check", "--message-format", "short", "wrong.prg"]).expect(1);
    assert_eq!(short.lines().len(), 1_001);
    let note = "wrong.prg: note: ... and 500 more findings";
    assert_eq!(short.lines().last(), Some(&note));
    let json = tip(&["check", "--message-format", "json", "wrong.prg"]).expect(1);
    assert_eq!(json.lines().len(), 1_001);
    let note = r#"{"level":"note","message":"... and 500 more findings","file":"wrong.prg","omitted":500}"#;
    assert_eq!(json.lines().last(), Some(&note));
    // What is omitted is denied like the rest.
    let checked =
        |more: &[&str]| tip(&[&["check", "--message-format", "short", "naps.prg"], more].concat());
    checked(&[]).expect(0);
    for (code, line) in [
        ("W118", "error: naps.prg: 1 denied warning: W118\n"),
        ("W101", "error: naps.prg: 1200 denied warnings: W101\n"),
    ] {
        assert_eq!(checked(&["--deny", code]).expect(1).err, line);
    }
}

#[test]
fn colours_come_when_asked_for() {
    let folder = Folder::new("colours").program("p.prg", "FOO\nEND");
    let shown = |arguments: &[&str], insists: &str| {
        let mut command = folder.command(&[&["check", "p.prg"], arguments].concat());
        let output = command
            .env("CLICOLOR_FORCE", insists)
            .output()
            .expect("tip runs");
        output.stderr.contains(&0x1B)
    };
    assert!(!shown(&[], "0"));
    assert!(shown(&[], "1"));
    assert!(shown(&["--color", "always"], "0"));
    assert!(!shown(&["--color", "never"], "1"));
}

#[test]
fn a_program_may_come_from_standard_input() {
    let folder = Folder::new("stdin").program("p.prg", "FOO\nEND");
    let program = std::fs::File::open(folder.path("p.prg")).expect("a program");
    let mut command = folder.command(&["check", "--message-format", "short", "-"]);
    let output = command.stdin(program).output().expect("tip runs");
    let line = "standard input:3:1: error[E204-01]: `FOO` is not a command (TIP_ERR:Unknown command \"FOO\")";
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim_end(), line);
}

#[test]
fn a_folder_is_not_a_program() {
    let folder = Folder::new("folder").program("motions/p.prg", "END");
    let outcome = folder.tip(&["check", "motions"]).expect(1);
    let start = "error[E103]: motions: this is a folder: name the files in it";
    assert!(outcome.err.starts_with(start), "{outcome:#?}");
    folder
        .tip(&["check", "--robot", "TITAN8", "motions/p.prg"])
        .expect(0);
}

#[test]
fn denied_warnings_fail() {
    let folder = Folder::new("deny")
        .program("naps.prg", "SLEEP 1\nMESSAGE done\nEND")
        .program("allowed.prg", "SLEEP 1 // tip: allow(W118)\nEND");
    let tip = |arguments: &[&str]| folder.tip(arguments);
    tip(&["check", "naps.prg"]).expect(0);
    let denied = tip(&["check", "--deny", "W118", "naps.prg"]).expect(1);
    let line = "error: naps.prg: 1 denied warning: W118\n";
    assert!(denied.err.contains(line), "{denied:#?}");
    tip(&["check", "--deny", "falls,warnings", "naps.prg"]).expect(1);
    tip(&["check", "--deny", "W101", "--deny", "falls", "naps.prg"]).expect(0);
    tip(&["check", "--deny", "warnings", "allowed.prg"]).expect(0);
    // The same words for a run, which then does not begin.
    let run = tip(&["run", "--deny", "falls,w118", "naps.prg"]).expect(1);
    assert_eq!(run.out, "");
    tip(&["run", "--deny", "W101", "naps.prg"]).expect(0);
    // What is not in the list is refused with the list.
    for word in ["E205", "W999", "rain", ""] {
        for command in ["check", "run"] {
            let refused = tip(&[command, "--deny", word, "naps.prg"]).expect(2);
            assert!(
                refused.err.contains("falls, collisions, warnings, W101, "),
                "{refused:#?}"
            );
        }
    }
}

#[test]
fn codes_are_explained_by_a_command_that_is_named_once() {
    let folder = Folder::new("check-learn")
        .program("one.prg", "SLEP 5\nEND")
        .program("two.prg", "SLEP 5\nGOTO L:\nEND")
        .program("fine.prg", "END");
    let last = |arguments: &[&str]| {
        let outcome = folder.tip(&[&["check"], arguments].concat());
        assert!(
            outcome.err.matches("tip explain").count() <= 1,
            "{outcome:#?}"
        );
        outcome.err.lines().last().expect("a line").to_owned()
    };
    assert_eq!(last(&["one.prg"]), "to learn more: tip explain E204-01");
    assert_eq!(
        last(&["one.prg", "two.prg", "fine.prg"]),
        "to learn more: tip explain E204-01, and likewise E202"
    );
    assert_eq!(
        last(&["one.prg", "--lang", "ja"]),
        "詳しくは: tip explain E204-01"
    );
    assert_eq!(
        last(&["fine.prg"]),
        "fine.prg: 1 step for titan8, 0 warnings"
    );
    // Tools read codes themselves, and a file that is not there needs no page.
    for arguments in [&["one.prg", "--message-format", "short"][..], &["none.prg"]] {
        let outcome = folder.tip(&[&["check"], arguments].concat()).expect(1);
        assert!(!(outcome.out + &outcome.err).contains("tip explain"));
    }
    let outcome = folder.tip(&["run", "one.prg"]).expect(1);
    assert!(
        outcome
            .err
            .ends_with("\nto learn more: tip explain E204-01\n"),
        "{outcome:#?}"
    );
}

#[test]
fn a_command_of_another_robot_says_how_to_choose_it() {
    let folder = Folder::new("check-robot").program("p.prg", "TORQUE J11 1\nEND");
    let outcome = folder.tip(&["check", "p.prg"]).expect(1);
    assert!(
        outcome.err.contains("which `--robot` or tip.toml chooses"),
        "{outcome:#?}"
    );
    folder
        .tip(&["check", "p.prg", "--robot", "generic"])
        .expect(0);
}
