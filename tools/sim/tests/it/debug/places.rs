//! The places where movements and breakpoints stop.

use super::{Outcome, debugger, titan};
use tip_runtime::fault::Fault;
use tip_runtime::program::End;
use tip_sim::Robot;
use tip_sim::debug::{DebugError, Debugger, Discard, Move, Reason, Value, When};

/// A routine in a routine, called from a loop. Each step is on a line of its own, from line 4 on.
const CALLS: &str = "3.1
calls
DEF_VAR N
N = 0
L:
GOSUB OUTER:
IF N < 20 GOTO L:
EXIT
OUTER:
GOSUB INNER:
SLEEP 100
RETURN
INNER:
N += 1
RETURN
END
";

fn lines(debugger: &mut Debugger, moves: &[Move]) -> Vec<u32> {
    let line = |movement: &Move| {
        debugger.go(*movement);
        debugger.line()
    };
    moves.iter().map(line).collect()
}

fn names(debugger: &Debugger) -> Vec<(String, u32)> {
    let frames = debugger.frames(0).into_iter();
    frames
        .map(|frame| (frame.name.unwrap_or_default(), frame.line))
        .collect()
}

#[test]
fn steps_go_into_over_and_out_of_routines_in_both_directions() -> Outcome {
    use Move::*;
    let mut debugger = debugger(CALLS, &titan())?;
    assert_eq!(debugger.line(), 4);
    // Labels are steps.
    assert_eq!(
        lines(&mut debugger, &[Step, Step, Step, Step, Step, Step]),
        [5, 6, 9, 10, 13, 14]
    );
    let innermost = [
        ("INNER".into(), 14),
        ("OUTER".into(), 10),
        (String::new(), 6),
    ];
    assert_eq!(names(&debugger), innermost);
    assert_eq!(lines(&mut debugger, &[Out, Over, Over]), [11, 12, 7]);
    assert_eq!(names(&debugger), [(String::new(), 7)]);
    // Back over the call, forward over it, back into it.
    assert_eq!(
        lines(&mut debugger, &[OverBack, Over, StepBack]),
        [6, 7, 12]
    );
    assert_eq!(lines(&mut debugger, &[OverBack, OverBack]), [11, 10]);
    assert_eq!(
        lines(&mut debugger, &[Out, StepBack, OutBack, OutBack]),
        [7, 12, 6, 4]
    );
    assert_eq!(debugger.stop().reason, Reason::Start);
    Ok(())
}

#[test]
fn a_step_that_waits_is_one_step_of_several_cycles() -> Outcome {
    let mut debugger = debugger(CALLS, &titan())?;
    debugger.go(Move::Line(11));
    let begin = debugger.now();
    debugger.go(Move::Step);
    // 100 ms at 20 ms a cycle.
    assert_eq!((debugger.line(), debugger.now() - begin), (12, 5));
    debugger.go(Move::CycleBack);
    assert_eq!((debugger.line(), debugger.now() - begin), (11, 4));
    // From the middle of a step to its beginning, then to the step before.
    debugger.go(Move::StepBack);
    assert_eq!((debugger.line(), debugger.now()), (11, begin));
    debugger.go(Move::StepBack);
    assert_eq!(debugger.line(), 15);
    Ok(())
}

#[test]
fn a_line_breakpoint_stops_at_each_pass_in_both_directions() -> Outcome {
    let mut debugger = debugger(CALLS, &titan())?;
    // Line 3 has no step; the next one that has one is line 4.
    let early = debugger.break_at_line(3, &When::default())?;
    assert_eq!(early.line, 4);
    let id = debugger.break_at_line(14, &When::default())?.id;
    let mut passes = Vec::new();
    loop {
        let stop = debugger.go(Move::Continue);
        if stop.reason != Reason::Breakpoint(id) {
            assert_eq!(stop.reason, Reason::Ended(End::Exit));
            break;
        }
        assert_eq!(debugger.line(), 14);
        passes.push(stop.at);
    }
    assert_eq!(passes.len(), 20);
    // Nothing goes on after the end.
    assert_eq!(debugger.go(Move::Step).reason, Reason::Ended(End::Exit));
    for pass in passes.iter().rev() {
        let stop = debugger.go(Move::ReverseContinue);
        assert_eq!((stop.reason, stop.at), (Reason::Breakpoint(id), *pass));
    }
    let stop = debugger.go(Move::ReverseContinue);
    assert_eq!((stop.reason, stop.at), (Reason::Breakpoint(early.id), 0));
    assert_eq!(debugger.go(Move::ReverseContinue).reason, Reason::Start);
    assert!(debugger.remove_breakpoint(id) && !debugger.remove_breakpoint(id));
    assert_eq!(debugger.go(Move::Continue).reason, Reason::Ended(End::Exit));
    Ok(())
}

