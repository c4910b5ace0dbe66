//! Compile errors of wrong macro calls and of programs with errors.
#![allow(clippy::disallowed_macros, reason = "a skipped test says why")]

/// The compiler whose messages the expectations hold.
const TOOLCHAIN: &str = "rustc 1.95.";

#[test]
fn errors_are_shown_where_they_belong() {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = std::process::Command::new(compiler)
        .arg("--version")
        .output()
        .unwrap();
    if !version.stdout.starts_with(TOOLCHAIN.as_bytes()) {
        eprintln!("skipped: the expectations are those of {TOOLCHAIN}*");
        return;
    }
    let cases = trybuild::TestCases::new();
    cases.pass("programs/pass_*.rs");
    cases.compile_fail("programs/fail_*.rs");
}
