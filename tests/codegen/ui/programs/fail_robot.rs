//! The robot lacks the command.
tip_macros::tip!(Pull, "3.1\npull\nTORQUE J11 10\nEND", robot = titan8);

fn main() {}
