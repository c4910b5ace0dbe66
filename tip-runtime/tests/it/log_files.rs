//! Log files belong to one program.

use std::fs;
use std::path::PathBuf;
use tip_runtime::console::{Console, LogFiles};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::{Emergency, Report};
use tip_runtime::model::generic;
use tip_runtime::program::{Context, Flow, Program, Signature};
use tip_runtime::record::{Dump, Sample};

fn folder(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("log_files")
        .join(name);
    let _ = fs::remove_dir_all(&path);
    path
}

const SAMPLE: Sample<'static> = Sample {
    cycle: 3,
    time: 60.0,
    joints_per_leg: 1,
    angles: &[1.5],
    commands: &[JointCommand::at(2.0)],
    torques: &[],
    paws: &[0.0],
    knobs: &[],
    antenna: 0.0,
};

// clauses: 7.40 9.5
#[test]
fn a_log_appears_whole_when_the_program_is_over() {
    let folder = folder("whole");
    let mut console = LogFiles::claim(&folder, "walk.prg", ()).expect("the folder is new");
    console.sample(&SAMPLE);
    assert_eq!(fs::read_dir(&folder).expect("it was made").count(), 0);
    console.ended();
    assert!(console.take_error().is_none());
    assert_eq!(fs::read_dir(&folder).expect("it was made").count(), 1);
    let text = fs::read_to_string(folder.join("TITAN.LOG")).expect("it was written");
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines[0], "# TITAN.LOG of walk.prg");
    assert_eq!(lines[1], "cycle\ttime\tJ11\tC11\tPAW1\tANTENNA");
    assert_eq!(lines[2], "3\t60.0\t1.5\t2.0\t0.0\t0.0");
}

#[test]
fn the_same_program_takes_its_folder_again_and_begins_anew() {
    let folder = folder("again");
    let mut console = LogFiles::claim(&folder, "walk.prg", ()).expect("the folder is new");
    console.warnings("a warning\n");
    console.sample(&SAMPLE);
    console.ended();
    let mut console = LogFiles::claim(&folder, "walk.prg", ()).expect("the files are ours");
    let count = || fs::read_dir(&folder).expect("it exists").count();
    assert_eq!(count(), 2, "the earlier run's until this one is over");
    console.ended();
    assert_eq!(count(), 0);
    assert!(console.take_error().is_none());
}

#[test]
fn another_program_and_a_stray_file_keep_what_is_theirs() {
    let folder = folder("foreign");
    let mut console = LogFiles::claim(&folder, "walk.prg", ()).expect("the folder is new");
    console.warnings("a warning\n");
    let error = LogFiles::claim(&folder, "turn.prg", ()).expect_err("walk.prg was here");
    assert_eq!(error.path, folder.join("WARNING.LOG"));
    fs::write(folder.join("EMG.log"), "no log of ours\n").expect("the folder is writable");
    LogFiles::claim(&folder, "walk.prg", ()).expect_err("EMG.log would be lost");
    assert!(folder.join("WARNING.LOG").exists(), "nothing was touched");
}

#[test]
fn a_log_that_cannot_be_written_is_told_once_and_hurts_nothing_else() {
    let folder = folder("gone");
    let mut console = LogFiles::claim(&folder, "walk.prg", ()).expect("the folder is new");
    console.sample(&SAMPLE);
    fs::remove_dir(&folder).expect("nothing is in it");
    console.ended();
    let error = console.take_error().expect("there is no folder");
    assert_eq!(error.path, folder.join("TITAN.LOG"));
    assert!(console.take_error().is_none());
}

#[cfg(unix)]
#[test]
fn a_pipe_in_the_place_of_a_log_is_refused_at_once() {
    let folder = folder("pipe");
    fs::create_dir_all(&folder).expect("the target folder is writable");
    let made = std::process::Command::new("mkfifo")
        .arg(folder.join("TITAN.LOG"))
        .status();
    assert!(made.expect("mkfifo starts").success());
    let refused = LogFiles::claim(&folder, "walk.prg", ()).expect_err("it is no log");
    assert_eq!(refused.path, folder.join("TITAN.LOG"));
}

/// A program of one variable with arbitrary texts about itself.
struct Talker(String);