#[test]
fn conditions_and_hits_count_from_the_start_wherever_the_breakpoint_is_placed() -> Outcome {
    let stops = |debugger: &mut Debugger, movement| {
        let mut values = Vec::new();
        while let Reason::Breakpoint(_) = debugger.go(movement).reason {
            values.push(debugger.value("N").expect("declared").unwrap_or(-1.0));
        }
        values
    };
    for (condition, hits, expected) in [
        (Some("N >= 17"), None, &[17.0, 18.0, 19.0][..]),
        (None, Some("5"), &[4.0]),
        (None, Some("% 7"), &[6.0, 13.0]),
        (Some("N > 9"), Some("% 4"), &[13.0, 17.0]),
        (Some("N > 9"), Some(">= 9"), &[18.0, 19.0]),
        (Some("TIME > 1E9"), None, &[]),
        (Some("!HALT_REQUEST"), Some("2"), &[1.0]),
    ] {
        let when = When { condition, hits };
        let mut debugger = debugger(CALLS, &titan())?;
        debugger.break_at_line(14, &when)?;
        assert_eq!(stops(&mut debugger, Move::Continue), expected, "{when:?}");
        let mut back = stops(&mut debugger, Move::ReverseContinue);
        back.reverse();
        assert_eq!(back, expected, "{when:?}");
        // Placed in the middle of a run, and looked for from its end.
        let mut late = self::debugger(CALLS, &titan())?;
        late.go(Move::Continue);
        late.break_at_line(14, &when)?;
        let mut back = stops(&mut late, Move::ReverseContinue);
        back.reverse();
        assert_eq!(back, expected, "{when:?}, placed late");
        assert_eq!(stops(&mut late, Move::Continue), expected, "{when:?}");
    }
    Ok(())
}

#[test]
fn conditions_know_cycle_and_time() -> Outcome {
    let mut debugger = debugger(CALLS, &titan())?;
    let when = When {
        condition: Some("CYCLE >= 100"),
        hits: None,
    };
    debugger.break_at_line(14, &when)?;
    debugger.go(Move::Continue);
    assert!((100..120).contains(&debugger.now()));
    assert_eq!(
        debugger.evaluate("CYCLE")?,
        Value::Number(debugger.now() as f64)
    );
    assert_eq!(
        debugger.evaluate("TIME / 20")?,
        Value::Number(debugger.now() as f64)
    );
    assert_eq!(debugger.evaluate("CYCLE < 100")?, Value::Truth(false));
    assert_eq!(debugger.evaluate("n + 1")?, debugger.evaluate("1 + N")?);
    assert!(matches!(
        debugger.evaluate("HEIGHT"),
        Err(DebugError::Wrong(_))
    ));
    assert_eq!(
        debugger.evaluate("1 / 0"),
        Err(DebugError::Fault(Fault::Domain))
    );
    let wrong = When {
        condition: Some("N = 3"),
        hits: None,
    };
    assert!(matches!(
        debugger.break_at_line(14, &wrong),
        Err(DebugError::Wrong(_))
    ));
    let wrong = When {
        condition: None,
        hits: Some("often"),
    };
    assert!(matches!(
        debugger.break_at_line(14, &wrong),
        Err(DebugError::Hits(_))
    ));
    assert_eq!(
        debugger.break_at_line(99, &When::default()),
        Err(DebugError::NoStep(99))
    );
    Ok(())
}

#[test]
fn breakpoints_by_name_are_at_routines_labels_and_words() -> Outcome {
    let mut debugger = debugger(CALLS, &titan())?;
    assert_eq!(debugger.break_at_name("inner", &When::default())?.line, 13);
    debugger.go(Move::Continue);
    assert_eq!(debugger.line(), 13);
    debugger.break_at_name("Sleep", &When::default())?;
    debugger.go(Move::Continue);
    assert_eq!(debugger.line(), 11);
    let error = debugger.break_at_name("PTP", &When::default());
    assert_eq!(error, Err(DebugError::NoName("PTP".to_owned())));
    assert!(debugger.break_at_name("", &When::default()).is_err());
    Ok(())
}

