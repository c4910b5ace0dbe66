//! Nothing that a program or the name of a file says reaches a terminal or a log as it is.

#[cfg(target_os = "linux")]
use crate::faults::terminal::Pty;
use crate::support::Folder;

/// A name that would start a line of its own, then recolour it.
const NAME: &str = "a\nb\u{1b}[31m.prg";
/// The expected output for it.
const PRINTED: &str = r"a\u{a}b\u{1b}[31m.prg";

/// Nothing acts on a terminal but line ends, tabs and these.
#[track_caller]
fn require_printable(text: &str, kept: &str) {
    let acts = |c: &char| c.is_control() || "\u{202e}\u{200f}".contains(*c);
    let found = text.chars().filter(acts);
    let found: Vec<char> = found
        .filter(|c| !"\t\n".contains(*c) && !kept.contains(*c))
        .collect();
    assert!(found.is_empty(), "{found:?} in {text:?}");
}

// clauses: 7.34 8.1
#[test]
fn a_run_shows_the_controls_of_a_program_as_escapes() {
    let program = "MESSAGE a\\a\\t\u{1b}[31m\u{202e}b\u{9b}c\nRETURN // \u{1b}[2J\nEND\n";
    let text = format!("3.1\nt\u{1b}]0;x\u{7}\n{program}");
    let folder = Folder::new("printable-run").file(NAME, text);
    let run = ["run", NAME, "--out-dir", "logs", "--trace", "t.jsonl"];
    let outcome = folder.tip(&run).expect(3);
    assert_eq!(outcome.out, "a\u{7}\t\\u{1b}[31m\\u{202e}b\\u{9b}c\n");
    require_printable(&outcome.err, "");
    let place = format!(" --> {PRINTED}:4:1\n");
    assert!(outcome.err.contains(&place), "{outcome:#?}");
    assert!(
        outcome.err.contains(r"4 | RETURN // \u{1b}[2J"),
        "{outcome:#?}"
    );
    for log in ["logs/EMG.log", "logs/WARNING.LOG"] {
        require_printable(&folder.read(log), "");
    }
    let report = folder.read("logs/EMG.log");
    assert!(
        report.starts_with(&format!("# EMG.log of ../{PRINTED}\n")),
        "{report}"
    );
    assert!(
        report.contains(&format!(
            "\nprogram\t{PRINTED}\ntitle\tt\\u{{1b}}]0;x\\u{{7}}\n"
        )),
        "{report}"
    );
    // The trace is JSON, and stays as it was.
    let say = "\"say\":\"a\\u0007\\t\\u001b[31m\u{202e}b\u{9b}c\"";
    assert!(folder.read("t.jsonl").contains(say));
    // The next run knows its logs again.
    folder.tip(&run).expect(3);
}

// clauses: 8.1
#[test]
fn a_diagnostic_is_one_record_whatever_the_file_is_called() {
    let folder = Folder::new("printable-check").file(NAME, "3.1\nt\nFOO\u{1b}[2J\u{7f} 1\nEND\n");
    let short = folder
        .tip(&["check", "--message-format", "short", NAME])
        .expect(1);
    let start = format!("{PRINTED}:3:4: error[");
    assert!(
        short.lines().iter().all(|line| line.starts_with(&start)),
        "{short:#?}"
    );
    let human = folder.tip(&["check", NAME]).expect(1);
    require_printable(&human.err, "");
    assert!(
        human.err.contains(r"3 | FOO\u{1b}[2J\u{7f} 1"),
        "{human:#?}"
    );
    assert!(human.err.contains(&format!("\n{PRINTED}: ")), "{human:#?}");
}

#[test]
fn questions_counts_and_errors_show_names_and_lines_as_escapes() {
    let folder = Folder::new("printable-others")
        .file(NAME, "2.0\nt\nFOO\u{1b}[2J 1\nEND\n")
        .file("c\u{200f}\n.prg", "3.1\nt\nEND\n");
    let question = folder.tip(&["migrate", NAME]).expect(1);
    require_printable(&question.err, "");
    assert!(
        question.err.contains(r"    FOO\u{1b}[2J 1"),
        "{question:#?}"
    );
    for line in question.err.lines().filter(|line| !line.starts_with(' ')) {
        assert!(line.starts_with(PRINTED), "{line}");
    }
    let counts = folder.tip(&["cycles", "c\u{200f}\n.prg"]).expect(0);
    assert!(
        counts.out.starts_with(r"c\u{200f}\u{a}.prg for "),
        "{counts:#?}"
    );
    for (arguments, status) in [
        (&["run", "none\n\u{1b}.prg"][..], 1),
        (&["robot", "import", "none\n\u{1b}.urdf"], 1),
        (&["emit", "rust", "c\u{200f}\n.prg", "-o", "no/\n\u{1b}"], 1),
        (&["check", "--robot", "\u{1b}[31m", NAME], 2),
    ] {
        let outcome = folder.tip(arguments).expect(status);
        require_printable(&outcome.err, "");
    }
}

/// Returns the output of a terminal until every process on it has ended.
#[cfg(target_os = "linux")]
fn shown(terminal: Pty) -> String {
    let Pty { fingers, line } = terminal;
    drop(line);
    let (mut shown, mut piece) = (Vec::new(), [0; 4096]);
    // A terminal that nobody holds any more fails to be read.
    while let Ok(count @ 1..) = rustix::io::read(&fingers, &mut piece) {
        shown.extend_from_slice(&piece[..count]);
    }
    String::from_utf8(shown).expect("UTF-8")
}

/// A pipe gets every byte; on a terminal none of them acts.
#[cfg(target_os = "linux")]
#[test]
fn data_has_escapes_on_a_terminal_alone() {
    use serde_json::Value;
    use std::process::Stdio;

    let text = "3.1\nt\nMESSAGE  a\u{1b}[31m\u{202e}b\u{9b}c\nEND\n";
    let folder = Folder::new("printable-terminal").file("p.prg", text);
    let on_terminal = |arguments: &[&str]| {
        let terminal = Pty::new();
        let status = folder
            .command(arguments)
            .stdout(terminal.input())
            .stderr(Stdio::null())
            .status();
        status.expect("tip starts");
        shown(terminal).replace("\r\n", "\n")
    };
    for arguments in [
        &["migrate", "p.prg"][..],
        &["emit", "formal", "p.prg"],
        &["fmt", "--diff", "p.prg"],
        &["run", "p.prg", "--trace", "-"],
    ] {
        let piped = folder.tip(arguments).out;
        assert!(piped.contains("\u{202e}b\u{9b}c"), "{arguments:?}: {piped}");
        let shown = on_terminal(arguments);
        require_printable(&shown, "");
        assert_eq!(shown.lines().count(), piped.lines().count(), "{shown}");
    }
    // A trace is JSON there, too.
    let trace = ["run", "p.prg", "--trace", "-"];
    let records = |text: &str| -> Vec<Value> {
        let records = text.lines().map(serde_json::from_str);
        records.collect::<Result<_, _>>().expect("JSON")
    };
    assert_eq!(
        records(&on_terminal(&trace)),
        records(&folder.tip(&trace).out)
    );
}
