//! Diagnostics as people and tools read them.

mod human;
mod json;
mod short;

pub use human::human;
pub use json::json;
#[cfg(feature = "tools")]
pub(crate) use json::{push_member, push_number, push_string};
pub use short::short;

#[cfg(test)]
mod tests;
