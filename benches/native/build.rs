//! Compiles the motions with tipc, and spells the same motions for the peers that are compiled.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

/// The generated motions: their names and lengths.
const GENERATED: &[(&str, usize)] = &[
    ("steps100", 100),
    ("steps1000", 1_000),
    ("steps10000", 10_000),
];

fn main() -> Result<(), Box<dyn Error>> {
    let out = env::var("OUT_DIR")?;
    let out = Path::new(&out);
    let walk = fs::read_to_string("motions/walk_loop.prg")?;
    let mut motions = vec![("walk_loop", walk)];
    motions.extend(
        GENERATED
            .iter()
            .map(|(name, steps)| (*name, peers::generated::program(*steps))),
    );
    let mut c = cc::Build::new();
    c.opt_level(2)
        .debug(false)
        .include("src")
        .file("src/robot.c");
    for (name, text) in &motions {
        let source = out.join(format!("{name}.prg"));
        fs::write(&source, text)?;
        tipc::compile(&source)?;
        let program = peers::load(name, text);
        let spelt = |language: &str| out.join(format!("{name}_{language}"));
        fs::write(spelt("by_hand.rs"), peers::rust::spell(&program))?;
        fs::write(spelt("statig.rs"), peers::statig::spell(&program))?;
        fs::write(spelt("switch.c"), peers::c::spell(&program, name))?;
        c.file(spelt("switch.c"));
    }
    c.compile("switches");
    for input in ["build.rs", "motions", "src/motion.h", "src/robot.c"] {
        println!("cargo::rerun-if-changed={input}");
    }
    Ok(())
}
