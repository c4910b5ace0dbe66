//! Diagnostics as people and tools read them.

#[cfg(feature = "tools")]
mod classical;
mod human;
#[cfg(feature = "tools")]
mod json;
#[cfg(any(feature = "build", feature = "tools"))]
mod short;
mod style;
mod wrap;

#[cfg(feature = "tools")]
pub use classical::classical;
pub use human::human;
#[cfg(feature = "tools")]
pub use json::{json, json_more};
#[cfg(feature = "tools")]
pub(crate) use json::{push_member, push_number, push_string};
#[cfg(any(feature = "build", feature = "tools"))]
pub use short::short;
#[cfg(feature = "tools")]
pub use short::short_more;
pub use style::Style;

#[cfg(test)]
mod tests;
