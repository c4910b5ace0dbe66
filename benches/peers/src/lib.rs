//! Spells a motion program in the languages that are measured beside TIP. Each spelling does in each
//! control cycle what the program does: one step, with the same commands and the same values.
//!
//! The programs keep to what every peer can say well: equations, commands, IF … ENDIF, FOR … NEXT,
//! subroutines that call no other, and one endless loop. Anything else panics, as a build script may.
#![forbid(unsafe_code)]

pub mod c;
pub mod code;
mod flat;
pub mod generated;
mod infix;
pub mod lua;
pub mod rhai;
pub mod rune;
pub mod rust;
pub mod statig;
mod structure;

use tipc::program::Program;

/// Reads a program from its text.
///
/// # Panics
/// If it does not load.
pub fn load(name: &str, text: &str) -> Program {
    let loaded = tipc::load(name, text.as_bytes(), &tipc::Options::default());
    let found = &loaded.diagnostics;
    loaded.program.unwrap_or_else(|| panic!("{found:#?}"))
}
