//! A program by another name, inside a function, private, with attributes that are those of its type.
#![deny(dead_code, missing_docs)]

/// A module whose items need documentation.
pub mod waves {
    tip_macros::tip!(
        /// Waves.
        pub Documented, "3.1\nwave\nEND");
}

fn main() {
    tip_macros::tip!(#[allow(dead_code)] Unused, "3.1\nwave\nEND");
    tip_macros::tip!(Wave, "3.1\nwave\nEND");
    let wave = Wave::default();
    assert_eq!(tip_runtime::program::Program::title(&wave), "wave");
}
