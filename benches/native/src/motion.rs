//! The motions that are measured.

use tipc::program::Program;

/// A motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// The crawl of the example `walk`, for ever.
    WalkLoop,
    /// Generated, of 100 steps.
    Steps100,
    /// Generated, of 1000 steps.
    Steps1000,
    /// Generated, of 10,000 steps.
    Steps10000,
}

impl Motion {
    /// All of them.
    pub const ALL: [Motion; 4] = [
        Motion::WalkLoop,
        Motion::Steps100,
        Motion::Steps1000,
        Motion::Steps10000,
    ];

    /// Returns its name in tables and benchmarks.
    pub fn name(self) -> &'static str {
        match self {
            Motion::WalkLoop => "walk_loop",
            Motion::Steps100 => "steps100",
            Motion::Steps1000 => "steps1000",
            Motion::Steps10000 => "steps10000",
        }
    }

    /// The program, read anew.
    pub fn program(self) -> Program {
        peers::load(self.name(), self.text())
    }

    fn text(self) -> &'static str {
        match self {
            Motion::WalkLoop => include_str!(concat!(env!("OUT_DIR"), "/walk_loop.prg")),
            Motion::Steps100 => include_str!(concat!(env!("OUT_DIR"), "/steps100.prg")),
            Motion::Steps1000 => include_str!(concat!(env!("OUT_DIR"), "/steps1000.prg")),
            Motion::Steps10000 => include_str!(concat!(env!("OUT_DIR"), "/steps10000.prg")),
        }
    }
}
