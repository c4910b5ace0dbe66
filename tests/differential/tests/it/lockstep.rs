//! Differences that the comparison of two engines must find.

use ::lockstep::{Figures, Script, Subject, Verdict, compare, shrink};
use tip_sim::lockstep::Divergence;
use tip_sim::{Event, Interpreter, Plant, ProgramRunner};
use tipc::{Options, Robot};

const RIGHT: &str = "3.1
counts keys
DEF_VAR D
D = 0
LOOP:
IF KB_HIT THEN
D = D + 1
FLUSH_BUF
ENDIF
GOTO
END
";

fn engine(source: &str) -> ProgramRunner {
    let loaded = tipc::load("1.prg", source.as_bytes(), &Options::default());
    ProgramRunner::new(Interpreter::new(loaded.program.expect("it loads")))
}

fn right() -> ProgramRunner {
    engine(RIGHT)
}

/// Only a key makes it differ.
fn wrong() -> ProgramRunner {
    engine(&RIGHT.replace("D + 1", "D - 1"))
}

fn longer() -> ProgramRunner {
    engine(&RIGHT.replace("FLUSH_BUF", "FLUSH_BUF\nREM"))
}

fn subject(compiled: fn() -> ProgramRunner) -> Subject {
    ((1, "titan8", RIGHT), compiled)
}

fn script() -> Script {
    Script::random(Robot::Titan8, 1, 0, 2000, Plant::Echo)
}

#[test]
fn equal_engines_agree_to_the_last_cycle() {
    let mut figures = Figures::default();
    let Verdict::Same(run) = compare(&subject(right), &script(), &mut figures) else {
        panic!("the same program");
    };
    assert_eq!(run.end, "LIMIT");
    assert_eq!((run.cycles, figures.get("cycles")), (2000, 2000));
    assert!(figures.get("ran titan8/FLUSH_BUF") > 10, "{figures}");
    assert_eq!(
        figures.get("ran titan8/equation +"),
        figures.get("ran titan8/FLUSH_BUF")
    );
    assert_eq!(Figures::parse(&figures.to_string()), figures);
}

#[test]
fn a_wrong_operator_is_found_and_its_events_are_shrunk_to_one_key() {
    let subject = subject(wrong);
    let Verdict::Different(difference) = compare(&subject, &script(), &mut Figures::default())
    else {
        panic!("one adds, one subtracts");
    };
    assert!(
        difference.interpreted.contains("D is Some(1.0)"),
        "{difference:?}"
    );
    assert!(
        difference.compiled.contains("D is Some(-1.0)"),
        "{difference:?}"
    );
    let (script, shrunk) = shrink(&subject, &script(), difference);
    let [key] = script.inputs.events.all() else {
        panic!("one key is enough: {script:?}");
    };
    assert!(matches!(key.event, Event::Key(_)), "{script:?}");
    let cycle = key.cycle;
    assert!(
        shrunk.cycle <= cycle + 4 && script.inputs.cycles == Some(shrunk.cycle + 1),
        "{script:?}"
    );
}

#[test]
fn programs_of_other_steps_are_no_match_before_they_run() {
    let verdict = compare(&subject(longer), &script(), &mut Figures::default());
    assert!(matches!(
        verdict,
        Verdict::Different(Divergence { cycle: 0, .. })
    ));
}

#[test]
fn simulated_robots_agree_with_themselves() {
    let engines: [(Robot, fn() -> ProgramRunner); 3] = [
        (Robot::Titan8, right),
        (Robot::Hand, || engine_on(Robot::Hand)),
        (Robot::Generic, || engine_on(Robot::Generic)),
    ];
    for (robot, engine) in engines {
        let script = Script::random(robot, 2, 0, 200, Plant::Simulated);
        let subject = ((1, robot.name(), RIGHT), engine);
        let verdict = compare(&subject, &script, &mut Figures::default());
        assert!(matches!(verdict, Verdict::Same(_)), "{}", robot.name());
    }
}

fn engine_on(robot: Robot) -> ProgramRunner {
    let options = Options {
        robot,
        ..Options::default()
    };
    let loaded = tipc::load("1.prg", RIGHT.as_bytes(), &options);
    ProgramRunner::new(Interpreter::new(loaded.program.expect("it loads")))
}
