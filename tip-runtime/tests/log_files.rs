//! Log files belong to one program.
#![cfg(feature = "std")]

use std::fs;
use std::path::PathBuf;
use tip_runtime::console::{Console, LogFiles};
use tip_runtime::hardware::JointCommand;
use tip_runtime::record::Sample;

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

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_the_earlier_file_whole_and_no_part_of_the_new_one() {
    use std::io::ErrorKind;
    let folder = folder("full");
    let mut console = LogFiles::claim(&folder, "walk.prg", ()).expect("the folder is new");
    console.warnings("a warning\n");
    let log = folder.join("WARNING.LOG");
    let before = fs::read_to_string(&log).expect("it was written");
    // What is written beside the log goes to a device that is always full.
    let part = folder.join(format!(".WARNING.LOG.{}.part", std::process::id()));
    std::os::unix::fs::symlink("/dev/full", part).expect("the folder is writable");
    console.warnings("another warning\n");
    let error = console.take_error().expect("the disk is full");
    assert_eq!(error.reason.kind(), ErrorKind::StorageFull);
    assert_eq!(fs::read_to_string(&log).expect("it is there"), before);
    assert_eq!(fs::read_dir(&folder).expect("it exists").count(), 1);
    console.warnings("another warning\n");
    let after = fs::read_to_string(&log).expect("there is room again");
    assert!(after.ends_with("\nanother warning\n"), "{after}");
}
