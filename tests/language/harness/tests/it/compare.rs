//! An expected trace against an actual one.

use tip_harness::matches;

#[test]
fn dots_stand_for_any_records() {
    for (expected, fits) in [
        (&["a", "b", "c", "d"][..], true),
        (&["a", "...", "d"], true),
        (&["...", "d"], true),
        (&["a", "..."], true),
        (&["...", "b", "...", "d"], true),
        (&["...", "b", "c", "...", "d", "..."], true),
        (&["a", "b", "c", "d", "..."], true),
        (&["a", "b", "c"], false),
        (&["a", "b", "c", "d", "e"], false),
        (&["...", "c"], false),
        (&["b", "..."], false),
        (&["...", "c", "...", "b", "..."], false),
        (&["a", "b", "...", "b", "c", "d"], false),
    ] {
        let actual = ["a", "b", "c", "d"];
        assert_eq!(matches(expected, &actual).is_ok(), fits, "{expected:?}");
    }
}

#[test]
fn a_star_stands_for_any_cycle_but_for_nothing_else() {
    for (expected, actual, fits) in [
        (r#"{"cycle":*,"step":4}"#, r#"{"cycle":17,"step":4}"#, true),
        (r#"{"cycle":*,"step":4}"#, r#"{"cycle":17,"step":5}"#, false),
        (
            r#"{"end":"END","cycles":*}"#,
            r#"{"end":"END","cycles":9}"#,
            true,
        ),
        (
            r#"{"end":"END","cycles":*}"#,
            r#"{"end":"EXIT","cycles":9}"#,
            false,
        ),
        (r#"{"cycle":1,"step":*}"#, r#"{"cycle":1,"step":4}"#, false),
    ] {
        assert_eq!(
            matches(&[expected], &[actual]).is_ok(),
            fits,
            "{expected} {actual}"
        );
    }
}
