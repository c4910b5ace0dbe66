//! Random walks through a run, and changes of its past.

use super::{Outcome, debugger, titan};
use std::env;
use tip_sim::debug::{Debugger, Discard, Move, When, Work};
use tip_sim::{Event, Events, Interpreter, Limit, Robot, Run, load};

/// Every part of a run that has a state: variables, calls, motion, keys, inputs.
const BUSY: &str = "3.1
busy
DEF_VAR N, V, K
DEF_POS P
N = 0
PTP_ANGLE J11 20
L:
GOSUB S:
AD_IN VR1 V
IF KB_HIT THEN
KEY_IN K
PTP_ANGLE J22 R 3
ENDIF
SLEEP 60
IF N < 40 GOTO L:
WAIT_INPOS ALL
PTP F1 R 0 0 10
SLEEP 100
N = 0
GOTO L:
S:
N += 1
TEACH_POS F1 P
MESSAGE %N%
RETURN
END
";

const EVENTS: &str = "20:key a, 25:VR1=4, 133:key b, 133:key c, 447:VR1=2, 460:key d, 700:set N=39";

/// Number of cycles of the reference.
const CYCLES: u64 = 2600;

/// A generator of numbers that are the same everywhere.
struct Dice(u64);

impl Dice {
    fn below(&mut self, most: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % most
    }
}

/// Everything that can be seen of a run, with the step that comes next.
#[derive(Clone, Debug, PartialEq)]
struct Sight {
    step: u32,
    state: u64,
    time: u64,
    scalars: Vec<Option<u64>>,
}

fn sight(run: &Run) -> Sight {
    let program = run.program();
    let scalars = (0..).map_while(|place| program.scalar(place));
    Sight {
        step: program.at(),
        state: run.state_hash(),
        time: run.time().to_bits(),
        scalars: scalars.map(|(_, value)| value.map(f64::to_bits)).collect(),
    }
}

/// Returns the state before each cycle of a run without a debugger. Values that events set show in
/// the cycle after.
fn reference(robot: &Robot, events: &Events) -> Result<Vec<Sight>, Box<dyn std::error::Error>> {
    let program: Interpreter = load("debugged.prg", BUSY, robot)?;
    let mut run = Run::new(program, robot.clone())?.with_events(events)?;
    let mut sights = Vec::new();
    for _ in 0..CYCLES {
        sights.push(sight(&run));
        run.cycle();
    }
    Ok(sights)
}

/// Returns the number of walks: all of them take a while.
fn walks() -> u64 {
    let asked = env::var("TIP_WALKS")
        .ok()
        .and_then(|number| number.parse().ok());
    asked.unwrap_or(40)
}

fn random_move(dice: &mut Dice) -> Move {
    match dice.below(13) {
        0 => Move::Cycle,
        1 => Move::Step,
        2 => Move::Over,
        3 => Move::Out,
        4 => Move::Line(14),
        5 => Move::CycleBack,
        6 => Move::StepBack,
        7 => Move::OverBack,
        8 => Move::OutBack,
        9 => Move::LineBack(23),
        10 => Move::Continue,
        11 => Move::ReverseContinue,
        _ => Move::To(dice.below(CYCLES)),
    }
}

#[track_caller]
fn compare(debugger: &Debugger, sights: &[Sight], skipped: &[u64]) {
    let at = debugger.now();
    if !skipped.contains(&at)
        && let Some(expected) = sights.get(at as usize)
    {
        assert_eq!(&sight(debugger.run()), expected, "at {at}");
        // Program and robot have one time: 20 ms a cycle.
        assert_eq!(debugger.run().time(), 20.0 * at as f64);
        assert_eq!(debugger.run().cycles(), at);
    }
}

fn cycles_of_sets(events: &Events) -> Vec<u64> {
    let all = events.all().iter();
    let sets = all.filter(|timed| matches!(timed.event, Event::Set(..)));
    sets.map(|timed| timed.cycle).collect()
}

#[test]
fn walks_forwards_and_backwards_pass_through_one_and_the_same_run() -> Outcome {
    let robots = [titan(), Robot::named("titan8")?];
    for robot in robots {
        let events: Events = EVENTS.parse()?;
        let sights = reference(&robot, &events)?;
        let skipped = cycles_of_sets(&events);
        let mut debugger = debugger(BUSY, &robot)?.with_events(&events)?;
        debugger.break_at_line(
            9,
            &When {
                condition: Some("N > 20"),
                hits: Some("% 3"),
            },
        )?;
        debugger.break_at_line(
            13,
            &When {
                condition: Some("VAR_KEY == 65"),
                hits: None,
            },
        )?;
        debugger.break_at_name("PTP", &When::default())?;
        debugger.watch("P.Z")?;
        let mut dice = Dice(15);
        for walk in 0..walks() {
            // Walks end in different places of the run, also where nobody was yet.
            debugger.go(Move::To(dice.below(CYCLES.min(400 + 60 * walk))));
            for _ in 0..6 {
                let movement = random_move(&mut dice);
                let before = debugger.now();
                let stop = debugger.go(movement);
                assert_eq!(stop.at, debugger.now());
                if movement.is_back() {
                    assert!(stop.at < before || before == 0, "{movement:?}");
                }
                compare(&debugger, &sights, &skipped);
                if debugger.now() >= CYCLES {
                    debugger.go(Move::To(dice.below(CYCLES)));
                }
            }
        }
    }
    Ok(())
}