#[test]
fn an_emergency_stops_the_run_and_is_gone_back_from() -> Outcome {
    let text = "3.1\nfails\nDEF_VAR A, B\nA = 0\nSLEEP 100\nB = 1 / A\nEND\n";
    let mut debugger = debugger(text, &titan())?;
    let watch = debugger.watch("B")?;
    let stop = debugger.go(Move::Continue);
    let Reason::Fault(emergency) = stop.reason.clone() else {
        return Err(format!("{stop:?}").into());
    };
    assert_eq!((emergency.fault, debugger.line()), (Fault::Domain, 6));
    assert_eq!(debugger.go(Move::Continue), stop);
    assert_eq!(
        debugger.happens("set A=2".parse()?, Discard::Later),
        Err(DebugError::Ended)
    );
    // A step that fails assigns nothing: nobody ever set B.
    assert_eq!(debugger.go(Move::ReverseContinue).reason, Reason::Start);
    debugger.go(Move::Continue);
    debugger.go(Move::StepBack);
    assert_eq!((debugger.line(), debugger.run().emergency()), (6, None));
    debugger.happens("set A=2".parse()?, Discard::Later)?;
    let stop = debugger.go(Move::Continue);
    assert!(matches!(stop.reason, Reason::Watch { id, .. } if id == watch));
    assert_eq!(debugger.value("B")?, Some(0.5));
    Ok(())
}

#[test]
fn a_fall_stops_a_run_that_is_to_stop_there() -> Outcome {
    // Two legs of one side go up.
    let text = "3.1\nfalls\nSTAND_UP 60\nPTP F1 R 0 0 120\nPTP F4 R 0 0 120\nWAIT_INPOS ALL\nSLEEP 400\nEND\n";
    let robot = Robot::named("titan8")?;
    let mut debugger = debugger(text, &robot)?;
    debugger.stop_at_fall(true);
    let stop = debugger.go(Move::Continue);
    let Reason::Fall(fall) = stop.reason else {
        return Err(format!("{stop:?}").into());
    };
    assert_eq!(stop.at, fall.cycle + 1);
    assert!(matches!(
        debugger.go(Move::Continue).reason,
        Reason::Ended(_)
    ));
    let back = debugger.go(Move::ReverseContinue);
    assert_eq!((back.at, back.reason), (fall.cycle, Reason::Fall(fall)));
    debugger.stop_at_fall(false);
    assert!(matches!(
        debugger.go(Move::Continue).reason,
        Reason::Ended(_)
    ));
    Ok(())
}

#[test]
fn messages_and_variables_are_those_of_the_position() -> Outcome {
    let text =
        "3.1\nsays\nDEF_VAR A\nDEF_JOINT Q\nMESSAGE one\nA = 2\nMESSAGE %A%\nMESSAGE_CLEAR\nEND\n";
    let mut debugger = debugger(text, &titan())?;
    let said = |debugger: &Debugger| {
        let messages = debugger.messages().iter();
        messages.map(|(_, text)| text.clone()).collect::<Vec<_>>()
    };
    debugger.go(Move::Continue);
    assert_eq!(said(&debugger), ["one", "2", ""]);
    let news = |debugger: &mut Debugger| debugger.take_messages().len();
    assert_eq!((news(&mut debugger), news(&mut debugger)), (3, 0));
    debugger.go(Move::To(2));
    debugger.go(Move::Continue);
    assert_eq!(news(&mut debugger), 0, "what is known is not said again");
    debugger.go(Move::To(2));
    assert_eq!(said(&debugger), ["one"]);
    let variables = debugger.variables();
    let shown: Vec<_> = variables
        .iter()
        .map(|it| (it.name.as_str(), it.scalars.len()))
        .collect();
    assert_eq!(shown, [("VAR_KEY", 1), ("A", 1), ("Q", 3)]);
    assert_eq!(variables[1].scalars, [("A".to_owned(), Some(2.0))]);
    assert_eq!(variables[2].scalars[2], ("Q.J3".to_owned(), None));
    Ok(())
}
