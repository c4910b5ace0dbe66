//! From the bytes of a source to Rust items: the one road that macros and build scripts share.

use crate::codes::Level;
use crate::diagnostic::render_human;
use crate::emit::{self, emit, skeleton};
use crate::load::{self, load};
use proc_macro2::TokenStream;

/// Why a source did not become Rust, and what may stand in for it.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// Each error with its place, its line and a caret, in the order of the source.
    pub errors: Vec<String>,
    /// A type of the program's name, so that nothing but the errors is reported.
    pub skeleton: TokenStream,
}

/// Compiles a source to the items that stand for it in a Rust crate.
///
/// # Errors
/// The source's errors, rendered for people.
pub fn embed(
    name: &str,
    bytes: &[u8],
    options: &load::Options,
    spelling: &emit::Options,
) -> Result<TokenStream, Refusal> {
    let loaded = load(name, bytes, options);
    match &loaded.program {
        Some(program) => Ok(emit(program, spelling)),
        None => Err(Refusal {
            errors: loaded
                .diagnostics
                .iter()
                .filter(|diagnostic| diagnostic.level() == Level::Error)
                .map(|diagnostic| render_human(&loaded.source, diagnostic, false))
                .collect(),
            skeleton: skeleton(name, spelling),
        }),
    }
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
    fn an_error_comes_with_its_place_and_a_skeleton() {
        let (options, spelling) = (load::Options::default(), emit::Options::default());
        let refusal =
            embed("motions/old.prg", b"2.0\nold\nEND\n", &options, &spelling).unwrap_err();
        let [error] = refusal.errors.as_slice() else {
            panic!("one error, not {:?}", refusal.errors);
        };
        assert!(error.contains("Wrong version number"), "{error}");
        assert!(error.contains("--> motions/old.prg:1:1"), "{error}");
        assert!(refusal.skeleton.to_string().contains("struct Old"));
    }
}
