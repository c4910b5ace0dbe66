#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

mod arguments;
mod expand;
mod file;
mod literal;

use proc_macro::{Span, TokenStream};

/// Compiles a motion program from a file:
/// `include_tip!([attributes] [visibility] "path" [as Name] [, option = value]…)`.
///
/// The path is looked up next to the file that it is written in, also if another macro passes it on, and from the
/// folder of `Cargo.toml`; one file only may answer it. The type is named after the file, in UpperCamelCase, unless
/// `as` names it. Attributes and documentation comments before the path are those of the type. When the file changes,
/// the crate is built again.
#[proc_macro]
pub fn include_tip(input: TokenStream) -> TokenStream {
    let invoking = Span::call_site().local_file();
    expand::include_tip(input.into(), invoking.as_deref()).into()
}

/// Compiles a motion program from a string:
/// `tip!([attributes] [visibility] Name, r#"…"# [, option = value]…)`.
///
/// Line 1 of the program begins right after the opening quote.
#[proc_macro]
pub fn tip(input: TokenStream) -> TokenStream {
    let invoking = Span::call_site().local_file();
    expand::tip(input.into(), invoking.as_deref()).into()
}

/// Compiles the description of a robot to a constant that holds its model:
/// `include_robot!([attributes] [visibility] "path" [as NAME] [, runtime = path])`.
///
/// The path is looked up as [`include_tip!`] does. The constant is named after the file, in capitals, unless
/// `as` names it; its type is `tip_runtime::model::Model<L, J>`, for L legs of J joints. Needs the feature
/// `robot-files`.
#[proc_macro]
pub fn include_robot(input: TokenStream) -> TokenStream {
    let invoking = Span::call_site().local_file();
    expand::include_robot(input.into(), invoking.as_deref()).into()
}
