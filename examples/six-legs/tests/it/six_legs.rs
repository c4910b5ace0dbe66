//! The hexapod walks on its tripods, alike in both engines; gaits that are wrong fail the same measure.

use six_legs::{HEXAPOD, SOURCE, Tripod};
use std::sync::OnceLock;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::{End, Program};
use tip_runtime::record::Ending;
use tip_sim::lockstep::{Lockstep, LockstepObserver};
use tip_sim::{Robot, Run, load};
use walking::{Measured, Outcome, SLIP};

/// Long enough for every gait here: cycles.
const LIMIT: u64 = 10_000;

/// The feet of the two tripods.
const LEFT: [bool; 6] = [true, false, false, true, true, false];
const RIGHT: [bool; 6] = [false, true, true, false, false, true];

/// The hexapod, simulated.
fn hexapod() -> Robot {
    Robot::of(&HEXAPOD)
}

/// A compiled program beside the interpreter of a text.
fn race(compiled: impl Program + Clone + Send + 'static, text: &str, inputs: &str) -> Outcome<6> {
    let robot = hexapod();
    let program = load("tripod.prg", text, &robot).unwrap();
    let lockstep = Lockstep::new(program.program().clone(), compiled, &robot).unwrap();
    let inputs = format!("{inputs} --cycles {LIMIT}").parse().unwrap();
    let mut watch = Watch(Measured::new());
    let compared = lockstep.run(&inputs, &mut watch).unwrap();
    assert_eq!(compared.divergence, None, "both engines agree");
    watch.0.outcome(compared.ending.unwrap(), compared.cycles)
}

/// Measures the robot of the interpreter.
struct Watch(Measured<6>);

impl LockstepObserver for Watch {
    fn after(&mut self, run: &Run) {
        let robot = run.plant::<SimulatedPlant<6, 3>>();
        self.0.after(run.time(), robot.expect("it is simulated"));
    }
}

fn walked(inputs: &str) -> Outcome<6> {
    race(Tripod::new(), SOURCE, inputs)
}

/// The gait with pieces of its text exchanged.
fn variant(changes: &[(&str, &str)]) -> Outcome<6> {
    let text = changes.iter().fold(SOURCE.to_owned(), |text, (from, to)| {
        assert_eq!(text.matches(from).count(), 1, "{from}");
        text.replace(from, to)
    });
    race(load("tripod.prg", &text, &hexapod()).unwrap(), &text, "")
}

/// The gait as it is, undisturbed.
fn undisturbed() -> &'static Outcome<6> {
    static OUTCOME: OnceLock<Outcome<6>> = OnceLock::new();
    OUTCOME.get_or_init(|| walked(""))
}

/// Which feet were up, one entry for each time that this changed.
fn lifted(outcome: &Outcome<6>) -> Vec<[bool; 6]> {
    let mut lifted: Vec<[bool; 6]> = outcome
        .gait
        .cycles()
        .iter()
        .map(|standing| standing.map(|down| !down))
        .collect();
    lifted.dedup();
    lifted
}

fn count(feet: &[bool; 6]) -> usize {
    feet.iter().filter(|foot| **foot).count()
}

#[test]
fn the_body_comes_forward_by_eleven_strides_upright_and_alike_in_both_engines() {
    let outcome = undisturbed();
    assert!(outcome.is_good(), "{outcome:?}");
    assert_eq!(outcome.ending, Ending::Program(End::Exit));
    // Ten steps of 120 mm, and one half as long at either end.
    assert!((outcome.travel - 1320.0).abs() < 2.0, "{}", outcome.travel);
    assert!(outcome.drift.abs() < 2.0, "{}", outcome.drift);
}

#[test]
fn the_feet_that_carry_do_not_slip() {
    let outcome = undisturbed();
    assert!(outcome.slip < 0.2, "{} mm", outcome.slip);
}

#[test]
fn the_centre_of_mass_stays_as_far_inside_the_tripod_as_geometry_says() {
    // Feet of LEFT: (-290, 260 + d), (330, d), (-290, -260 + d); half a stride behind, d is -60.
    // The edge from the first to the second passes the middle at y = d + 260 * 330 / 620.
    let gap = -60.0 + 260.0 * 330.0 / 620.0;
    let expected = gap * 620.0 / libm::hypot(620.0, 260.0);
    let margin = undisturbed().margin;
    assert!((margin - expected).abs() < 2.0, "{margin}, not {expected}");
}

#[test]
fn never_fewer_than_three_feet_carry_and_those_up_are_of_one_tripod() {
    for up in lifted(undisturbed()) {
        assert!(count(&up) <= 3, "{up:?}");
        let belongs = |tripod: [bool; 6]| up.iter().zip(tripod).all(|(up, own)| own || !up);
        assert!(belongs(LEFT) || belongs(RIGHT), "{up:?}");
    }
}

#[test]
fn the_tripods_take_turns() {
    let whole = lifted(undisturbed());
    let whole: Vec<[bool; 6]> = whole.into_iter().filter(|up| count(up) == 3).collect();
    assert_eq!(whole, [LEFT, RIGHT].repeat(6));
}

#[test]
fn a_halt_request_ends_the_walk_with_the_feet_side_by_side() {
    let whole = undisturbed();
    let outcome = walked(&format!("--halt {}", whole.cycles / 2));
    assert_eq!(outcome.ending, Ending::Program(End::Exit));
    assert!(outcome.falls == 0, "{outcome:?}");
    // Two steps in each turn of the loop, and the two halves.
    let turns = (outcome.travel - 120.0) / 240.0;
    assert!((turns - turns.round()).abs() < 0.02, "{turns}");
    assert!((1.0..5.0).contains(&turns.round()), "{turns}");
}

#[test]
fn too_few_strides_are_too_short_a_way() {
    let outcome = variant(&[("STRIDES = 5", "STRIDES = 3")]);
    assert_eq!(outcome.falls, 0);
    assert!((outcome.travel - 840.0).abs() < 2.0, "{}", outcome.travel);
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
fn three_feet_of_one_side_are_no_tripod() {
    let outcome = variant(&[
        ("REL_PTP F4 LEFT", "REL_PTP F3 LEFT"),
        ("REL_PTP F3 RIGHT", "REL_PTP F4 RIGHT"),
    ]);
    assert!(outcome.falls > 0, "{outcome:?}");
    assert!(!outcome.is_good());
}

#[test]
fn the_example_says_what_happened() {
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_six-legs"))
        .output()
        .expect("it starts");
    assert!(run.status.success(), "{run:?}");
    let told = String::from_utf8_lossy(&run.stdout);
    for line in ["travel 1320 mm", "falls  0", "margin 72 mm"] {
        assert!(told.contains(line), "{line} is not in\n{told}");
    }
}