#[test]
fn there_and_back_and_there_is_the_same_place_for_every_cycle() -> Outcome {
    let mut debugger = debugger(BUSY, &titan())?.with_events(&EVENTS.parse()?)?;
    let mut sights = vec![sight(debugger.run())];
    for _ in 0..1200 {
        debugger.go(Move::Cycle);
        sights.push(sight(debugger.run()));
    }
    for at in (0..1200_u64).rev().step_by(7) {
        debugger.go(Move::To(at));
        assert_eq!(sight(debugger.run()), sights[at as usize], "back at {at}");
    }
    debugger.go(Move::To(1200));
    assert_eq!(Some(&sight(debugger.run())), sights.last());
    assert_eq!(debugger.known(), 1200);
    Ok(())
}

#[test]
fn a_changed_past_is_the_run_with_that_event() -> Outcome {
    let robot = titan();
    let given: Events = EVENTS.parse()?;
    let mut debugger = debugger(BUSY, &robot)?.with_events(&given)?;
    debugger.go(Move::To(1000));
    let mut dice = Dice(3);
    for event in [
        "key x",
        "VR1=9.5",
        "set N=7",
        "key y",
        "set P.X=1.5",
        "touch on",
    ] {
        let at = 300 + dice.below(600);
        debugger.go(Move::To(at));
        let later = debugger.known() - at;
        let event: Event = event.parse()?;
        let messages = debugger.messages().to_vec();
        let refused = debugger.happens(event.clone(), Discard::Nothing);
        let reported = refused.map_err(|refused| refused.to_string());
        let expected = format!("later cycles that would be discarded: {later}");
        assert_eq!(reported, Err(expected));
        assert_eq!(
            debugger.known(),
            at + later,
            "nothing is discarded by asking"
        );
        debugger.happens(event.clone(), Discard::Later)?;
        assert_eq!((debugger.now(), debugger.known()), (at, at));
        assert_eq!(debugger.messages(), messages);
        // What its user made happen later is gone with the rest.
        let changes = debugger.changes();
        assert!(changes.all().iter().all(|change| change.cycle <= at));
        assert_eq!(changes.all().last(), Some(&event.at(at)));
        let events = Events::new([given.all(), changes.all()].concat());
        let sights = reference(&robot, &events)?;
        let skipped = cycles_of_sets(&events);
        for to in [at + 1, 1000, 550, at.saturating_sub(30), 1500, 1000] {
            debugger.go(Move::To(to));
            compare(&debugger, &sights, &skipped);
        }
    }
    Ok(())
}

#[test]
fn a_value_that_is_set_shows_at_once_and_after_coming_back() -> Outcome {
    let mut debugger = debugger(BUSY, &titan())?;
    debugger.go(Move::To(100));
    debugger.happens("set V=3.5".parse()?, Discard::Nothing)?;
    debugger.happens("set K=5".parse()?, Discard::Nothing)?;
    assert_eq!(debugger.value("v")?, Some(3.5));
    debugger.go(Move::To(160));
    debugger.go(Move::To(100));
    assert_eq!(
        (debugger.value("V")?, debugger.value("K")?),
        (Some(3.5), Some(5.0))
    );
    debugger.go(Move::To(99));
    assert_ne!(debugger.value("V")?, Some(3.5));
    assert_eq!(debugger.changes().to_string(), "100:set V=3.5, 100:set K=5");
    assert!(
        debugger
            .happens("set Z=1".parse()?, Discard::Later)
            .is_err()
    );
    assert_eq!(debugger.known(), 160, "what is refused discards nothing");
    Ok(())
}

#[test]
fn portions_of_work_end_where_the_whole_does_and_can_be_given_up() -> Outcome {
    let mut debugger = debugger(BUSY, &titan())?;
    let when = When {
        condition: Some("N == 3"),
        hits: None,
    };
    let id = debugger.break_at_line(9, &when)?.id;
    debugger.go(Move::To(2000));
    let whole = debugger.go(Move::ReverseContinue);
    debugger.go(Move::To(2000));
    debugger.start(Move::ReverseContinue);
    let mut portions = 0;
    let mut done = 0;
    let stop = loop {
        match debugger.work(50) {
            Work::Stopped(stop) => break stop,
            Work::Going(progress) => {
                assert_eq!(debugger.now(), 2000, "it stands while it searches");
                assert!(progress.done >= done && progress.of == Some(2000));
                (portions, done) = (portions + 1, progress.done);
            }
        }
    };
    assert_eq!(stop, whole);
    assert!(portions > 5, "{portions}");
    // Given up, it stands where it was.
    debugger.go(Move::To(2000));
    debugger.start(Move::ReverseContinue);
    assert!(matches!(debugger.work(10), Work::Going(_)));
    debugger.cancel();
    assert_eq!((debugger.now(), debugger.is_going()), (2000, false));
    assert!(debugger.remove_breakpoint(id));
    // Forwards it stands where it has come to.
    debugger.start(Move::Continue);
    assert!(matches!(debugger.work(10), Work::Going(_)));
    assert_eq!(debugger.cancel().at, 2010);
    Ok(())
}

#[test]
fn a_plain_run_to_the_same_cycle_is_the_same_run() -> Outcome {
    // The reference itself: a run that is not stopped at each cycle.
    let robot = titan();
    let program = load("debugged.prg", BUSY, &robot)?;
    let mut run = Run::new(program, robot.clone())?.with_events(&EVENTS.parse()?)?;
    run.to_end(Limit::cycles(CYCLES - 1));
    let sights = reference(&robot, &EVENTS.parse()?)?;
    assert_eq!(Some(&sight(&run)), sights.last());
    Ok(())
}
