//! Compiles language cases to Rust, for the tests to run: those that `covering.txt` lists, or all of them with
//! `TIP_ALL_PROGRAMS=1`.
#![expect(
    clippy::disallowed_methods,
    clippy::disallowed_macros,
    reason = "a build script reads and writes files and talks to Cargo"
)]

use case_files::Settings;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};
use tipc::{Options, emit};

fn main() {
    let root = env::var("CARGO_MANIFEST_DIR").expect("Cargo sets it");
    let out = env::var("OUT_DIR").expect("Cargo sets it");
    let (root, out) = (Path::new(&root), Path::new(&out));
    println!("cargo::rerun-if-changed=cases");
    println!("cargo::rerun-if-changed=covering.txt");
    println!("cargo::rerun-if-env-changed=TIP_ALL_PROGRAMS");
    let covering = fs::read_to_string(root.join("covering.txt")).unwrap_or_default();
    let covering: BTreeSet<&str> = covering.lines().collect();
    let is_all = env::var_os("TIP_ALL_PROGRAMS").is_some();
    let is_wanted = |case: &str| is_all || covering.contains(case);
    write(
        &out.join("cases.rs"),
        &cases(&root.join("cases"), out, &is_wanted),
    );
}

/// A module for each wanted case that runs, the function that finds it, and a test for each.
fn cases(folder: &Path, out: &Path, is_wanted: &dyn Fn(&str) -> bool) -> String {
    let mut programs = Programs::default();
    let mut tests = String::new();
    for case in case_files::cases(folder)
        .into_iter()
        .filter(|case| is_wanted(case))
    {
        let function = case.replace(['/', '-', '.'], "_");
        let read = |kind: &str| fs::read_to_string(folder.join(format!("{case}.{kind}")));
        let (test, text) = match (read("trace"), read("stops")) {
            (Ok(text), _) => ("traced", text),
            (_, Ok(text)) => ("stopped", text),
            // The interpreter's tests hold what the compiler says.
            _ => continue,
        };
        writeln!(
            tests,
            "#[test]\nfn {function}() {{ tip_tests::{test}({case:?}); }}"
        )
        .unwrap();
        let path = folder.join(format!("{case}.prg"));
        let beside = path.parent().unwrap_or(folder);
        let source = fs::read(&path).unwrap_or_default();
        for settings in Settings::of_header(&text, beside).unwrap_or_default() {
            // A case that does not load has no program; its test says so.
            programs.add(&settings.key(&case), &case, &source, settings.load);
        }
    }
    write(&out.join("case_tests.rs"), &tests);
    programs.finish()
}

/// Generated programs on their way to a file.
#[derive(Default)]
struct Programs {
    modules: String,
    arms: String,
    count: usize,
}

impl Programs {
    /// `key` is what the program is found by.
    fn add(&mut self, key: &str, name: &str, source: &[u8], options: Options) {
        let loaded = tipc::load(&format!("{name}.prg"), source, &options);
        let Some(program) = loaded.program else {
            return;
        };
        let spelling = emit::Options {
            visibility: "pub(super)".parse().expect("a visibility"),
            ..emit::Options::default()
        };
        let module = format!("program_{}", self.count);
        let kind = spelling.name_for(program.source_name());
        let items = emit::emit(&program, &spelling);
        writeln!(self.modules, "mod {module} {{ {items} }}").unwrap();
        let arm = format!("{key:?} => tip_sim::ProgramRunner::new({module}::{kind}::new()),");
        writeln!(self.arms, "{arm}").unwrap();
        self.count += 1;
    }

    fn finish(self) -> String {
        let Programs { modules, arms, .. } = self;
        format!(
            "{modules}
/// The generated code of a program; `None` if it does not load.
pub fn case(name: &str) -> Option<tip_sim::ProgramRunner> {{
    Some(match name {{
        {arms}
        _ => return None,
    }})
}}
"
        )
    }
}

fn write(path: &Path, text: &str) {
    fs::write(path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}
