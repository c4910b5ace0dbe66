//! The gait walks, alike in both engines; gaits that are wrong fail the same measure.

use std::sync::OnceLock;
use tip_runtime::command::Target;
use tip_runtime::fault::Fault;
use tip_runtime::machine::Machine;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::{End, Program};
use tip_runtime::record::Ending;
use tip_sim::lockstep::{Lockstep, LockstepObserver};
use tip_sim::{Robot, Run, load};
use walk::{SOURCE, Walk};
use walking::{GOAL, Measured, Outcome, SLIP};

/// Long enough for every gait here: cycles.
const LIMIT: u64 = 20_000;

/// A compiled program beside the interpreter of a text.
fn race(compiled: impl Program + Clone + Send + 'static, text: &str, inputs: &str) -> Outcome<4> {
    let robot = Robot::named("titan8").unwrap();
    let program = load("walk.prg", text, &robot).unwrap();
    let lockstep = Lockstep::new(program.program().clone(), compiled, &robot).unwrap();
    let inputs = format!("{inputs} --cycles {LIMIT}").parse().unwrap();
    let mut watch = Watch(Measured::new());
    let compared = lockstep.run(&inputs, &mut watch).unwrap();
    assert_eq!(compared.divergence, None, "both engines agree");
    watch.0.outcome(compared.ending.unwrap(), compared.cycles)
}

/// Measures the robot of the interpreter.
struct Watch(Measured<4>);

impl LockstepObserver for Watch {
    fn after(&mut self, run: &Run) {
        let robot = run.plant::<SimulatedPlant<4, 3>>();
        self.0.after(run.time(), robot.expect("it is simulated"));
    }
}

fn walked(inputs: &str) -> Outcome<4> {
    race(Walk::new(), SOURCE, inputs)
}

/// The gait with pieces of its text exchanged.
fn variant(changes: &[(&str, &str)]) -> Outcome<4> {
    let mut text = SOURCE.to_owned();
    for (from, to) in changes {
        assert_eq!(text.matches(from).count(), 1, "{from}");
        text = text.replace(from, to);
    }
    let robot = Robot::named("titan8").unwrap();
    race(load("variant.prg", &text, &robot).unwrap(), &text, "")
}

/// The gait as it is, undisturbed.
fn undisturbed() -> &'static Outcome<4> {
    static OUTCOME: OnceLock<Outcome<4>> = OnceLock::new();
    OUTCOME.get_or_init(|| walked(""))
}

#[test]
fn the_body_comes_forward_by_six_strides_upright_and_alike_in_both_engines() {
    let outcome = undisturbed();
    assert!(outcome.is_good(), "{outcome:?}");
    assert_eq!(outcome.ending, Ending::Program(End::Exit));
    assert!((outcome.travel - 1200.0).abs() < 5.0, "{}", outcome.travel);
    assert!(outcome.drift.abs() < 5.0, "{}", outcome.drift);
    assert!(outcome.margin >= 50.0, "{}", outcome.margin);
}

#[test]
fn the_example_prints_the_run_that_both_engines_make() {
    let mut robot = Machine::simulated(Walk::new());
    let outcome = walking::run(&mut robot, LIMIT, true, &mut ());
    assert_eq!(outcome.to_string(), undisturbed().to_string());
}

#[test]
fn never_two_feet_are_up_while_the_feet_carry_the_body() {
    let outcome = undisturbed();
    let up: Vec<usize> = outcome
        .gait
        .cycles()
        .iter()
        .map(|feet| feet.iter().filter(|down| !**down).count())
        .collect();
    // Twice the belly carries: before standing up and after sitting down.
    let on_belly = up
        .chunk_by(|a, b| (*a > 1) == (*b > 1))
        .filter(|run| run[0] > 1)
        .count();
    assert_eq!(on_belly, 2);
}

#[test]
fn every_stride_lifts_each_foot_once_rear_before_front_on_either_side() {
    let outcome = undisturbed();
    let cycles = outcome.gait.cycles();
    let lifted = |pair: &[[bool; 4]]| (0..4).find(|foot| pair[0][*foot] && !pair[1][*foot]);
    let alone = cycles
        .windows(2)
        .filter(|pair| pair[1].iter().filter(|down| !**down).count() == 1);
    let order: Vec<usize> = alone.filter_map(lifted).map(|foot| foot + 1).collect();
    // Before and after the walk all feet rise from the floor, F1 a cycle ahead of the others.
    let walk = [3, 1, 4, 2].repeat(6);
    assert_eq!(order, [vec![1], walk, vec![1]].concat());
}

