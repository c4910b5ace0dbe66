//! rustc over emitted programs: processor time and peak memory, by the number of steps.

use crate::long::mixed;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;
use tipc::{Options, emit, load};

/// The numbers of steps.
const STEPS: &[usize] = &[1_000, 5_000, 10_000, 50_000];
/// Polling interval for a compiler's usage: the last sample is at most this old.
const PERIOD: Duration = Duration::from_millis(10);
/// The kernel counts processor time in hundredths of a second.
const TICKS: f64 = 100.0;

/// Prints what rustc needs for a thousand steps.
pub(crate) fn print() -> Result<(), Box<dyn Error>> {
    println!("| steps | profile | s | s per 1,000 steps | peak MB |\n|---:|---|---:|---:|---:|");
    for release in [false, true] {
        let runtime = Runtime::build(release)?;
        for steps in STEPS {
            let file = write(*steps)?;
            let used = used(runtime.compile(&file))?;
            let profile = if release { "release" } else { "debug" };
            let each = used.seconds * 1e3 / *steps as f64;
            println!(
                "| {steps} | {profile} | {:.2} | {each:.2} | {:.0} |",
                used.seconds, used.megabytes
            );
        }
    }
    Ok(())
}

/// Returns the folder of this crate's own files.
fn folder() -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or("target".into(), PathBuf::from);
    target.join("emitted")
}

/// A program of that many steps as Rust.
fn write(steps: usize) -> Result<PathBuf, Box<dyn Error>> {
    let loaded = load("long.prg", mixed(steps).as_bytes(), &Options::default());
    let program = loaded.program.ok_or("the program does not load")?;
    let options = emit::Options {
        visibility: "pub".parse()?,
        ..emit::Options::default()
    };
    fs::create_dir_all(folder())?;
    let file = folder().join(format!("steps{steps}.rs"));
    fs::write(&file, emit::pretty(&program, &options)?)?;
    Ok(file)
}

/// The runtime as a library to link with.
struct Runtime {
    release: bool,
    library: PathBuf,
}

impl Runtime {
    fn build(release: bool) -> Result<Self, Box<dyn Error>> {
        let mut cargo = Command::new("cargo");
        cargo.args([
            "build",
            "--quiet",
            "--message-format",
            "json",
            "--package",
            "tip-runtime",
        ]);
        cargo.args(release.then_some("--release"));
        let output = cargo.stderr(Stdio::inherit()).output()?;
        let library = String::from_utf8(output.stdout)?
            .lines()
            .filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok())
            .filter(|message| message["target"]["name"] == "tip_runtime")
            .find_map(|message| Some(PathBuf::from(message["filenames"][0].as_str()?)))
            .ok_or("cargo built no runtime")?;
        Ok(Runtime { release, library })
    }

    /// rustc, with the flags that cargo gives it.
    fn compile(&self, file: &Path) -> Command {
        let mut rustc = Command::new("rustc");
        rustc.args(["--edition", "2024", "--crate-type", "lib", "--emit", "link"]);
        rustc.args(match self.release {
            true => ["-C", "opt-level=3"],
            false => ["-C", "debuginfo=2"],
        });
        rustc
            .arg("--extern")
            .arg(format!("tip_runtime={}", self.library.display()));
        let folder = self.library.parent().unwrap_or(Path::new("."));
        rustc
            .arg("-L")
            .arg(format!("dependency={}", folder.join("deps").display()));
        rustc.arg("--out-dir").arg(self::folder()).arg(file);
        rustc
    }
}

/// Resource usage of a process.
#[derive(Default)]
struct Used {
    seconds: f64,
    megabytes: f64,
}

/// Runs a compiler to its end.
fn used(mut command: Command) -> Result<Used, Box<dyn Error>> {
    let mut child = command.spawn()?;
    let mut used = Used::default();
    loop {
        if let Some(now) = now(&child) {
            used = now;
        }
        if let Some(status) = child.try_wait()? {
            return match status.success() {
                true => Ok(used),
                false => Err("rustc refuses the emitted program".into()),
            };
        }
        sleep(PERIOD);
    }
}

/// Returns the usage of a process so far, from Linux's `/proc`; `None` for one that has ended.
fn now(child: &Child) -> Option<Used> {
    let file = |name: &str| fs::read_to_string(format!("/proc/{}/{name}", child.id())).ok();
    let stat = file("stat")?;
    // Behind the program's name in brackets; the times are fields 14 and 15 of all.
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |field: usize| fields.get(field - 3)?.parse::<f64>().ok();
    let status = file("status")?;
    let peak = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = peak.trim().trim_end_matches("kB").trim().parse().ok()?;
    Some(Used {
        seconds: (ticks(14)? + ticks(15)?) / TICKS,
        megabytes: kilobytes / 1024.0,
    })
}
