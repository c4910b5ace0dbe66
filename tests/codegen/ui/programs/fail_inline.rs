//! The line is that of the program, not that of this file.
tip_macros::tip!(
    Wave,
    r#"3.1
wave
GOTO NOWHERE:
END"#
);

fn main() {
    let _ = Wave::default();
}
