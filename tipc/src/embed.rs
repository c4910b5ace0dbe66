//! From the bytes of a source to Rust items: the one road that macros and build scripts share.

use crate::code::Level;
#[cfg(feature = "robot-files")]
use crate::description::{self, Description};
use crate::emit::{self, emit};
use crate::load::{self, Loaded, load};
use crate::render::{self, Style};
use proc_macro2::TokenStream;

/// Compiles a source to the items that stand for it in a Rust crate.
///
/// # Errors
/// The source's errors, each with its place, its line and a caret, in the order of the source.
pub fn embed(
    name: &str,
    bytes: &[u8],
    options: &load::Options,
    spelling: &emit::Options,
) -> Result<TokenStream, Vec<String>> {
    let loaded = load(name, bytes, options);
    match &loaded.program {
        Some(program) => Ok(emit(program, spelling)),
        None => Err(errors(&loaded)),
    }
}

/// Reads the description of a robot.
///
/// # Errors
/// The description's errors, as those of a program.
#[cfg(feature = "robot-files")]
pub fn describe(name: &str, bytes: &[u8]) -> Result<Description, Vec<String>> {
    description::parse(name, bytes).map_err(|loaded| errors(&loaded))
}

fn errors(loaded: &Loaded) -> Vec<String> {
    let diagnostics = loaded.diagnostics.iter();
    diagnostics
        .filter(|diagnostic| diagnostic.level() == Level::Error)
        .map(|diagnostic| render::human(&loaded.source, diagnostic, Style::default()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const END_ONLY: &[u8] = b"3.1\nnothing to do\nEND\n";

    #[test]
    fn a_program_becomes_its_type() {
        let (options, spelling) = (load::Options::default(), emit::Options::default());
        let items = embed("motions/end_only.prg", END_ONLY, &options, &spelling).unwrap();
        assert!(items.to_string().contains("struct EndOnly"));
    }

    // clauses: 1.3
    #[test]
    fn an_error_comes_with_its_place() {
        let (options, spelling) = (load::Options::default(), emit::Options::default());
        let errors = embed("motions/old.prg", b"2.0\nold\nEND\n", &options, &spelling).unwrap_err();
        let [error] = errors.as_slice() else {
            panic!("one error, not {errors:?}");
        };
        assert!(error.contains("Wrong version number"), "{error}");
        assert!(error.contains("--> motions/old.prg:1:1"), "{error}");
    }
}
