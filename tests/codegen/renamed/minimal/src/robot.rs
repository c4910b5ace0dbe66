//! A robot from a description, without the feature of tip-macros that reads it.

use tip_macros::include_robot;

include_robot!("hexapod.toml");

fn main() {}
