//! Diagnostics as people and tools read them.

mod classical;
mod human;
mod json;
mod short;
mod style;
mod wrap;

pub use classical::classical;
pub use human::human;
pub use json::json;
#[cfg(feature = "tools")]
pub(crate) use json::{push_member, push_number, push_string};
pub use short::short;
pub use style::Style;

#[cfg(test)]
mod tests;
