//! From an invocation to the items that replace it.

use crate::arguments::{self, Arguments, Misuse};
use crate::file;
use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use std::path::Path;
use tipc::codes::Code;
use tipc::diagnostic::Diagnostic;
use tipc::embed::embed;
use tipc::emit;
use tipc::syntax::Span;

/// `invoking` is the file that the invocation stands in, if the compiler knows one.
pub(crate) fn include_tip(input: TokenStream, invoking: Option<&Path>) -> TokenStream {
    match arguments::include_tip(input) {
        Ok(arguments) => include(&arguments, invoking),
        Err(misuse) => complaint(&misuse),
    }
}

pub(crate) fn tip(input: TokenStream) -> TokenStream {
    match arguments::tip(input) {
        Ok(arguments) => {
            let name = arguments.spelling.name_for("").to_string();
            compiled(&name, arguments.text.value.as_bytes(), &arguments)
        }
        Err(misuse) => complaint(&misuse),
    }
}

fn include(arguments: &Arguments, invoking: Option<&Path>) -> TokenStream {
    let Arguments { text, spelling, .. } = arguments;
    match file::find(&text.value, invoking) {
        Ok(file::Found { path, bytes }) => {
            let items = compiled(&text.value, &bytes, arguments);
            let path = path.display().to_string();
            // Naming the file here makes Cargo build again when it changes.
            quote! {
                #items
                const _: &[u8] = ::core::include_bytes!(#path);
            }
        }
        Err(reason) => {
            let missing = Diagnostic::new(Code::FileNotFound, Span::default(), "");
            let title = missing.about(&text.value).title();
            let code = Code::FileNotFound.id();
            let error = error(text.span, &format!("{code}: {title}: {reason}"));
            let skeleton = emit::skeleton(&text.value, spelling);
            quote!(#error #skeleton)
        }
    }
}

/// The program's items, or its errors and its skeleton.
fn compiled(name: &str, bytes: &[u8], arguments: &Arguments) -> TokenStream {
    let Arguments {
        text,
        load,
        spelling,
    } = arguments;
    match embed(name, bytes, load, spelling) {
        Ok(items) => items,
        Err(refusal) => {
            let errors = refusal
                .errors
                .iter()
                .map(|rendered| error(text.span, &without_level(rendered)));
            let skeleton = &refusal.skeleton;
            quote!(#(#errors)* #skeleton)
        }
    }
}

fn complaint(misuse: &Misuse) -> TokenStream {
    error(misuse.span, &misuse.message)
}

/// An error at `span`.
fn error(span: proc_macro2::Span, text: &str) -> TokenStream {
    let text = text.trim_end();
    quote_spanned!(span=> ::core::compile_error! { #text })
}

/// A rendered error without the word `error`, which the Rust compiler puts before it itself:
/// `error[E205]: TIP_ERR:…` is `E205: TIP_ERR:…`.
fn without_level(rendered: &str) -> String {
    match rendered.strip_prefix("error[") {
        Some(rest) => rest.replacen("]: ", ": ", 1),
        None => rendered.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WAVE: &str = "3.1\nwave\nEND\n";

    fn tokens(text: &str) -> TokenStream {
        text.parse().unwrap()
    }

    #[test]
    fn a_program_becomes_its_type() {
        let items = tip(tokens(&format!("pub Wave, \"{WAVE}\""))).to_string();
        assert!(items.contains("pub struct Wave"), "{items}");
        assert!(!items.contains("compile_error"), "{items}");
    }

    // clauses: 1.3
    #[test]
    fn an_error_comes_with_a_skeleton_and_without_the_word_error() {
        let items = tip(tokens("Wave, \"2.0\nwave\nEND\"")).to_string();
        assert!(
            items.contains("compile_error ! { \"E108: TIP_ERR:Wrong version number"),
            "{items}"
        );
        assert!(items.contains("struct Wave"), "{items}");
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

    #[test]
    fn misuse_is_an_error_alone() {
        let items = tip(tokens("Wave")).to_string();
        assert!(items.contains("compile_error"), "{items}");
        assert!(!items.contains("struct"), "{items}");
    }
}
