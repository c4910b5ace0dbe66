//! Threads of edition 3.2: each has a place, calls and steps of its own, and they move together.

use super::{Outcome, debugger, titan};
use tip_runtime::fault::Fault;
use tip_sim::Event;
use tip_sim::debug::{By, Debugger, Move, Reason, Value, When};

/// A thread that counts in a routine. Steps are on lines of their own, from line 4 on.
///
/// Main program: line 6 in cycle 2, then 7, 8 and 9 in turn from cycle 3 on. Thread: 11 in cycle 3, 12, 13, 17, 18 in
/// cycle 7, 19, 14 in cycles 9 and 10, 15, 12 in cycle 12, 13, 17, 18 in cycle 15.
const TWO: &str = "3.2
two
DEF_VAR A, B
A = 0
B = 0
START_THREAD SIDE:
L:
A += 1
IF A < 20 GOTO L:
EXIT
THREAD SIDE:
AGAIN:
CALL ADD:
SLEEP 40
GOTO AGAIN:
THREADEND
SUBROUTINE ADD:
B += 1
SUBEND
END
";

fn frames(debugger: &Debugger, thread: u8) -> Vec<(Option<String>, u32)> {
    let frames = debugger.frames(thread).into_iter();
    frames.map(|frame| (frame.name, frame.line)).collect()
}

/// Where a movement ends: the cycle that comes next, the thread and its line.
fn after(debugger: &mut Debugger, movement: Move) -> (u64, u8, u32) {
    let stop = debugger.go(movement);
    (stop.at, debugger.thread(), debugger.line())
}

#[test]
fn a_breakpoint_in_a_thread_stops_all_there_in_both_directions() -> Outcome {
    let mut debugger = debugger(TWO, &titan())?;
    assert_eq!(debugger.threads(), [0]);
    let id = debugger.break_at_line(18, &When::default())?.id;
    let stop = debugger.go(Move::Continue);
    assert_eq!(
        (stop.reason, stop.at, stop.thread),
        (Reason::Breakpoint(id), 7, 1)
    );
    assert_eq!((debugger.threads(), debugger.thread()), (vec![0, 1], 1));
    assert_eq!(debugger.thread_name(1), Some("SIDE"));
    assert_eq!(frames(&debugger, 1), [(Some("ADD".into()), 18), (None, 13)]);
    assert_eq!(frames(&debugger, 0), [(None, 8)]);
    assert_eq!(after(&mut debugger, Move::Continue), (15, 1, 18));
    assert_eq!(debugger.value("B")?, Some(1.0));
    debugger.select(0);
    assert_eq!(after(&mut debugger, Move::ReverseContinue), (7, 1, 18));
    assert_eq!(after(&mut debugger, Move::ReverseContinue), (0, 0, 4));
    Ok(())
}

#[test]
fn steps_are_those_of_the_selected_thread() -> Outcome {
    let mut debugger = debugger(TWO, &titan())?;
    debugger.break_at_line(18, &When::default())?;
    debugger.go(Move::Continue);
    debugger.go(Move::Out);
    assert_eq!((debugger.now(), debugger.line()), (9, 14));
    assert_eq!(after(&mut debugger, Move::Over), (11, 1, 15));
    debugger.select(0);
    assert_eq!(debugger.line(), 9);
    assert_eq!(after(&mut debugger, Move::Over), (12, 0, 7));
    debugger.select(1);
    assert_eq!(after(&mut debugger, Move::OverBack), (11, 1, 15));
    assert_eq!(after(&mut debugger, Move::OverBack), (9, 1, 14));
    debugger.unwatch_all();
    assert_eq!(after(&mut debugger, Move::StepBack), (8, 1, 19));
    assert_eq!(
        after(&mut debugger, Move::OutBack),
        (7, 1, 18),
        "the breakpoint is on the way"
    );
    assert_eq!(after(&mut debugger, Move::OutBack), (5, 1, 13));
    // Before its start the thread is not there.
    assert_eq!(after(&mut debugger, Move::To(2)), (2, 0, 6));
    Ok(())
}

