//! Wrong usage: words that lead to a right command line.

use crate::support::Folder;

/// The first line that a wrong command line gets; the exit status is 2.
#[track_caller]
fn check(folder: &Folder, arguments: &[&str], expected: &str) {
    let outcome = folder.tip(arguments).expect(2);
    assert_eq!(outcome.out, "");
    assert_eq!(outcome.err.lines().next(), Some(expected), "{outcome:#?}");
}

#[test]
fn a_program_in_the_place_of_a_command_is_to_be_run() {
    let folder = Folder::new("usage-program").program("steps", "END");
    let asked =
        |file| format!("error: `{file}` is not a command of tip: did you mean `tip run {file}`?");
    for file in ["walk.prg", "motions/WALK.PRG", "steps"] {
        check(&folder, &[file], &asked(file));
    }
    check(
        &folder,
        &["walk.prg", "--lang", "ja"],
        "エラー: `walk.prg` はtipのコマンドではありません。`tip run walk.prg` のことですか?",
    );
}

#[test]
fn other_words_lead_to_commands() {
    let folder = Folder::new("usage-words");
    for (word, command) in [
        ("chekc", "check"),
        ("format", "fmt"),
        ("compile", "emit rust"),
    ] {
        let expected =
            format!("error: `{word}` is not a command of tip: did you mean `tip {command}`?");
        check(&folder, &[word, "walk.prg"], &expected);
    }
    let outcome = folder.tip(&["dance"]).expect(2);
    let start = "error: `dance` is not a command of tip; the commands are new, check, fmt, ";
    assert!(outcome.err.starts_with(start), "{outcome:#?}");
}

#[test]
fn a_missing_file_is_asked_for() {
    let folder = Folder::new("usage-file");
    for (command, example) in [
        ("run", "run"),
        ("check", "check"),
        ("migrate", "migrate"),
        ("emit", "emit rust"),
    ] {
        let expected = format!(
            "error: which program? `tip {example}` needs a file, as in `tip {example} walk.prg`"
        );
        check(&folder, &[command], &expected);
    }
    let outcome = folder.tip(&["run"]).expect(2);
    assert_eq!(
        outcome.err.lines().nth(1),
        Some("`tip help run` shows examples")
    );
}

#[test]
fn a_robot_that_is_not_there_is_named_with_those_that_are() {
    let folder = Folder::new("usage-robot").program("p.prg", "END");
    let robots = "titan8, hand, generic, a1, phantomx, solo12, spotmicro and trifinger";
    let there = format!("The robots are {robots}, and your own in a FILE.toml");
    for (word, near) in [
        ("titan9", "titan8"),
        ("TitanVIII", "titan8"),
        ("hnad", "hand"),
        ("phantom-x", "phantomx"),
    ] {
        let expected =
            format!("error: --robot: there is no robot `{word}`: did you mean `{near}`? {there}");
        check(&folder, &["check", "--robot", word, "p.prg"], &expected);
    }
    check(
        &folder,
        &["run", "--robot", "asimo", "p.prg"],
        &format!(
            "error: --robot: there is no robot `asimo`; the robots are {robots}, and your own in a FILE.toml"
        ),
    );
    folder
        .tip(&["check", "--robot", "Titan8", "p.prg"])
        .expect(0);
}

#[test]
fn the_end_of_an_option_leads_to_it() {
    let folder = Folder::new("usage-end").program("p.prg", "END");
    check(
        &folder,
        &["check", "--format", "short", "p.prg"],
        "error: there is no option `--format`: did you mean `--message-format`?",
    );
    let refused = folder.tip(&["check", "--mat", "p.prg"]).expect(2);
    assert!(!refused.err.contains("message-format"), "{}", refused.err);
}

