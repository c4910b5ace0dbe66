//! Warnings about programs that load.

use super::{check_certain, check_kept};

// clauses: 7.35
#[test]
fn values_as_other_languages_show_them() {
    let shown = |text: &str| format!("DEF_VAR N M\nAD_IN VR1 N\nAD_IN VR2 M\nMESSAGE {text}");
    for (wrong, right) in [
        ("$N", "%N%"),
        ("the knob: {n} V", "the knob: %N% V"),
        ("%N", "%N%"),
        ("$N and {M}", "%N% and %M%"),
        ("歩数 $N, %M%", "歩数 %N%, %M%"),
    ] {
        let other = "\nSLEEP M";
        check_certain(&(shown(wrong) + other), &(shown(right) + other));
    }
    // Nobody knows which variable is meant, and other names may be texts.
    check_kept(&(shown("%d") + "\nMESSAGE %N% %M%"));
    check_kept(&(shown("$X {Y}") + "\nMESSAGE %N% %M%"));
}

/// W123, W126: what else was meant is the author's to say.
#[test]
fn waits_and_native_commands_stay() {
    check_kept("SPECIAL 30");
    check_kept("PTP F1 R 0 R 0 R 10\nWAIT_INPOS F2");
}
