//! Generated code as a file that people read.

use super::{Options, emit, header};
use crate::program::Program;
use proc_macro2::TokenStream;

/// Returns the items of [`emit`](super::emit) as formatted source text under a header comment.
///
/// # Errors
/// They are not a Rust file; a visibility or runtime path that is none can cause it.
pub fn pretty(program: &Program, options: &Options) -> Result<String, syn::Error> {
    under(&header(program), emit(program, options))
}

/// Formats tokens as source text under a header.
pub(crate) fn under(header: &str, tokens: TokenStream) -> Result<String, syn::Error> {
    let text = prettyplease::unparse(&syn::parse2(tokens)?);
    Ok(format!("// {header}\n\n{text}"))
}