#[test]
fn a_count_is_a_whole_number() {
    let folder = Folder::new("usage-count").program("p.prg", "END");
    for (option, value) in [("--cycles", "-5"), ("--cycles", "1.5"), ("--halt", "soon")] {
        let expected =
            format!("error: {option}: `{value}` is not a count: write a whole number, 0 or more");
        check(&folder, &["run", "p.prg", option, value], &expected);
    }
    check(
        &folder,
        &["run", "p.prg", "--cycles=-5", "--lang=ja"],
        "エラー: --cycles: `-5` は数えられません。0以上の整数を指定してください",
    );
    check(
        &folder,
        &["check", "--tip-version", "new", "p.prg"],
        "error: --tip-version: `new` is not a version of the language, such as 3.1",
    );
}

#[test]
fn the_language_may_come_before_the_command() {
    let folder = Folder::new("usage-lang").program("p.prg", "SLEP 5\nEND");
    let before = folder.tip(&["--lang", "ja", "check", "p.prg"]).expect(1);
    let after = folder.tip(&["check", "p.prg", "--lang", "ja"]).expect(1);
    assert!(before.err.starts_with("エラー"), "{before:#?}");
    assert_eq!(before.err, after.err);
    // A missing file is asked for with the command, not with the option.
    check(
        &folder,
        &["--lang", "en", "run"],
        "error: which program? `tip run` needs a file, as in `tip run walk.prg`",
    );
}

#[test]
fn help_fits_a_screen_and_groups_the_commands() {
    let folder = Folder::new("usage-screen");
    for arguments in [
        &["--help"][..],
        &["run", "--help"],
        &["sweep", "--help"],
        &["sweep", "--help", "--lang", "ja"],
    ] {
        let help = folder.tip(arguments).expect(0);
        let lines = help.lines();
        assert!(lines.len() <= 40, "{} lines: {}", lines.len(), help.out);
        for line in &lines {
            assert!(line.chars().count() <= 80, "{line}");
        }
    }
    let help = folder.tip(&["--help"]).expect(0);
    let headings: Vec<&str> = help
        .lines()
        .into_iter()
        .filter(|line| line.ends_with(':'))
        .collect();
    let groups = ["Write:", "Run:", "See:", "Robots:", "Editors and shells:"];
    assert_eq!(headings, [&groups[..], &["Options:"]].concat());
}

#[test]
fn the_locale_chooses_the_language_of_wrong_usage() {
    let folder = Folder::new("usage-locale");
    let output = folder
        .command(&["walk.prg"])
        .env("LANG", "ja_JP.UTF-8")
        .output();
    let err = String::from_utf8(output.expect("tip runs").stderr).expect("UTF-8");
    assert!(err.contains("のことですか?"), "{err}");
}

#[test]
fn help_is_in_the_language_that_is_asked_for() {
    let folder = Folder::new("usage-help");
    let help = folder.tip(&["check", "--help", "--lang", "ja"]).expect(0);
    for line in [
        "使い方: tip check [OPTIONS] <FILE>...",
        "  <FILE>...  プログラム。'-' は標準入力",
        "'tip help check' で例・値・終了コードなどの詳細を表示する。",
    ] {
        assert!(help.out.lines().any(|it| it == line), "{line}: {help:#?}");
    }
    let help = folder.tip(&["--lang", "ja", "help", "check"]).expect(0);
    for line in [
        "          プログラム。'-' は標準入力",
        "          [既定値: human]",
        "          - short: 1 件 1 行",
        "  tip check --watch walk.prg                 変わるたびに検査し直す (Ctrl-C まで)",
    ] {
        assert!(help.out.lines().any(|it| it == line), "{line}: {help:#?}");
    }
    let output = folder
        .command(&["help", "run"])
        .env("LANG", "ja_JP.UTF-8")
        .output();
    let help = String::from_utf8(output.expect("tip runs").stdout).expect("UTF-8");
    assert!(help.starts_with("シミュレーションのロボット"), "{help}");
    let help = folder.tip(&["run", "-h", "--lang", "en"]).expect(0);
    assert!(help.out.contains("Usage: tip run"), "{help:#?}");
}
