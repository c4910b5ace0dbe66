//! The C program, compiled with the machine's compiler and the library that cargo has just built.
#![cfg(target_os = "linux")]

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use tip_runtime::machine::Machine;
use tip_runtime::model::titan8::MODEL;
use walk_c::{JOINTS, LEGS, Walk, WalkOutputs, WalkSensors, walk_cycle};

/// Returns the newest static library beside this test.
fn library() -> PathBuf {
    let own = env::current_exe().expect("this test");
    let folder = own.parent().expect("a folder");
    let entries = fs::read_dir(folder).expect("a folder");
    let libraries = entries.filter_map(|entry| {
        let path = entry.ok()?.path();
        let name = path.file_name()?.to_str()?;
        (name.starts_with("libwalk_c") && name.ends_with(".a")).then_some(path)
    });
    let time = |path: &PathBuf| fs::metadata(path).and_then(|data| data.modified()).ok();
    libraries
        .max_by_key(time)
        .expect("cargo builds the library")
}

/// Joints like those of `main.c`.
struct Joints([[f64; JOINTS]; LEGS]);

impl Hardware<LEGS, JOINTS> for Joints {
    fn read(&mut self, into: &mut Sensors<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        into.angles = self.0;
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        self.0 = outputs.joints.map(|leg| leg.map(|joint| joint.value()));
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        Ok(())
    }
}

#[test]
fn the_c_program_gives_the_commands_of_the_rust_one() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("walk");
    let compiled = Command::new("cc")
        .args(["-std=c11", "-Wall", "-Wextra", "-Werror"])
        .arg(here.join("main.c"))
        .arg(library())
        .args(["-o".as_ref(), program.as_os_str()])
        .args(["-lpthread", "-ldl", "-lm"])
        .output()
        .expect("a C compiler");
    let errors = String::from_utf8_lossy(&compiled.stderr);
    assert!(compiled.status.success(), "{errors}");
    let output = Command::new(&program).output().expect("it starts");
    assert!(output.status.success(), "{output:?}");

    let joints = Joints(MODEL.legs.map(|leg| leg.initial));
    let robot = Machine::new(Walk::new(), &MODEL, joints, (), ());
    let mut robot = robot.expect("its robot");
    let mut expected = String::new();
    loop {
        let goes_on = robot.cycle().is_running();
        let angles = robot.hardware().0;
        let bits = angles.as_flattened().iter().map(|angle| angle.to_bits());
        let words: Vec<String> = bits.map(|bits| format!("{bits:016x}")).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(expected, "{}", words.join(" "));
        if !goes_on {
            break;
        }
    }
    assert!(expected.lines().count() > 500);
    let same = String::from_utf8_lossy(&output.stdout) == expected;
    assert!(same, "the traces differ");
}

/// The objects of the motion ask for no allocator: what they need is on the stack or static. The one that the compiler adds to a
/// static library defines some.
#[test]
fn the_motion_does_not_allocate() {
    let output = Command::new("nm").arg("-A").arg(library()).output();
    let output = output.expect("nm comes with the C compiler");
    let text = String::from_utf8_lossy(&output.stdout);
    let lines = text.lines().filter(|line| line.contains(":walk_c-"));
    let own: Vec<&str> = lines.collect();
    let has_cycle = own.iter().any(|line| line.ends_with(" T walk_cycle"));
    assert!(has_cycle, "{} symbols", own.len());
    let asked = own.iter().filter(|line| line.contains(" U "));
    let allocates = |line: &&&str| {
        ["rust_alloc", "rust_realloc", "malloc"]
            .iter()
            .any(|name| line.contains(name))
    };
    let found: Vec<_> = asked.filter(allocates).collect();
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn a_cycle_before_the_start_is_refused() {
    let mut outputs = WalkOutputs::default();
    assert_eq!(walk_cycle(&WalkSensors::default(), &mut outputs), 3);
}
