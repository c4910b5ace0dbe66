//! From the bytes of a source to Rust items: the one road that macros and build scripts share.

use crate::code::Level;
#[cfg(feature = "robot-files")]
use crate::description::{self, Description};
use crate::emit::{self, emit};
use crate::load::{self, Loaded, load};
use crate::message::Lang;
use crate::render::{self, Style};
use proc_macro2::TokenStream;

/// The environment variable that names the language of errors in a build. They are in English without it, whatever the
/// locale: a build's output is searched for, and sent to others.
pub const LANG: &str = "TIP_LANG";

/// Compiles a source to the items that stand for it in a Rust crate.
///
/// # Errors
/// The source's errors, each with its place, its line and a caret, in the order of the source.
pub fn embed(
    name: &str,
    bytes: &[u8],
    options: &load::Options,
    spelling: &emit::Options,
    lang: Lang,
) -> Result<TokenStream, Vec<String>> {
    let loaded = load(name, bytes, options);
    match &loaded.program {
        Some(program) => Ok(emit(program, spelling)),
        None => Err(errors(&loaded, lang)),
    }
}

/// Reads the description of a robot.
///
/// # Errors
/// The description's errors, as those of a program.
#[cfg(feature = "robot-files")]
pub fn describe(name: &str, bytes: &[u8], lang: Lang) -> Result<Description, Vec<String>> {
    description::parse(name, bytes).map_err(|loaded| errors(&loaded, lang))
}

fn errors(loaded: &Loaded, lang: Lang) -> Vec<String> {
    let style = Style::default().lang(lang);
    let diagnostics = loaded.diagnostics.iter();
    diagnostics
        .filter(|diagnostic| diagnostic.level() == Level::Error)
        .map(|diagnostic| render::human(&loaded.source, diagnostic, style))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const END_ONLY: &[u8] = b"3.1\nnothing to do\nEND\n";

    #[test]
    fn a_program_becomes_its_type() {
        let (options, spelling) = (load::Options::default(), emit::Options::default());
        let lang = Lang::English;
        let items = embed("motions/end_only.prg", END_ONLY, &options, &spelling, lang).unwrap();
        assert!(items.to_string().contains("struct EndOnly"));
    }

    // clauses: 1.3
    #[test]
    fn an_error_comes_with_its_place() {
        let (options, spelling) = (load::Options::default(), emit::Options::default());
        for (lang, reason) in [
            (Lang::English, "line 1 must name version 3.1"),
            (Lang::Japanese, "1行目"),
        ] {
            let old = b"2.0\nold\nEND\n";
            let errors = embed("motions/old.prg", old, &options, &spelling, lang).unwrap_err();
            let [error] = errors.as_slice() else {
                panic!("one error, not {errors:?}");
            };
            assert!(error.contains("Wrong version number"), "{error}");
            assert!(error.contains("--> motions/old.prg:1:1"), "{error}");
            assert!(error.contains(reason), "{error}");
        }
    }
}