#[test]
fn a_watch_tells_which_thread_assigned() -> Outcome {
    let mut debugger = debugger(TWO, &titan())?;
    let id = debugger.watch("B")?;
    let assigned = |debugger: &mut Debugger, movement| {
        let stop = debugger.go(movement);
        match stop.reason {
            Reason::Watch {
                id: watch,
                by: By::Step(step),
            } if watch == id => (stop.at, stop.thread, debugger.run().program().line(step)),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(assigned(&mut debugger, Move::Continue), (2, 0, 5));
    assert_eq!(assigned(&mut debugger, Move::Continue), (8, 1, 18));
    assert_eq!(assigned(&mut debugger, Move::ReverseContinue), (7, 1, 18));
    assert_eq!(assigned(&mut debugger, Move::ReverseContinue), (1, 0, 5));
    Ok(())
}

#[test]
fn a_fault_of_a_thread_is_shown_in_it() -> Outcome {
    let faulty = TWO.replace("B += 1", "B /= B");
    let mut debugger = debugger(&faulty, &titan())?;
    let stop = debugger.go(Move::Continue);
    let Reason::Fault(emergency) = stop.reason else {
        panic!("{stop:?}");
    };
    assert_eq!(
        (emergency.fault, stop.thread, debugger.line()),
        (Fault::Domain, 1, 18)
    );
    Ok(())
}

#[test]
fn a_step_inside_a_turn_is_reached_with_the_end_of_its_cycle() -> Outcome {
    let text = "3.2\nfast\nDEF_VAR A\nTIP_SPEED_UP 4\nA = 1\nA = 2\nA = 3\nSLEEP 20\nA = 4\nEND\n";
    let mut debugger = debugger(text, &titan())?;
    let inside = debugger.break_at_line(6, &When::default())?.id;
    let first = debugger.break_at_line(5, &When::default())?.id;
    for (movement, id, at, line) in [
        (Move::Continue, first, 1, 5),
        (Move::Continue, inside, 2, 9),
        (Move::To(3), 0, 3, 9),
        (Move::ReverseContinue, inside, 2, 9),
        (Move::ReverseContinue, first, 1, 5),
    ] {
        let stop = debugger.go(movement);
        if id != 0 {
            assert_eq!(
                (stop.reason, stop.at, debugger.line()),
                (Reason::Breakpoint(id), at, line)
            );
        }
    }
    Ok(())
}

/// START_TIMER runs in cycle 1, so that the timer shows 20 in cycle 2 and 40 in cycle 3.
const TIMED: &str = "3.2
timed
DEFINE FAR 40
DEF_VAR N
N = FAR
START_TIMER 2
REM
REM
N += 1
END
";

// clauses: 13.1 13.2 14.1
#[test]
fn questions_name_constants_timers_and_readings() -> Outcome {
    let mut debugger = debugger(TIMED, &titan())?;
    let late = When {
        condition: Some("@TIMER2 == FAR"),
        ..When::default()
    };
    debugger.break_at_line(7, &late)?;
    let id = debugger.break_at_line(8, &late)?.id;
    let stop = debugger.go(Move::Continue);
    assert_eq!((stop.reason, stop.at), (Reason::Breakpoint(id), 3));
    assert_eq!(debugger.evaluate("far + @timer2")?, Value::Number(80.0));
    assert!(matches!(
        debugger.evaluate("@AGL_J13 > @POS_F1.Z")?,
        Value::Truth(true)
    ));
    let set = |value| Some(Event::Set("N".to_owned(), value));
    assert_eq!(debugger.assignment("n = -FAR"), set(-40.0));
    assert_eq!(debugger.assignment("N=@TIMER2 / 4"), set(10.0));
    assert_eq!(debugger.assignment("N = 7"), set(7.0));
    for other in ["N == 7", "N >= 7", "N = ", "N = NEAR", "N + 1 = 2"] {
        assert_eq!(debugger.assignment(other), None, "{other}");
    }
    Ok(())
}
