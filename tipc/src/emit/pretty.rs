//! Generated code as a file that people read.

use super::header;
use crate::program::Program;
use proc_macro2::TokenStream;

/// The tokens of [`emit`](super::emit) as formatted source text under a header comment.
///
/// # Errors
/// The tokens are not a Rust file; a visibility or runtime path that is none can cause it.
pub fn pretty(program: &Program, tokens: TokenStream) -> Result<String, syn::Error> {
    under(&header(program), tokens)
}

/// Tokens as formatted source text under a header.
pub(crate) fn under(header: &str, tokens: TokenStream) -> Result<String, syn::Error> {
    let file = syn::parse2(tokens)?;
    Ok(format!("// {header}\n\n{}", prettyplease::unparse(&file)))
}
