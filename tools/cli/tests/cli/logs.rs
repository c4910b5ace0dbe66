//! `tip run --out-dir`: the log files of the language.

use crate::support::Folder;

// clauses: 7.40 9.5
#[test]
fn sampled_rows_make_titan_log() {
    let program = "LOG_START\nREM\nLOG_STOP\nREM\nLOG_ONE_SHOT\nEND";
    let folder = Folder::new("titan-log").program("p.prg", program);
    folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(0);
    let log = folder.read("logs/TITAN.LOG");
    let lines: Vec<_> = log.lines().collect();
    assert_eq!(lines[0], "# TITAN.LOG of ../p.prg");
    let headings: Vec<_> = lines[1].split('\t').collect();
    assert_eq!(headings[..3], ["cycle", "time", "J11"]);
    assert!(headings.contains(&"C43") && headings.contains(&"PAW4") && headings.contains(&"VR3"));
    // The cycle of LOG_STOP is not sampled, that of LOG_START and of LOG_ONE_SHOT is.
    let cycles: Vec<_> = lines[2..]
        .iter()
        .map(|line| line.split('\t').next().unwrap_or(""))
        .collect();
    assert_eq!(cycles, ["0", "1", "4"]);
    assert!(
        lines[2..]
            .iter()
            .all(|line| line.split('\t').count() == headings.len())
    );
}

// clauses: 7.41 9.5
#[test]
fn variables_are_dumped_each_time_they_are_asked_for() {
    let program = "DEF_VAR A\nDEF_POS P\nOUTPUT_VARIABLES\nA = 0.5\nP.Y = A\nP.X = P.Y\nP.Z = P.X\nOUTPUT_VARIABLES\nEND";
    let folder = Folder::new("variables-log").program("p.prg", program);
    folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(0);
    assert_eq!(
        folder.read("logs/VARIABLES.LOG"),
        "# VARIABLES.LOG of ../p.prg\n\
         # cycle 0, step 0, line 5\nVAR_KEY\tunassigned\nA\tunassigned\nP.X\tunassigned\nP.Y\tunassigned\nP.Z\tunassigned\n\
         # cycle 5, step 5, line 10\nVAR_KEY\tunassigned\nA\t0.5\nP.X\t0.5\nP.Y\t0.5\nP.Z\t0.5\n"
    );
}

// clauses: 8.1 9.5
#[test]
fn an_emergency_leaves_a_report() {
    let folder = Folder::new("emg-log").program("p.prg", "RETURN\nEND");
    folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(3);
    let log = folder.read("logs/EMG.log");
    let lines: Vec<_> = log.lines().collect();
    assert_eq!(lines[0], "# EMG.log of ../p.prg");
    assert_eq!(lines[1], "TIP_ERR:Invalid Return command (RuntimeError)");
    assert!(
        lines.contains(&"step\t0") && lines.contains(&"line\t3") && lines.contains(&"cycle\t0"),
        "{log}"
    );
}

// clauses: 9.3 3.4
#[test]
fn warnings_are_kept() {
    let folder = Folder::new("warning-log").program("p.prg", "DEF_VAR N\nEND");
    folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(0);
    assert_eq!(
        folder.read("logs/WARNING.LOG"),
        "# WARNING.LOG of ../p.prg\np.prg:3:9: warning: variable \"N\" is declared but never used\n"
    );
    let files = folder.names();
    assert_eq!(files, ["logs", "p.prg"]);
}

#[test]
fn nothing_is_written_where_nobody_asked() {
    let program = "DEF_VAR A\nLOG_ONE_SHOT\nOUTPUT_VARIABLES\nRETURN\nEND";
    let folder = Folder::new("no-logs").program("p.prg", program);
    folder.tip(&["run", "p.prg"]).expect(3);
    assert_eq!(folder.names(), ["p.prg"]);
}

#[test]
fn a_later_run_of_the_same_program_replaces_its_files() {
    let folder = Folder::new("logs-again").program("p.prg", "RETURN\nEND");
    folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(3);
    let folder = folder.program("p.prg", "LOG_ONE_SHOT\nEND");
    folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(0);
    assert!(!folder.has("logs/EMG.log"), "the report of the run before");
    assert!(folder.has("logs/TITAN.LOG"));
}

// clauses: 8.1
#[test]
fn files_of_another_program_are_never_replaced() {
    let folder = Folder::new("logs-foreign")
        .program("a.prg", "LOG_ONE_SHOT\nEND")
        .program("b.prg", "LOG_ONE_SHOT\nMESSAGE ran\nEND");
    folder.tip(&["run", "a.prg", "--out-dir", "logs"]).expect(0);
    let before = folder.read("logs/TITAN.LOG");
    let outcome = folder.tip(&["run", "b.prg", "--out-dir", "logs"]).expect(1);
    assert!(outcome.err.contains("error: cannot write "), "{outcome:#?}");
    assert_eq!(outcome.out, "", "the program must not have run");
    assert_eq!(folder.read("logs/TITAN.LOG"), before);
}

#[test]
fn programs_of_the_same_name_in_other_folders_are_others() {
    let folder = Folder::new("logs-namesake")
        .program("a/p.prg", "LOG_ONE_SHOT\nEND")
        .program("b/p.prg", "LOG_ONE_SHOT\nEND");
    folder
        .tip(&["run", "a/p.prg", "--out-dir", "logs"])
        .expect(0);
    let before = folder.read("logs/TITAN.LOG");
    folder
        .tip(&["run", "b/p.prg", "--out-dir", "logs"])
        .expect(1);
    assert_eq!(folder.read("logs/TITAN.LOG"), before);
    // The same program by another path is no other.
    folder
        .tip(&["run", "a/../a/p.prg", "--out-dir", "logs/../logs"])
        .expect(0);
}

#[test]
fn a_program_that_is_not_there_takes_no_folder() {
    let folder = Folder::new("logs-ghost");
    folder.tip(&["run", "p.prg", "--out-dir", "logs"]).expect(1);
    assert!(!folder.has("logs"));
}

#[test]
fn a_file_that_is_no_log_is_never_replaced() {
    let folder = Folder::new("logs-precious")
        .program("p.prg", "LOG_ONE_SHOT\nEND")
        .file("TITAN.LOG", "notes of a lifetime\n");
    folder.tip(&["run", "p.prg", "--out-dir", "."]).expect(1);
    assert_eq!(folder.read("TITAN.LOG"), "notes of a lifetime\n");
    assert!(!folder.has("WARNING.LOG"));
}
