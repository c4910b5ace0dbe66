//! Paths that a macro of another crate passes on are looked up next to this file; both crates have a program of that name.
use tip_runtime::program::Program;

tip_tests_ui::motion!("passed_on.prg" as Passed on "hexapod.toml" as SIX_LEGS);
tip_tests_ui::own_motion!(Own);

fn main() {
    assert_eq!(Passed::new().title(), "of the crate that invokes it");
    assert_eq!(Passed::new().signature(), SIX_LEGS.signature());
    assert_eq!(Inline::new().signature(), SIX_LEGS.signature());
    assert_eq!(Own::new().title(), "of the crate with the macro");
}
