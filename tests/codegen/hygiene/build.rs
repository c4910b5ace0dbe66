//! Programs and a robot that bear the names of the prelude, and a program whose texts break out of comments if they can.

use std::error::Error;
use tipc::emit;

/// Characters of file names: line ends, code after them, bidirectional controls, control characters.
const NAME: &str =
    "hostile\ncompile_error!(\"live\");\r\u{202E}\u{2066}\u{2028}\u{1b}\u{85}*` \"#.prg";
/// Characters of texts.
const TEXT: &str = "compile_error!(\"live\") \u{202E}\u{2066}\u{2028}\u{1b}\u{85}*/ \"#";

fn main() -> Result<(), Box<dyn Error>> {
    let mut config = tipc::Config::new();
    config.runtime_path("::robot");
    config.compile(&["motions/ok.prg", "motions/option.prg"])?;
    config.compile_robot("motions/some.toml")?;
    hostile()
}

/// A program of a hostile name, title and texts.
#[allow(
    clippy::disallowed_methods,
    reason = "a build script of a test writes what it generates"
)]
fn hostile() -> Result<(), Box<dyn Error>> {
    let program = format!("3.1\n{TEXT}\nREM {TEXT}\nMESSAGE {TEXT}\nEND\n");
    let loaded = tipc::load(NAME, program.as_bytes(), &tipc::Options::default());
    let program = loaded.program.ok_or("the program loads")?;
    let options = emit::Options {
        visibility: "pub".parse()?,
        runtime: "::robot".parse()?,
        ..emit::Options::default()
    };
    let code = emit::pretty(&program, &options)?;
    let folder = std::env::var_os("OUT_DIR").ok_or("Cargo sets OUT_DIR")?;
    std::fs::write(std::path::Path::new(&folder).join("hostile.rs"), code)?;
    Ok(())
}
