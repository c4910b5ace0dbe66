//! The gait walks and its thread holds the leg, alike in both engines.

use feeler::{Feeler, SOURCE};
use std::sync::OnceLock;
use tip_runtime::command::Target;
use tip_runtime::fault::Fault;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::{End, Program};
use tip_runtime::record::Ending;
use tip_sim::lockstep::{Lockstep, LockstepObserver};
use tip_sim::{Robot, Run, load};
use walking::{Measured, Outcome};

/// Long enough for every run here: cycles.
const LIMIT: u64 = 20_000;

/// A run of both engines: the walk, the end of the program, and in each cycle the joints of the front left leg and the
/// value of HELD.
struct Walked {
    outcome: Outcome<4>,
    leg: Vec<Vec<f64>>,
    held: Vec<bool>,
}

/// A compiled program beside the interpreter of a text.
fn race(compiled: impl Program + Clone + Send + 'static, text: &str, events: &str) -> Walked {
    let robot = Robot::named("titan8").unwrap();
    let program = load("feeler.prg", text, &robot).unwrap();
    let lockstep = Lockstep::new(program.program().clone(), compiled, &robot).unwrap();
    let inputs = format!("{events} --cycles {LIMIT}").parse().unwrap();
    let mut watch = Watch {
        measured: Measured::new(),
        leg: Vec::new(),
        held: Vec::new(),
    };
    let compared = lockstep.run(&inputs, &mut watch).unwrap();
    assert_eq!(compared.divergence, None, "both engines agree");
    Walked {
        outcome: watch
            .measured
            .outcome(compared.ending.unwrap(), compared.cycles),
        leg: watch.leg,
        held: watch.held,
    }
}

/// Measures the robot of the interpreter.
struct Watch {
    measured: Measured<4>,
    leg: Vec<Vec<f64>>,
    held: Vec<bool>,
}

impl LockstepObserver for Watch {
    fn after(&mut self, run: &Run) {
        let robot = run.plant::<SimulatedPlant<4, 3>>();
        self.measured
            .after(run.time(), robot.expect("it is simulated"));
        let setpoints = run.setpoints();
        let foot = setpoints.iter().find(|it| it.of == Target::Foot(1));
        self.leg
            .push(foot.map_or(Vec::new(), |it| it.goal().to_vec()));
        self.held.push(run.program().get("HELD") == Ok(Some(1.0)));
    }
}

fn walked(events: &str) -> Walked {
    race(Feeler::new(), SOURCE, events)
}

/// The walk with nothing in the way.
fn undisturbed() -> &'static Walked {
    static WALKED: OnceLock<Walked> = OnceLock::new();
    WALKED.get_or_init(|| walked(""))
}

#[test]
fn the_body_comes_forward_by_six_strides_upright_and_alike_in_both_engines() {
    let outcome = &undisturbed().outcome;
    assert!(outcome.is_good(), "{outcome:?}");
    assert_eq!(outcome.ending, Ending::Program(End::Exit));
    assert!((outcome.travel - 1200.0).abs() < 5.0, "{}", outcome.travel);
    assert!(outcome.drift.abs() < 5.0, "{}", outcome.drift);
    assert!(outcome.margin >= 50.0, "{}", outcome.margin);
    assert!(!undisturbed().held.contains(&true));
}

/// A wait of ten seconds costs at most these 500 cycles: what the gait does meanwhile is not lost.
#[test]
fn while_the_feeler_touches_the_leg_stands_and_then_the_gait_goes_on() {
    let whole = undisturbed();
    let held = walked("--events 500:ANTENNA=5,1000:ANTENNA=0");
    assert!(held.outcome.is_good(), "{:?}", held.outcome);
    assert!((held.outcome.travel - 1200.0).abs() < 5.0);
    let later = held.outcome.cycles - whole.outcome.cycles;
    assert!((1..=500).contains(&later), "{later} cycles later");
    let from = held
        .held
        .iter()
        .position(|held| *held)
        .expect("it was locked");
    let cycles = held.held.iter().filter(|held| **held).count();
    // Locked in cycle 501 at the earliest, after a step of the leg that was under way; free again in cycle 1001.
    assert!((501..600).contains(&from), "{from}");
    assert_eq!(from + cycles, 1001);
    for leg in &held.leg[from..from + cycles] {
        assert_eq!(
            leg, &held.leg[from],
            "the leg has one target while it is locked"
        );
    }
}

#[test]
fn a_gait_that_does_not_ask_cannot_move_the_locked_leg() {
    let text = SOURCE.replace("  IF HELD == 1 GOTO ASK:\n", "");
    assert_ne!(text, SOURCE);
    let robot = Robot::named("titan8").unwrap();
    let rude = load("feeler.prg", &text, &robot).unwrap();
    let rude = race(rude, &text, "--events 500:ANTENNA=5");
    let Ending::Emergency(emergency) = rude.outcome.ending else {
        panic!("{:?}", rude.outcome);
    };
    assert_eq!(emergency.fault, Fault::InvalidMode);
}

#[test]
fn the_example_says_how_long_the_leg_was_locked() {
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_feeler"))
        .output()
        .expect("it starts");
    assert!(run.status.success(), "{run:?}");
    let told = String::from_utf8_lossy(&run.stdout);
    let held = walked("--events 500:ANTENNA=5,700:ANTENNA=0");
    let cycles = held.held.iter().filter(|held| **held).count();
    let locked = format!("F1 was locked for {} ms", cycles * 20);
    for line in ["travel 1200 mm", "falls  0", &locked] {
        assert!(told.contains(line), "{line} is not in\n{told}");
    }
}
