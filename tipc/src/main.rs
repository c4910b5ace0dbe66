//! The command `tipc`.
fn main() {}
