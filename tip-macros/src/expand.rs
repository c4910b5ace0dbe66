//! Expansion of an invocation to the items that replace it.

use crate::arguments::{self, Arguments, Misuse};
use crate::file::{self, Fault, Found};
use crate::literal::Text;
use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use std::env;
use std::path::Path;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::embed;
use tipc::emit;
use tipc::message::Lang;
use tipc::published;
use tipc::source::Span;
use tipc::{Loaded, render};

/// `invoking` is the file that holds the invocation, if the compiler knows one.
pub(crate) fn include_tip(input: TokenStream, invoking: Option<&Path>) -> TokenStream {
    match arguments::include_tip(input) {
        Ok(arguments) => {
            let Arguments {
                text,
                load,
                emit_options,
                ..
            } = &arguments;
            let compile = |bytes: &[u8]| compiled(&text.value, bytes, &arguments, invoking);
            included(text, invoking, compile).unwrap_or_else(|failure| {
                failure.with_skeleton(emit::skeleton(&text.value, load.robot, emit_options))
            })
        }
        Err(misuse) => complaint(&misuse),
    }
}

pub(crate) fn tip(input: TokenStream, invoking: Option<&Path>) -> TokenStream {
    match arguments::tip(input) {
        Ok(arguments) => {
            let Arguments {
                text,
                load,
                emit_options,
                ..
            } = &arguments;
            let name = emit_options.name_for("").to_string();
            compiled(&name, text.value.as_bytes(), &arguments, invoking).unwrap_or_else(|failure| {
                failure.with_skeleton(emit::skeleton(&name, load.robot, emit_options))
            })
        }
        Err(misuse) => complaint(&misuse),
    }
}

#[cfg(feature = "robot-files")]
pub(crate) fn include_robot(input: TokenStream, invoking: Option<&Path>) -> TokenStream {
    use tipc::description::{self, skeleton};
    match arguments::include_robot(input) {
        Ok((text, emit_options)) => {
            let compile = |bytes: &[u8]| {
                let described = description::parse(&text.value, bytes);
                described
                    .map(|description| description.to_rust(&emit_options))
                    .map_err(|loaded| Failure::of(&text, &loaded))
            };
            on_description(&text, invoking, compile).unwrap_or_else(|failure| {
                failure.with_skeleton(skeleton(&text.value, &emit_options))
            })
        }
        Err(misuse) => complaint(&misuse),
    }
}

/// Error where a description is named and the feature that reads it is not enabled.
#[cfg(not(feature = "robot-files"))]
const NO_ROBOT_FILES: &str = "robots from description files need the feature `robot-files` of tip-macros: \
                              `tip-macros = { version = \"…\", features = [\"robot-files\"] }`";

/// Reports the missing feature: the macro exists without it as well, so that a crate that uses it learns what is
/// missing.
#[cfg(not(feature = "robot-files"))]
pub(crate) fn include_robot(_: TokenStream, _: Option<&Path>) -> TokenStream {
    error(proc_macro2::Span::call_site(), NO_ROBOT_FILES)
}

/// Errors, and the literal that they belong to.
struct Failure {
    span: proc_macro2::Span,
    errors: Vec<String>,
}

impl Failure {
    fn at(literal: &Text, error: impl Into<String>) -> Self {
        Failure {
            span: literal.span,
            errors: vec![error.into()],
        }
    }

    /// Returns the errors of a file that the literal names.
    fn of(literal: &Text, loaded: &Loaded) -> Self {
        let render = |error| render::plain(&loaded.source, error, lang());
        Failure {
            span: literal.span,
            errors: loaded.errors().map(render).collect(),
        }
    }

