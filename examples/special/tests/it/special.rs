//! The commands do what they say, and alike in both engines.

use special::run::{Plant, Run, interpreter, run};
use special::{Dance, SOURCE};
use tip_runtime::command::{Port, Target};
use tip_runtime::fault::Fault;
use tip_runtime::model::{Point, titan8};
use tip_runtime::plant::Plant as _;
use tip_runtime::program::End;
use tip_runtime::record::Ending;

tip_macros::tip!(
    Unknown,
    "3.1\nA number that nothing answers to\nSPECIAL 32 1 2\nEND"
);

fn plant() -> Plant {
    Plant::new(&titan8::MODEL)
}

/// The dance, compiled and interpreted alike, and what it said.
fn dance(plant: &Plant) -> (Run, Vec<String>) {
    let compiled = run(Dance::new(), plant.clone()).unwrap();
    let text = interpreter("dance.prg", SOURCE).unwrap();
    let interpreted = run(text, plant.clone()).unwrap();
    assert_eq!(compiled.trace, interpreted.trace);
    let said = compiled.said.clone();
    (compiled, said)
}

/// Statements on a robot that stands.
fn standing(statements: &str) -> Run {
    let text = format!("3.1\ntest\nSTAND_UP 50\nSLEEP 200\n{statements}\nEND\n");
    run(interpreter("test.prg", &text).unwrap(), plant()).unwrap()
}

fn fault(run: &Run) -> Option<Fault> {
    match run.ending {
        Ending::Emergency(emergency) => Some(emergency.fault),
        _ => None,
    }
}

/// Returns the number of turns of a path around the start, counter-clockwise.
fn turns(path: &[Point], beyond: f64) -> f64 {
    let far = path.iter().filter(|[x, y, _]| x.hypot(*y) > beyond);
    let angles: Vec<f64> = far.map(|[x, y, _]| y.atan2(*x)).collect();
    let steps = angles.windows(2).map(|pair| (pair[1] - pair[0]).sin());
    steps.sum::<f64>() / std::f64::consts::TAU
}

#[test]
fn the_body_sways_along_the_circle_and_comes_back() {
    let (run, _) = dance(&plant());
    assert_eq!(run.ending, Ending::Program(End::End));
    assert!((run.excursion() - 40.0).abs() < 1.0, "{}", run.excursion());
    assert!(run.rest() < 1.0, "{} mm", run.rest());
    // The spirals out and in add up to one turn, of which only the far part is seen.
    let turns = turns(&run.path, 20.0);
    assert!((2.0..3.0).contains(&turns), "{turns} turns");
    assert!(run.plant.worst_slip() < 1.0, "{}", run.plant.worst_slip());
    assert_eq!(run.plant.falls(), 0);
}

#[test]
fn radius_and_turns_are_arguments() {
    let small = standing("SPECIAL 30 20 1");
    let long = standing("SPECIAL 30 20 3.5");
    for run in [&small, &long] {
        assert!((run.excursion() - 20.0).abs() < 1.0, "{}", run.excursion());
        assert!(run.rest() < 1.0, "{} mm", run.rest());
    }
    let more = turns(&long.path, 10.0) - turns(&small.path, 10.0);
    assert!((more - 2.5).abs() < 0.05, "{more} turns more");
}

#[test]
fn the_flag_tells_whether_every_sole_reads_enough() {
    let swayed = |volts| {
        let mut plant = plant();
        assert!(plant.set_sensor(Port::Paw(3), volts));
        let (run, said) = dance(&plant);
        assert_eq!(run.ending, Ending::Program(End::End));
        let refused = said.iter().any(|line| line.contains("so no dance"));
        assert_eq!(refused, run.excursion() < 1.0);
        !refused
    };
    assert!(!swayed(0.6));
    assert!(swayed(0.61));
}

#[test]
fn the_flag_is_cleared_too() {
    let run = standing(
        "SPECIAL 31 0.6\nIF !SPECIAL_FLAG0 GOTO BAD:\nSPECIAL 31 4\nIF SPECIAL_FLAG0 GOTO BAD:\nEXIT\nBAD:",
    );
    assert_eq!(run.ending, Ending::Program(End::Exit));
}

#[test]
fn what_nothing_answers_to_is_a_domain_error() {
    let compiled = run(Unknown::new(), plant()).unwrap();
    let text = "3.1\nA number that nothing answers to\nSPECIAL 32 1 2\nEND";
    let interpreted = run(interpreter("unknown.prg", text).unwrap(), plant()).unwrap();
    assert_eq!(fault(&compiled), Some(Fault::Domain));
    assert_eq!(compiled.trace, interpreted.trace);
    for wrong in [
        "SPECIAL 30",
        "SPECIAL 30 40",
        "SPECIAL 30 0 2",
        "SPECIAL 30 40 -1",
        "SPECIAL 31",
        "SPECIAL 31 1 1",
    ] {
        assert_eq!(fault(&standing(wrong)), Some(Fault::Domain), "{wrong}");
    }
}

#[test]
fn a_circle_that_a_foot_cannot_follow_stops_the_robot() {
    // Under EMG_OFF the controller would let the foot go as far as it can: the command refuses.
    for statements in ["SPECIAL 30 300 1", "EMG_OFF\nSPECIAL 30 300 1"] {
        let fault = fault(&standing(statements));
        let refused = matches!(fault, Some(Fault::OutOfReach(Target::Foot(_))));
        assert!(refused, "{statements}: {fault:?}");
    }
}

#[test]
fn the_example_says_what_happened() {
    let told = std::process::Command::new(env!("CARGO_BIN_EXE_special"))
        .output()
        .expect("it starts");
    assert!(told.status.success(), "{told:?}");
    let text = String::from_utf8_lossy(&told.stdout);
    assert!(text.contains("swaying 2 times around"), "{text}");
    assert!(text.contains("traces identical"), "{text}");
}
