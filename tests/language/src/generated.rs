//! Programs that the build script compiled.

pub use cases::case;

mod cases {
    include!(concat!(env!("OUT_DIR"), "/cases.rs"));
}
