//! What the build script compiled.

pub use cases::case;
pub use random::random;

mod cases {
    include!(concat!(env!("OUT_DIR"), "/cases.rs"));
}

mod random {
    include!(concat!(env!("OUT_DIR"), "/random.rs"));
}