    /// Returns the errors, and what replaces the item that could not be made.
    fn with_skeleton(&self, skeleton: TokenStream) -> TokenStream {
        let errors = self.errors.iter();
        let errors = errors.map(|text| error(self.span, text));
        quote!(#(#errors)* #skeleton)
    }
}

/// Expands a description: a file, or that of a published robot.
fn on_description(
    name: &Text,
    invoking: Option<&Path>,
    compile: impl FnOnce(&[u8]) -> Result<TokenStream, Failure>,
) -> Result<TokenStream, Failure> {
    match published::find(&name.value) {
        Some(robot) => compile(robot.text.as_bytes()),
        None => included(name, invoking, compile),
    }
}

/// Expands a program file.
fn included(
    path: &Text,
    invoking: Option<&Path>,
    compile: impl FnOnce(&[u8]) -> Result<TokenStream, Failure>,
) -> Result<TokenStream, Failure> {
    let Found { path, bytes } = find(path, invoking)?;
    let items = compile(&bytes)?;
    let path = path.display().to_string();
    // Naming the file here makes Cargo build again when it changes.
    Ok(quote! {
        #items
        const _: &[u8] = ::core::include_bytes!(#path);
    })
}

fn find(path: &Text, invoking: Option<&Path>) -> Result<Found, Failure> {
    file::find(path, invoking).map_err(|fault| {
        let error = match fault {
            Fault::Two(reason) => reason.in_lang(lang()).to_string(),
            Fault::NotRead(reason) => {
                let missing = Diagnostic::new(Code::FileNotFound, Span::default(), reason);
                let missing = missing.about(&path.value);
                let (code, title) = (missing.code.id(), missing.title());
                format!("{code}: {title}: {}", missing.reason)
            }
        };
        Failure::at(path, error)
    })
}

/// Returns the items of a program, checked for the robot that its options name.
fn compiled(
    name: &str,
    bytes: &[u8],
    arguments: &Arguments,
    invoking: Option<&Path>,
) -> Result<TokenStream, Failure> {
    let compile = |load: &tipc::Options| {
        let loaded = tipc::load(name, bytes, load);
        match &loaded.program {
            Some(program) => Ok(emit::emit(program, &arguments.emit_options)),
            None => Err(Failure::of(&arguments.text, &loaded)),
        }
    };
    match &arguments.robot_file {
        None => compile(&arguments.load),
        Some(path) => on_description(path, invoking, |description| {
            compile(&tipc::Options {
                robot: described(path, description)?,
                ..arguments.load
            })
        }),
    }
}

#[cfg(feature = "robot-files")]
fn described(path: &Text, description: &[u8]) -> Result<tipc::Robot, Failure> {
    match tipc::description::parse(&path.value, description) {
        Ok(description) => Ok(description.robot()),
        Err(loaded) => Err(Failure::of(path, &loaded)),
    }
}

#[cfg(not(feature = "robot-files"))]
fn described(path: &Text, _: &[u8]) -> Result<tipc::Robot, Failure> {
    Err(Failure::at(path, NO_ROBOT_FILES))
}

/// Returns the language that errors of programs are in.
fn lang() -> Lang {
    let asked = env::var(embed::LANG).unwrap_or_default();
    Lang::of(&asked)
}

fn complaint(misuse: &Misuse) -> TokenStream {
    error(misuse.span, &misuse.message)
}

/// Returns an error at `span`.
fn error(span: proc_macro2::Span, text: &str) -> TokenStream {
    let text = text.trim_end();
    quote_spanned!(span=> ::core::compile_error! { #text })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::process::Command;

    const WAVE: &str = "3.1\nwave\nEND\n";

    fn tokens(text: &str) -> TokenStream {
        text.parse().unwrap()
    }

    #[test]
    fn a_program_becomes_its_type() {
        let items = tip(tokens(&format!("pub Wave, \"{WAVE}\"")), None).to_string();
        assert!(items.contains("pub struct Wave"), "{items}");
        assert!(!items.contains("compile_error"), "{items}");
    }

    /// Returns the tokens as a formatted file.
    fn formatted(tokens: TokenStream) -> String {
        prettyplease::unparse(&syn::parse2(tokens).unwrap())
    }

    #[test]
    #[expect(clippy::disallowed_methods, reason = "goldens are files")]
    fn macro_and_build_script_make_the_same_tokens() {
        let goldens = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/codegen/golden");
        for name in ["counting", "branches", "motion"] {
            let path = format!("{name}.prg");
            let tokens = include_tip(quote!(pub #path), Some(&goldens.join("invoking.rs")));
            let generated = std::fs::read_to_string(goldens.join(format!("{name}.rs"))).unwrap();
            let generated = formatted(generated.parse().unwrap());
            let formatted = formatted(tokens);
            let (items, tracking) = formatted.split_at(generated.len().min(formatted.len()));
            assert!(items == generated, "{name}:\n{formatted}");
            assert!(
                tracking.starts_with("const _: &[u8] = ::core::include_bytes!("),
                "{tracking}"
            );
        }
    }

    // clauses: 1.3
    #[test]
    fn an_error_comes_with_a_skeleton_and_without_the_word_error() {
        let items = tip(tokens("Wave, \"2.0\nwave\nEND\""), None).to_string();
        assert!(
            items.contains(
                "compile_error ! { \"E108: line 1 must name version 3.1 or 3.2 of the language"
            ),
            "{items}"
        );
        assert!(items.contains("struct Wave"), "{items}");
    }

    /// Environment variable of a test that runs in a process of its own, for which the language is set.
    const ASKED: &str = "TIP_LANG_IS_SET_BY_A_TEST";

    #[test]
    fn errors_are_in_the_language_that_the_environment_asks_for() {
        if env::var_os(ASKED).is_none() {
            let name = "expand::tests::errors_are_in_the_language_that_the_environment_asks_for";
            let mut test = Command::new(env::current_exe().unwrap());
            test.args([name, "--exact"])
                .env(ASKED, "")
                .env(embed::LANG, "ja");
            assert!(test.output().unwrap().status.success());
            return;
        }
        let items = tip(tokens("Wave, \"2.0\nwave\nEND\""), None).to_string();
        assert!(items.contains("E108: 1行目"), "{items}");
    }

    #[test]
    fn a_missing_file_is_an_error_with_a_skeleton() {
        let items = include_tip(tokens("\"gone.prg\""), None).to_string();
        assert!(
            items.contains("E103: TIP_ERR:File not found(gone.prg) (PreprocessError): looked for"),
            "{items}"
        );
        assert!(items.contains("struct Gone"), "{items}");
    }

    /// Seen from the folder of this crate, and of every other in the workspace.
    const HEXAPOD: &str = "../tipc/tests/robots/hexapod.toml";

    #[test]
    #[cfg(feature = "robot-files")]
    fn a_program_for_a_described_robot_tracks_both() {
        let items = tip(
            tokens(&format!("Wave, \"{WAVE}\", robot = \"{HEXAPOD}\"")),
            None,
        )
        .to_string();
        assert!(items.contains("robot : \"hexapod\""), "{items}");
        assert!(items.contains("include_bytes ! (\""), "{items}");
        assert!(!items.contains("compile_error"), "{items}");
    }

    #[test]
    #[cfg(not(feature = "robot-files"))]
    fn a_description_without_its_feature_is_refused() {
        let items = tip(
            tokens(&format!("Wave, \"{WAVE}\", robot = \"{HEXAPOD}\"")),
            None,
        )
        .to_string();
        assert!(items.contains("compile_error"), "{items}");
        assert!(items.contains("the feature `robot-files`"), "{items}");
        assert!(items.contains("struct Wave"), "{items}");
    }

    #[test]
    #[cfg(not(feature = "robot-files"))]
    fn a_robot_without_its_feature_is_refused_with_a_hint() {
        let items = include_robot(tokens(&format!("\"{HEXAPOD}\"")), None).to_string();
        assert!(items.contains("compile_error"), "{items}");
        assert!(items.contains("the feature `robot-files`"), "{items}");
    }

    #[test]
    fn an_option_given_twice_is_refused_alone() {
        for (input, option) in [
            ("robot = hand, robot = hand", "robot"),
            ("runtime = ::a, encoding = utf8, runtime = ::b,", "runtime"),
        ] {
            let items = tip(tokens(&format!("Wave, \"{WAVE}\", {input}")), None).to_string();
            assert!(
                items.contains(&format!("`{option}` is given twice")),
                "{items}"
            );
            assert!(!items.contains("struct"), "{items}");
        }
    }

    #[test]
    #[cfg(feature = "robot-files")]
    fn a_description_becomes_a_constant() {
        let items = include_robot(tokens(&format!("pub \"{HEXAPOD}\" as SIX")), None).to_string();
        let constant = "pub const SIX : :: tip_runtime :: model :: Model < 6 , 3 >";
        assert!(items.contains(constant), "{items}");
        assert!(items.contains("include_bytes"), "{items}");
        let named = include_robot(tokens(&format!("\"{HEXAPOD}\"")), None).to_string();
        assert!(named.contains("const HEXAPOD :"), "{named}");
    }

    #[test]
    #[cfg(feature = "robot-files")]
    fn a_description_that_is_not_there_is_an_error_with_a_stand_in() {
        let robot = include_robot(tokens("\"gone.toml\""), None).to_string();
        assert!(
            robot.contains("E103: TIP_ERR:File not found(gone.toml)"),
            "{robot}"
        );
        assert!(robot.contains("const GONE :"), "{robot}");
        let program = tip(
            tokens(&format!("Wave, \"{WAVE}\", robot = \"gone.toml\"")),
            None,
        )
        .to_string();
        assert!(program.contains("File not found(gone.toml)"), "{program}");
        assert!(program.contains("struct Wave"), "{program}");
    }

    #[test]
    fn misuse_is_an_error_alone() {
        let items = tip(tokens("Wave"), None).to_string();
        assert!(items.contains("compile_error"), "{items}");
        assert!(!items.contains("struct"), "{items}");
    }
}
