//! Log points: what they say, when, and that they stop nothing.

use super::{Outcome, debugger, titan};
use tip_runtime::program::End;
use tip_sim::debug::{DebugError, Debugger, Move, Reason, When};

const LOOP: &str = "3.1
log
DEF_VAR N
DEF_POS P
P.X = 1 ; P.Y = 2 ; P.Z = 3
FOR N = 1 TO 4
  LAMP_ON 0
NEXT N
END
";

fn said(debugger: &mut Debugger) -> Vec<String> {
    let logged = debugger.logged().into_iter();
    logged.map(|(_, text)| text).collect()
}

#[test]
fn a_log_point_says_what_stands_in_braces_and_stops_nothing() -> Outcome {
    let mut debugger = debugger(LOOP, &titan())?;
    let text = "turn {N}: { n * 2 } {N > 2} {p} {P.Y} {} {";
    let placed = debugger.log_at(7, 1, &When::default(), text)?;
    assert_eq!(placed.line, 7);
    assert_eq!(debugger.go(Move::Continue).reason, Reason::Ended(End::End));
    let expected: Vec<String> = [(1, false), (2, false), (3, true), (4, true)]
        .map(|(n, late)| format!("turn {n}: {} {late} (1, 2, 3) 2 {{}} {{", n * 2))
        .to_vec();
    assert_eq!(said(&mut debugger), expected);
    assert_eq!(said(&mut debugger), [""; 0], "each is taken once");
    // Backwards it says and stops nothing; forwards it says it again.
    assert_eq!(debugger.go(Move::ReverseContinue).reason, Reason::Start);
    assert_eq!(said(&mut debugger), [""; 0]);
    debugger.go(Move::Continue);
    assert_eq!(said(&mut debugger), expected);
    assert!(debugger.remove_breakpoint(placed.id));
    debugger.go(Move::To(0));
    debugger.go(Move::Continue);
    assert_eq!(said(&mut debugger), [""; 0]);
    Ok(())
}

#[test]
fn conditions_and_hits_choose_what_is_said() -> Outcome {
    for (condition, hits, expected) in [
        (Some("N >= 3"), None, &["3", "4"][..]),
        (None, Some("% 2"), &["2", "4"]),
        (Some("N >= 2"), Some("2"), &["3"]),
    ] {
        let mut debugger = debugger(LOOP, &titan())?;
        let when = When { condition, hits };
        debugger.log_at(7, 1, &when, "{N}")?;
        debugger.go(Move::Continue);
        assert_eq!(said(&mut debugger), expected, "{when:?}");
    }
    Ok(())
}

#[test]
fn the_first_step_says_something_as_well_and_a_breakpoint_beside_it_stops() -> Outcome {
    let mut debugger = debugger(LOOP, &titan())?;
    debugger.log_at(5, 1, &When::default(), "begins at {P} with {N}")?;
    debugger.log_at(7, 1, &When::default(), "here")?;
    let stop = debugger.break_at_line(7, &When::default())?;
    assert_eq!(
        debugger.go(Move::Continue).reason,
        Reason::Breakpoint(stop.id)
    );
    assert_eq!(
        said(&mut debugger),
        [
            "begins at (unassigned, unassigned, unassigned) with unassigned",
            "here"
        ]
    );
    Ok(())
}

#[test]
fn what_cannot_be_calculated_is_refused_and_places_nothing() -> Outcome {
    let mut debugger = debugger(LOOP, &titan())?;
    for text in ["{HEIGHT}", "{N = 3}", "{N} and {1 +}"] {
        let refused = debugger.log_at(7, 1, &When::default(), text);
        assert!(
            matches!(refused, Err(DebugError::Wrong(_))),
            "{text}: {refused:?}"
        );
    }
    assert_eq!(debugger.breakpoint_lines().count(), 0);
    Ok(())
}
