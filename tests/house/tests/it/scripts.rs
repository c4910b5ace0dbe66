//! The scripts, of which most run outside the gate.

use house::root;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Every script of the shell: what names it in its first line, and what others read.
fn scripts() -> Vec<PathBuf> {
    let mut found = Vec::new();
    for folder in [
        ".ci", "benches", "editors", "examples", "site", "tests", "tools",
    ] {
        collect(&root().join(folder), &mut found);
    }
    assert!(found.len() > 9, "the scripts are found: {found:?}");
    found
}

fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
    let is_output = |path: &Path| path.ends_with("target") || path.ends_with("node_modules");
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        if path.is_dir() {
            if !is_output(&path) {
                collect(&path, found);
            }
        } else if path.extension().is_none_or(|ending| ending == "sh")
            && fs::read(&path).is_ok_and(|bytes| is_script(&path, &bytes))
        {
            found.push(path);
        }
    }
}

fn is_script(path: &Path, bytes: &[u8]) -> bool {
    bytes.starts_with(b"#!") || path.extension().is_some()
}

/// The loop variables of functions that are not `local`: one that the caller declared under this name is overwritten.
fn leaks(script: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut function = None;
    for line in script.lines() {
        if let Some(name) = line.strip_suffix("() {") {
            function = Some((name, BTreeSet::new()));
        } else if line == "}" {
            function = None;
        } else if let Some((name, own)) = &mut function {
            let words: Vec<&str> = line.split_whitespace().collect();
            if let ["local", declared @ ..] = &words[..] {
                let names = declared
                    .iter()
                    .map(|word| word.split('=').next().unwrap_or(word));
                own.extend(names.map(str::to_owned));
            }
            let leaked = set(&words).into_iter().filter(|word| !own.contains(*word));
            found.extend(leaked.map(|word| format!("{name}: {word}")));
        }
    }
    found
}

/// The variables that a line sets as a loop.
fn set<'l>(words: &[&'l str]) -> Vec<&'l str> {
    match words {
        ["for", head, ..] if head.starts_with("((") => {
            let name = head.trim_start_matches('(').split('=').next();
            name.into_iter().collect()
        }
        // A parenthesis makes it a loop of awk.
        ["for" | "select", name, ..] if !name.starts_with('(') => vec![name],
        ["while", rest @ ..] => {
            let reads = rest.iter().skip_while(|word| **word != "read").skip(1);
            let names = reads.map(|word| word.trim_end_matches(';'));
            let names = names.take_while(|word| *word != "do" && !word.starts_with('<'));
            names.filter(|word| !word.starts_with('-')).collect()
        }
        _ => Vec::new(),
    }
}

#[test]
fn functions_of_scripts_keep_their_variables_to_themselves() {
    let leaking = "f() {\n  local a b=1\n  for c in 1 2; do\n  for a in 1; do\n  while read -r b d; do\n}\n\
                   for c in 1; do";
    assert_eq!(leaks(leaking), ["f: c", "f: d"]);
    for path in scripts() {
        let text = fs::read_to_string(&path).expect("scripts are UTF-8");
        assert_eq!(leaks(&text), [""; 0], "{}", path.display());
    }
}

