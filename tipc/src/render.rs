//! Diagnostics as people and tools read them.

#[cfg(feature = "build")]
mod classical;
mod human;
#[cfg(feature = "build")]
mod json;
#[cfg(feature = "build")]
mod short;
mod style;
mod wrap;

#[cfg(feature = "build")]
pub use classical::classical;
pub use human::human;
#[cfg(feature = "build")]
pub use json::json;
#[cfg(feature = "build")]
pub use json::{push_member, push_number, push_string};
#[cfg(feature = "build")]
pub use short::short;
pub use style::Style;

#[cfg(test)]
mod tests;
