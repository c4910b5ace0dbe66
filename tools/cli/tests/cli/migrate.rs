//! `tip migrate`

use crate::support::Folder;

const OLD: &str = "2.0\nwalk\nVAR01 = - 5\nSTAND_UP VAR01\nEND\n";
const NEW: &str = "3.1\nwalk\nDEF_VAR VAR01\nVAR01 = -5\nSTAND_UP VAR01\nEND\n";

// clauses: 10.1
#[test]
fn the_new_program_is_written_and_the_changes_are_reported() {
    let folder = Folder::new("migrate").file("old.prg", OLD);
    let outcome = folder
        .tip(&["migrate", "old.prg", "-o", "new.prg"])
        .expect(0);
    assert_eq!(outcome.out, "");
    assert_eq!(folder.read("new.prg"), NEW);
    assert_eq!(folder.read("old.prg"), OLD);
    for text in [
        "old.prg:1:1: change: ",
        "old.prg:3:9: change: ",
        "loads for titan8\n",
    ] {
        assert!(outcome.err.contains(text), "{outcome:#?}");
    }
    folder.tip(&["check", "new.prg"]).expect(0);
}

// clauses: 10.1
#[test]
fn without_a_file_it_goes_to_standard_output() {
    let folder = Folder::new("migrate-out").file("old.prg", OLD);
    assert_eq!(folder.tip(&["migrate", "old.prg"]).expect(0).out, NEW);
    // Shift_JIS comes out as it went in.
    let folder = Folder::new("migrate-sjis").file("old.prg", b"2.0\n\x95\x5C\nEND\n");
    let output = folder.command(&["migrate", "old.prg"]).output();
    assert_eq!(output.expect("tip runs").stdout, b"3.1\n\x95\x5C\nEND\n");
}

// clauses: 10.1
#[test]
fn a_question_keeps_it_from_writing() {
    let folder = Folder::new("migrate-asked").file("old.prg", "2.0\nt\nMESSAGE a;b\nEND\n");
    for arguments in [
        &["migrate", "old.prg", "-o", "new.prg"][..],
        &["migrate", "old.prg"][..],
    ] {
        let outcome = folder.tip(arguments).expect(1);
        assert_eq!(outcome.out, "");
        assert!(
            outcome.err.contains("old.prg:3:10: question: "),
            "{outcome:#?}"
        );
        assert!(outcome.err.contains("\n    MESSAGE a;b\n"), "{outcome:#?}");
        assert!(
            outcome
                .err
                .contains("1 question to answer first, nothing is written")
        );
    }
    assert_eq!(folder.names(), ["old.prg"]);
}

// clauses: 10.1
#[test]
fn a_program_of_3_1_is_copied_and_said_to_be_one() {
    let folder = Folder::new("migrate-same").file("old.prg", NEW);
    let outcome = folder
        .tip(&["migrate", "old.prg", "-o", "new.prg"])
        .expect(0);
    assert_eq!(folder.read("new.prg"), NEW);
    assert_eq!(
        outcome.err,
        "old.prg: is a program of version 3.1 already, nothing is changed\n"
    );
}

// clauses: 10.1
#[test]
fn a_program_of_3_2_stays_one_and_is_said_to_be_one() {
    let folder = Folder::new("migrate-next").file("new.prg", "3.2\ntitle\nEND\n");
    for options in [&[][..], &["--to", "3.2"]] {
        let outcome = folder.tip(&[&["migrate", "new.prg"], options].concat());
        assert_eq!(
            outcome.expect(0).err,
            "new.prg: is a program of version 3.2 already, nothing is changed\n"
        );
    }
}

#[test]
fn the_report_has_forms_for_tools() {
    let folder = Folder::new("migrate-tools").file("old.prg", OLD);
    let report = |format| {
        let arguments = [
            "migrate",
            "old.prg",
            "-o",
            "new.prg",
            "--message-format",
            format,
        ];
        folder.tip(&arguments).expect(0).err
    };
    assert_eq!(report("short").lines().count(), 3);
    let json: Vec<serde_json::Value> = report("json")
        .lines()
        .map(|line| serde_json::from_str(line).expect("an object"))
        .collect();
    assert_eq!(json.len(), 3);
    assert_eq!(json[2]["level"], "change");
    assert_eq!(
        (&json[2]["line"], &json[2]["column"]),
        (&3.into(), &9.into())
    );
    assert_eq!(json[2]["file"], "old.prg");
}

#[test]
fn files_that_cannot_be_read_or_written() {
    let folder = Folder::new("migrate-files").file("old.prg", OLD);
    let outcome = folder.tip(&["migrate", "none.prg"]).expect(1);
    assert!(
        outcome.err.contains("File not found(none.prg)"),
        "{outcome:#?}"
    );
    let outcome = folder
        .tip(&["migrate", "old.prg", "-o", "./old.prg"])
        .expect(1);
    assert!(
        outcome.err.contains("cannot write ./old.prg: "),
        "{outcome:#?}"
    );
    assert_eq!(folder.read("old.prg"), OLD);
}
