//! What findings say, as data: a reason, a help or a label is a row of a table and the arguments of its text.
//!
//! Each room that finds something has a table, and [`phrase`] one for each part of a sentence that
//! varies. Nothing else spells a sentence, so that a text is changed in one place, and another language is a column.

#[macro_use]
mod table;

mod parsing;
pub mod phrase;

pub use parsing::Parsing;

tables! {
    Parsing,
}
