//! A program by another name, inside a function, private.
fn main() {
    tip_macros::tip!(Wave, "3.1\nwave\nEND");
    let wave = Wave::default();
    assert_eq!(tip_runtime::program::Program::title(&wave), "wave");
}