/// On a machine on which the compiler has still to be unpacked.
#[cfg(target_os = "linux")]
#[test]
fn the_first_run_of_a_bare_metal_script_builds_the_package_that_was_asked_for() {
    use std::os::unix::fs::PermissionsExt;
    use std::process::Command;

    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("first-run");
    let _ = fs::remove_dir_all(&folder);
    let bin = folder.join("bin");
    let linker = folder.join("lib/rustlib/here/bin");
    for folder in [&bin, &linker] {
        fs::create_dir_all(folder).expect("the target folder is writable");
    }
    let tool = |path: PathBuf, script: &str| {
        fs::write(&path, format!("#!/bin/sh\n{script}\n")).expect("a script");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("it is ours");
    };
    tool(bin.join("apt-get"), "touch one.deb two.deb");
    tool(
        bin.join("apt-cache"),
        "echo '  Candidate: 1.90'; echo '  Depends: lib'",
    );
    tool(bin.join("dpkg"), "exit 0");
    tool(bin.join("cargo"), "echo \"$@\"");
    let sysroot = folder.display();
    tool(
        bin.join("rustc"),
        &format!("case $1 in -vV) echo host: here ;; *) echo {sysroot} ;; esac"),
    );
    tool(linker.join("rust-lld"), "exit 0");

    let script = "set -euo pipefail\n. ./debian-rust.sh\nbuild_for wasm32-unknown-unknown wasm";
    let path = std::env::var("PATH").unwrap_or_default();
    let run = || {
        let output = Command::new("bash")
            .args(["-c", script])
            .current_dir(root().join("examples/bare-metal"))
            .env("PATH", format!("{}:{path}", bin.display()))
            .env("CARGO_TARGET_DIR", folder.join("target"))
            .output()
            .expect("bash starts");
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{told}");
        told
    };
    for (run, is_first) in [(run(), true), (run(), false)] {
        assert_eq!(run.contains("unpacking"), is_first, "{run}");
        assert!(run.trim_end().ends_with("--package wasm"), "{run}");
    }
}

#[test]
fn each_script_begins_with_what_it_does() {
    for path in scripts() {
        let text = fs::read_to_string(&path).expect("scripts are UTF-8");
        let first = text.lines().find(|line| !line.starts_with("#!"));
        let says = first.is_some_and(|line| line.starts_with("# ") && line.len() > 30);
        assert!(says, "{}: {first:?}", path.display());
    }
}

/// What every machine has.
#[cfg(target_os = "linux")]
const USUAL: [&str; 14] = [
    "awk", "bash", "cat", "dirname", "find", "grep", "mkdir", "mktemp", "rm", "sed", "sort",
    "stat", "tr", "uname",
];

/// The scripts outside the gate, what each is asked for, and what it needs beside Cargo.
#[cfg(target_os = "linux")]
const NEEDS: [(&str, &[&str], &[&str]); 23] = [
    ("benches/builds", &["cli"], &["strip is not installed"]),
    (
        "editors/vscode/build",
        &[],
        &["node is not installed", "npm is not installed"],
    ),
    (
        "examples/bare-metal/cortex-m.sh",
        &[],
        &[
            "qemu-system-arm is not installed",
            "readelf is not installed",
        ],
    ),
    (
        "examples/bare-metal/wasm.sh",
        &[],
        &["node is not installed"],
    ),
    ("examples/mujoco/run", &[], &["python3 is not installed"]),
    (
        "site/build",
        &[],
        &["node is not installed", "npm is not installed"],
    ),
    (
        "tests/advisories/run",
        &[],
        &["cargo-deny is not installed: cargo install cargo-deny"],
    ),
    (
        "tests/browser/run",
        &[],
        &[
            "node is not installed",
            "npm is not installed",
            "chromium is not installed",
        ],
    ),
    (
        "tests/coverage/run",
        &[],
        &[
            "no nightly toolchain",
            "cargo-llvm-cov is not installed: cargo install cargo-llvm-cov",
        ],
    ),
    (
        "tests/debugger/run",
        &[],
        &["node is not installed", "npm is not installed"],
    ),
    (
        "tests/fuzz/minimise",
        &[],
        &[
            "no nightly toolchain",
            "cargo-fuzz is not installed: cargo install cargo-fuzz",
        ],
    ),
    (
        "tests/fuzz/run",
        &[],
        &[
            "no nightly toolchain",
            "cargo-fuzz is not installed: cargo install cargo-fuzz",
        ],
    ),
    ("tests/editors/bench", &[], &["python3 is not installed"]),
    (
        "tests/editors/run",
        &[],
        &[
            "node is not installed",
            "python3 is not installed",
            "nvim is not installed",
        ],
    ),
    (
        "tests/logs/run",
        &[],
        &["python3 is not installed", "rerun is not installed"],
    ),
    ("tests/mujoco/run", &[], &["python3 is not installed"]),
    (
        "tests/mutants/run",
        &["lower"],
        &["cargo-mutants is not installed: cargo install cargo-mutants"],
    ),
    ("tests/readme/run", &[], &["git is not installed"]),
    ("tests/urdf/published", &[], &["python3 is not installed"]),
    ("tests/urdf/run", &[], &["python3 is not installed"]),
    (
        "tests/vscode/install",
        &["unused"],
        &[
            "python3 is not installed",
            "g++ is not installed",
            "make is not installed",
        ],
    ),
    (
        "tests/vscode/run",
        &["host"],
        &[
            "node is not installed",
            "npm is not installed",
            "chromium is not installed",
        ],
    ),
    (
        "tools/view/page/build",
        &[],
        &["node is not installed", "npm is not installed"],
    ),
];

