#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod action;
mod complete;
mod document;
mod fold;
mod format;
mod hint;
mod hover;
mod length;
pub mod message;
mod navigate;
mod offer;
mod outline;
mod paint;
mod rename;
mod signature;
mod targets;
mod template;
mod word;

pub use action::Action;
pub use document::Document;
pub use fold::{Fold, FoldKind};
pub use hint::Hint;
pub use hover::Hover;
pub use navigate::{Mention, MentionKind};
pub use offer::{Offer, OfferKind};
pub use outline::{Outline, OutlineKind};
pub use paint::{Paint, Painted};
pub use rename::Nameable;
pub use signature::{Signature, Signatures};
pub use template::template;
pub use tipc::diagnostic::Edit;
