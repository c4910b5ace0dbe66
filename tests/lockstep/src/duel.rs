//! The comparison of two engines on one program.

use crate::machines::{Side, with_pair};
use crate::script::Script;
use std::panic::{AssertUnwindSafe, catch_unwind};
use tip_runtime::machine::Status;
use tip_runtime::program::Program;
use tipc::Robot;

/// A run that both engines agree about.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How many cycles were compared.
    pub cycles: u64,
    /// The command or the error that ended it, or `LIMIT`.
    pub end: String,
    /// Everything that it did.
    pub hash: u64,
    /// How often each step came to its end.
    pub visits: Vec<u64>,
}

/// Where two engines part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The first cycle that differs.
    pub cycle: u64,
    /// What the first engine did in it.
    pub expected: String,
    /// What the second one did.
    pub found: String,
}

/// What came of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Not a bit differs.
    Same(Run),
    /// They part, or one of them panics.
    Different(Difference),
}

/// Makes an engine at its first step.
pub(crate) type Engine<'a> = &'a dyn Fn() -> Box<dyn Program>;

/// Runs two engines by the same script.
pub(crate) fn duel(
    robot: Robot,
    script: &Script,
    first: Engine<'_>,
    second: Engine<'_>,
) -> Verdict {
    let (mut a, mut b) = (first(), second());
    if let Some(difference) = unlike(a.as_ref(), b.as_ref()) {
        return Verdict::Different(difference);
    }
    let ran = catch_unwind(AssertUnwindSafe(|| {
        run(robot, script, a.as_mut(), b.as_mut())
    }));
    match ran {
        Err(_) => Verdict::Different(Difference {
            cycle: 0,
            expected: "no panic".to_owned(),
            found: "a panic".to_owned(),
        }),
        Ok(Ok(run)) => Verdict::Same(run),
        Ok(Err(cycle)) => {
            let [expected, found] = in_words(robot, script, cycle, first, second);
            Verdict::Different(Difference {
                cycle,
                expected,
                found,
            })
        }
    }
}

/// What programs say of themselves without running.
fn unlike(a: &dyn Program, b: &dyn Program) -> Option<Difference> {
    let facts = |program: &dyn Program| {
        let steps = (0..)
            .map(|step| program.line(step))
            .take_while(|line| *line > 0);
        let names = (0..).map_while(|n| program.scalar(n).map(|(name, _)| name.to_owned()));
        let lines: Vec<u32> = steps.collect();
        let names: Vec<String> = names.collect();
        let named = (program.name(), program.title());
        format!("{:?} {named:?} {lines:?} {names:?}", program.signature())
    };
    let (expected, found) = (facts(a), facts(b));
    (expected != found).then_some(Difference {
        cycle: 0,
        expected,
        found,
    })
}

/// The first cycle that differs is an error.
fn run(
    robot: Robot,
    script: &Script,
    a: &mut dyn Program,
    b: &mut dyn Program,
) -> Result<Run, u64> {
    let steps = (0..).take_while(|step| a.line(*step) > 0).count();
    let mut sides = [Side::new(steps), Side::new(steps)];
    let cycles = with_pair(robot, script, [a, b], |pair| {
        let mut cycles = 0;
        while cycles < script.limit && pair.cycle(&mut sides) {
            cycles += 1;
        }
        cycles
    });
    let [expected, found] = sides;
    if !expected.equals(&found) {
        return Err(cycles);
    }
    let end = match (expected.status, expected.emergency) {
        (_, Some(emergency)) => emergency.fault.to_string(),
        (Status::Finished(end), _) => format!("{end:?}").to_uppercase(),
        (Status::Running | Status::Emergency, _) => "LIMIT".to_owned(),
    };
    // The cycle that ended it was compared as well.
    let last = u64::from(cycles < script.limit);
    Ok(Run {
        cycles: cycles + last,
        end,
        hash: expected.notes.hash.value(),
        visits: expected.notes.visits,
    })
}

/// What both sides did in a cycle.
fn in_words(
    robot: Robot,
    script: &Script,
    cycle: u64,
    first: Engine<'_>,
    second: Engine<'_>,
) -> [String; 2] {
    let (mut a, mut b) = (first(), second());
    let mut sides = [Side::new(0), Side::new(0)];
    with_pair(robot, script, [a.as_mut(), b.as_mut()], |pair| {
        for n in 0..=cycle {
            if n == cycle {
                sides
                    .iter_mut()
                    .for_each(|side| side.notes.words = Some(String::new()));
            }
            pair.cycle(&mut sides);
        }
    });
    sides.map(|side| {
        let words = side.notes.words.unwrap_or_default();
        match side.emergency {
            Some(emergency) => format!("{words}  {emergency}\n"),
            None => format!("{words}  {:?}\n", side.status),
        }
    })
}