#[test]
fn a_halt_request_ends_the_walk_at_the_end_of_the_stride() {
    let whole = undisturbed();
    let outcome = walked(&format!("--halt {}", whole.cycles / 2));
    assert_eq!(outcome.ending, Ending::Program(End::Exit));
    assert_eq!(outcome.falls, 0);
    let strides = outcome.travel / 200.0;
    assert!((strides - strides.round()).abs() < 0.03, "{strides}");
    assert!((1.0..6.0).contains(&strides.round()), "{strides}");
}

#[test]
fn q_stops_and_f_hurries_and_s_slows() {
    let normal = undisturbed();
    let keys = |keys| walked(&format!("--keys {keys}"));
    let stopped = keys("800:q");
    assert!(stopped.travel < normal.travel - 150.0 && stopped.falls == 0);
    let hurried = keys("100:f");
    assert!(
        hurried.is_good() && hurried.cycles < normal.cycles,
        "{hurried:?}"
    );
    let slowed = keys("100:s");
    assert!(
        slowed.is_good() && slowed.cycles > normal.cycles,
        "{slowed:?}"
    );
}

#[test]
fn a_foot_that_steps_and_sweeps_the_wrong_way_is_noticed() {
    let outcome = variant(&[
        ("P1.Y = 201 - HALF", "P1.Y = 201 + HALF"),
        ("P1.Y += STRIDE", "P1.Y -= STRIDE"),
        ("  P1 += SHIFT\n", "  P1.X += SHIFT.X ; P1.Y -= SHIFT.Y\n"),
    ]);
    assert_eq!(outcome.ending, Ending::Program(End::Exit));
    assert!(outcome.travel < GOAL, "{} mm", outcome.travel);
    assert!(outcome.slip > SLIP, "{} mm", outcome.slip);
    assert!(!outcome.is_good());
}

#[test]
fn a_foot_that_only_sweeps_the_wrong_way_gets_out_of_reach() {
    let outcome = variant(&[("  P1 += SHIFT\n", "  P1 -= SHIFT\n")]);
    let Ending::Emergency(emergency) = outcome.ending else {
        panic!("{outcome:?}");
    };
    assert_eq!(emergency.fault, Fault::OutOfReach(Target::Foot(1)));
    assert!(!outcome.is_good());
}

#[test]
fn two_adjacent_feet_lifted_together_make_the_robot_fall() {
    let outcome = variant(&[(
        "  PTP F3 P3.X P3.Y TOP\n  WAIT_NEAR F3\n",
        "  PTP F3 P3.X P3.Y TOP\n  PTP F1 P1.X P1.Y TOP\n  WAIT_NEAR F3\n",
    )]);
    assert!(outcome.falls > 0, "{outcome:?}");
    assert!(!outcome.is_good());
}

#[test]
fn feet_that_do_not_set_out_together_drag() {
    let outcome = variant(&[("  ALL_STOP\n", ""), ("  ALL_STOP_RELEASE\n", "")]);
    assert_eq!(outcome.falls, 0);
    assert!(outcome.slip > SLIP, "{} mm", outcome.slip);
    assert!(!outcome.is_good());
}

#[test]
fn a_harmless_change_is_none_of_these() {
    let outcome = variant(&[("LIFT = 40 ", "LIFT = 35 ")]);
    assert!(outcome.is_good(), "{outcome:?}");
}

#[test]
fn too_few_strides_are_too_short_a_way() {
    let outcome = variant(&[("STRIDES = 6", "STRIDES = 4")]);
    assert_eq!(outcome.falls, 0);
    assert!(
        (outcome.travel - 800.0).abs() < 5.0,
        "{} mm",
        outcome.travel
    );
    assert!(!outcome.is_good());
}

#[test]
fn a_trace_that_cannot_be_written_is_named() {
    let outcome = std::process::Command::new(env!("CARGO_BIN_EXE_walk"))
        .args(["--cycles", "1", "--trace", "no/such/folder/walk.jsonl"])
        .output()
        .expect("it starts");
    assert_eq!(outcome.status.code(), Some(1));
    let told = String::from_utf8_lossy(&outcome.stderr);
    assert!(told.contains("no/such/folder/walk.jsonl"), "{told}");
}

#[test]
fn a_closed_output_is_an_error_and_no_panic() {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let outcome = std::process::Command::new(env!("CARGO_BIN_EXE_walk"))
        .arg("--help")
        .stdout(writer)
        .output()
        .expect("it starts");
    assert_eq!(outcome.status.code(), Some(1));
    let told = String::from_utf8_lossy(&outcome.stderr);
    assert!(told.starts_with("walk: "), "{told}");
}