/// Those that build nothing of Rust.
#[cfg(target_os = "linux")]
const WITHOUT_RUST: [&str; 3] = [
    "editors/vscode/build",
    "tests/vscode/install",
    "tools/view/page/build",
];

/// On a machine that lacks every tool, and on one that has Cargo alone.
#[cfg(target_os = "linux")]
#[test]
fn a_script_names_every_tool_that_it_lacks_and_does_nothing() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::Command;

    let named = scripts().into_iter().filter(|path| {
        let is_run = path.extension().is_none()
            || fs::metadata(path).is_ok_and(|found| found.permissions().mode() & 1 == 1);
        // Those beside the gate need the toolchain alone.
        is_run && !path.starts_with(root().join(".ci"))
    });
    let named: BTreeSet<PathBuf> = named.collect();
    let tried: BTreeSet<PathBuf> = NEEDS.iter().map(|(name, ..)| root().join(name)).collect();
    assert_eq!(named, tried, "each script has its row");

    let bin = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no-tools");
    let _ = fs::remove_dir_all(&bin);
    fs::create_dir_all(&bin).expect("the target folder is writable");
    let path = std::env::var_os("PATH").unwrap_or_default();
    for name in USUAL {
        let mut folders = std::env::split_paths(&path);
        let tool = folders.find_map(|folder| fs::canonicalize(folder.join(name)).ok());
        symlink(tool.expect("every machine has it"), bin.join(name)).expect("a link");
    }
    for has_cargo in [false, true] {
        if has_cargo {
            for name in ["cargo", "rustc"] {
                let path = bin.join(name);
                fs::write(&path, "#!/bin/sh\necho \"$@\" >>\"$0.asked\"\nexit 1\n")
                    .expect("a script");
                fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("it is ours");
            }
        }
        for (name, arguments, needs) in NEEDS {
            let folder = root().join(name);
            let folder = folder.parent().expect("a folder");
            let before = fs::read_dir(folder).expect("it is there").count();
            let output = Command::new("bash")
                .arg(root().join(name))
                .args(arguments)
                .env_clear()
                .env("PATH", &bin)
                .output()
                .expect("bash starts");
            let told = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(77), "{name}: {told}");
            let needs_cargo = !WITHOUT_RUST.contains(&name);
            assert_eq!(
                told.contains("SKIPPED: cargo is not installed"),
                needs_cargo && !has_cargo,
                "{name}: {told}"
            );
            for need in needs {
                assert!(told.contains(need), "{name}: {need}: {told}");
            }
            assert_eq!(
                fs::read_dir(folder).expect("it is there").count(),
                before,
                "{name}"
            );
        }
    }
    let asked = fs::read_to_string(bin.join("cargo.asked")).expect("for a toolchain");
    assert!(
        asked.lines().all(|line| line == "+nightly --version"),
        "{asked}"
    );
}
