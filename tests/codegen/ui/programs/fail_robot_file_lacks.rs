//! The robot that a file describes lacks a leg and forces.
tip_macros::tip!(
    Reach,
    "3.1\nreach\nPTP F7 0 0 0\nTORQUE J11 1\nEND",
    robot = "hexapod.toml"
);

fn main() {}
