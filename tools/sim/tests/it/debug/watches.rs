//! Stops at watches: the step or event that assigns a variable.

use super::{Outcome, debugger, titan};
use tip_runtime::program::End;
use tip_sim::debug::{By, DebugError, Debugger, Move, Reason, When};

/// A variable that a step, a key, a loop and the host assign.
const WATCHED: &str = "3.1
watched
DEF_VAR A, B
DEF_POS P
A = 1
FOR B = 1 TO 3
SLEEP 40
NEXT
P.X = A
P.Y = A
P.Z = A
KEY_IN A
SLEEP 200
END
";

#[test]
fn a_watch_finds_who_set_a_variable_last() -> Outcome {
    let mut debugger =
        debugger(WATCHED, &titan())?.with_events(&"40:key Q, 46:set A=9".parse()?)?;
    let id = debugger.watch("a")?;
    let by_line = |debugger: &Debugger| match debugger.stop().reason {
        Reason::Watch {
            id: it,
            by: By::Step(step),
        } if it == id => Some(debugger.program().steps()[step as usize].line),
        Reason::Watch {
            id: it,
            by: By::Event,
        } if it == id => Some(0),
        _ => None,
    };
    // Forwards the value is there already.
    debugger.go(Move::Continue);
    assert_eq!(
        (by_line(&debugger), debugger.value("A")?),
        (Some(5), Some(1.0))
    );
    debugger.go(Move::Continue);
    // KEY_IN assigns in the cycle of its key, not while it waits.
    assert_eq!((by_line(&debugger), debugger.now()), (Some(12), 41));
    assert_eq!(debugger.value("A")?, Some(f64::from(b'Q')));
    debugger.go(Move::Continue);
    assert_eq!((by_line(&debugger), debugger.now()), (Some(0), 46));
    assert_eq!(debugger.value("A")?, Some(9.0));
    assert_eq!(debugger.go(Move::Continue).reason, Reason::Ended(End::End));
    // Backwards it is still to come; what the host sets is there immediately.
    debugger.go(Move::ReverseContinue);
    assert_eq!((by_line(&debugger), debugger.now()), (Some(0), 46));
    debugger.go(Move::ReverseContinue);
    assert_eq!(
        (by_line(&debugger), debugger.now(), debugger.line()),
        (Some(12), 40, 12)
    );
    debugger.go(Move::ReverseContinue);
    assert_eq!((by_line(&debugger), debugger.line()), (Some(5), 5));
    assert_eq!(debugger.go(Move::ReverseContinue).reason, Reason::Start);
    assert!(debugger.unwatch(id) && !debugger.unwatch(id));
    Ok(())
}

#[test]
fn who_set_it_last_is_found_past_breakpoints_and_other_watches() -> Outcome {
    let mut debugger = debugger(WATCHED, &titan())?;
    let when = When::default();
    let sleep = debugger.break_at_line(7, &when)?.id;
    let turns = debugger.watch("B")?;
    let set_once = debugger.watch("A")?;
    while debugger.line() != 12 {
        debugger.go(Move::Step);
    }
    let stop = debugger.go(Move::SetBack(set_once));
    assert!(matches!(stop.reason, Reason::Watch { id, by: By::Step(_) } if id == set_once));
    assert_eq!(debugger.line(), 5);
    // Nothing set it before; a watch that is no more has nothing to find.
    assert_eq!(debugger.go(Move::SetBack(set_once)).reason, Reason::Start);
    assert!(debugger.unwatch(set_once) && debugger.unwatch(turns));
    assert_eq!(
        debugger.go(Move::Continue).reason,
        Reason::Breakpoint(sleep)
    );
    assert_eq!(debugger.go(Move::SetBack(set_once)).reason, Reason::Start);
    Ok(())
}

#[test]
fn loops_and_members_are_watched() -> Outcome {
    let mut debugger = debugger(WATCHED, &titan())?;
    debugger.watch("B")?;
    let mut values = Vec::new();
    for _ in 0..4 {
        debugger.go(Move::Continue);
        values.extend(debugger.value("B")?);
    }
    assert_eq!(values, [1.0, 2.0, 3.0, 4.0]);
    debugger.unwatch_all();
    debugger.watch("P")?;
    debugger.go(Move::Continue);
    assert_eq!(debugger.line(), 10);
    debugger.unwatch_all();
    debugger.watch("P.Z")?;
    debugger.go(Move::Continue);
    assert_eq!((debugger.line(), debugger.value("P.Z")?), (12, Some(1.0)));
    assert!(matches!(
        debugger.watch("C"),
        Err(DebugError::NoVariable(..))
    ));
    Ok(())
}
