#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod block;
mod code_actions;
mod completion;
pub mod dap;
mod document;
mod hover;
mod inlay_hints;
pub mod lsp;
pub mod message;
mod outline;
mod references;
mod semantic_tokens;
mod signature;
pub mod transport;
mod word;

pub use code_actions::CodeAction;
pub use completion::{CompletionItem, CompletionKind, snippet};
pub use document::Document;

pub use hover::Hover;
pub use inlay_hints::InlayHint;
pub use outline::{Fold, FoldKind, Outline};
pub use references::{Reference, ReferenceKind, RenameTarget};
pub use semantic_tokens::{SemanticToken, TokenClass};
pub use signature::{Signature, Signatures};
pub use tipc::diagnostic::Edit;
pub use tipc::symbols::DefinitionKind as OutlineKind;