impl Program for Talker {
    fn signature(&self) -> Signature {
        generic::MODEL.signature()
    }
    fn name(&self) -> &str {
        &self.0
    }
    fn title(&self) -> &str {
        &self.0
    }
    fn at(&self) -> u32 {
        0
    }
    fn step(&mut self, _: &mut dyn Context) -> Result<Flow, Fault> {
        Err(Fault::Domain)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        (i == 0).then_some((&*self.0, None))
    }
    fn set_scalar(&mut self, _: usize, _: f64) {}
    fn line(&self, _: u32) -> u32 {
        1
    }
    fn reset(&mut self) {}
}

fn dump(program: &Talker) -> Dump<'_> {
    Dump {
        program,
        cycle: 7,
        step: 0,
    }
}

// clauses: 7.41
#[test]
fn logs_show_what_a_program_says_as_escapes() {
    let folder = folder("escapes");
    let program = Talker("a\nb\u{1b}[2J\u{202e}".to_owned());
    let mut console = LogFiles::claim(&folder, program.name(), ()).expect("the folder is new");
    console.variables(&dump(&program));
    let emergency = Emergency {
        fault: Fault::Unassigned(0),
        step: 0,
        cycle: 7,
        thread: None,
        stop_fault: None,
    };
    let program = &program;
    console.emergency(&Report { emergency, program });
    console.ended();
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("it was written");
    let shown = r"a\u{a}b\u{1b}[2J\u{202e}";
    assert_eq!(
        read("VARIABLES.LOG"),
        format!("# VARIABLES.LOG of {shown}\n# cycle 7, step 0, line 1\n{shown}\tunassigned\n")
    );
    let report = read("EMG.log");
    let lines: Vec<_> = report.lines().skip(2).collect();
    let [name, title] = ["program", "title"].map(|word| format!("{word}\t{shown}"));
    assert_eq!(lines[..2], [name, title]);
    assert_eq!(lines.last(), Some(&&*format!("variable\t{shown}")));
}

// clauses: 7.41
#[test]
fn the_log_of_variables_is_bounded() {
    let folder = folder("bounded");
    let program = Talker("V".repeat(1 << 20));
    let mut console = LogFiles::claim(&folder, "walk.prg", ()).expect("the folder is new");
    for _ in 0..40 {
        console.variables(&dump(&program));
    }
    console.ended();
    let text = fs::read_to_string(folder.join("VARIABLES.LOG")).expect("it was written");
    assert_eq!(text.matches("# cycle").count(), 16);
    assert!(text.ends_with("\tunassigned\n# full, later ones are left out\n"));
}

// clauses: 17.2 17.3
#[test]
fn the_texts_of_a_program_are_kept_as_they_are_and_written_whole() {
    let folder = folder("output");
    let program = Talker("p".to_owned());
    let mut console = LogFiles::claim(&folder, "p.prg", ()).expect("the folder is new");
    let read = || fs::read_to_string(folder.join("FOUT.LOG"));
    console.append(&"");
    console.variables(&dump(&program));
    assert!(read().is_err(), "nothing was appended");
    console.append(&"a\tb");
    console.append(&"\nc");
    assert!(read().is_err());
    console.variables(&dump(&program));
    assert_eq!(read().expect("written"), "# FOUT.LOG of p.prg\na\tb\nc");
    console.append(&"\u{1b}\n");
    console.ended();
    assert_eq!(
        read().expect("written"),
        "# FOUT.LOG of p.prg\na\tb\nc\u{1b}\n"
    );
}

// clauses: 17.3
#[test]
fn a_text_that_does_not_fit_is_dropped_whole() {
    let folder = folder("output-full");
    let mut console = LogFiles::claim(&folder, "p.prg", ()).expect("the folder is new");
    let heading = "# FOUT.LOG of p.prg\n";
    console.append(&"x".repeat((1 << 20) - heading.len() - 2));
    console.append(&"abc");
    console.append(&"de");
    console.append(&"f");
    console.ended();
    assert_eq!(console.dropped(), 2);
    let text = fs::read_to_string(folder.join("FOUT.LOG")).expect("written");
    assert_eq!(text.len(), 1 << 20);
    assert!(text.ends_with("xde"));
}
