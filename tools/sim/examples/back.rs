//! Time to go back in a run of ten minutes.
//!
//! `cargo run --release -p tip-sim --example back` goes back with TITAN VIII and with the hand on its cylinder; `-- ROBOT PROGRAM.prg` with a
//! program of your own.

use std::env;
use std::error::Error;
use std::fs;
use std::time::{Duration, Instant};
use tip_runtime::plant::{Object, Scene, Shape};
use tip_sim::debug::{Debugger, Move, Reason, When};
use tip_sim::{Robot, load};

/// Ten minutes: ms.
const LONG: f64 = 600_000.0;

/// TITAN VIII lifts a foot, again and again.
const MARCH: &str = "3.1
march
DEF_VAR N
N = 0
STAND_UP 60
WAIT_INPOS ALL
L:
N += 1
PTP F1 R 0 0 20
WAIT_INPOS F1
PTP F1 R 0 0 -20
WAIT_INPOS F1
GOTO L:
END
";

/// The hand finds the floor, takes hold of its cylinder, lifts it and puts it back, again and again.
const GRASP: &str = "3.1
grasp
DEF_POS TIP
DEF_VAR GRIP
GRIP = 0
L:
PTP FLOOR 0 -155 0
PTP_ANGLE F1 -50 0 20
PTP_ANGLE F2 -50 0 20
PTP_ANGLE F3 -50 0 20
WAIT_INPOS ALL
DETECT_FLOOR ALL 1
TEACH_POSITION F1 TIP
GRIP = TIP.Y
GRIP += 40
PTP F1 -85 GRIP 0
PTP F2 85 GRIP 0
PTP F3 85 GRIP 0
WAIT_INPOS ALL
PTP F1 -56 GRIP 0
PTP F2 56 GRIP 0
PTP F3 56 GRIP 0
WAIT_INPOS ALL
TORQUE J11 200
TORQUE J21 100
TORQUE J31 100
SLEEP 700
SET_POSITION_STIFFNESS F1 0.4 0.4 0.4
SET_POSITION_STIFFNESS F2 0.2 0.2 0.2
SET_POSITION_STIFFNESS F3 0.2 0.2 0.2
REL_COMPLIANCE_POSITION F1 8 42 0
REL_COMPLIANCE_POSITION F2 -8 42 0
REL_COMPLIANCE_POSITION F3 -8 42 0
SLEEP 2000
REL_COMPLIANCE_POSITION F1 0 -42 0
REL_COMPLIANCE_POSITION F2 0 -42 0
REL_COMPLIANCE_POSITION F3 0 -42 0
SLEEP 2000
PTP F1 -85 GRIP 0
PTP F2 85 GRIP 0
PTP F3 85 GRIP 0
WAIT_INPOS ALL
GOTO L:
END
";

/// An upright cylinder, 100 mm across, 60 mm high: its side is a box in the hand's plane.
const CYLINDER: Object = Object {
    shape: Shape::Box {
        width: 100.0,
        height: 60.0,
    },
    mass: 0.2,
    friction: 0.8,
    x: 0.0,
    y: None,
    angle: 0.0,
};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match &arguments[..] {
        [] => {
            measure("titan8", MARCH)?;
            measure("hand", GRASP)
        }
        [robot, program] => measure(robot, &fs::read_to_string(program)?),
        _ => Err("usage: back [ROBOT PROGRAM.prg]".into()),
    }
}

fn measure(robot: &str, text: &str) -> Result<(), Box<dyn Error>> {
    let mut robot = Robot::named(robot)?;
    if robot.description().body.is_none() {
        let mut scene = Scene::EMPTY;
        scene.objects[0] = Some(CYLINDER);
        robot = robot.with_scene(&scene)?;
    }
    let program = load("long.prg", text, &robot).map_err(|error| error.to_string())?;
    let mut debugger = Debugger::new(program.program().clone(), &robot)?;
    let last = (LONG / debugger.run().period()) as u64;
    let started = Instant::now();
    let stop = debugger.go(Move::To(last));
    let run = started.elapsed();
    println!("{}: {} cycles in {run:.2?}", robot.name(), stop.at);
    if stop.at < last {
        return Err("the run ends before ten minutes are over".into());
    }
    step_back(&mut debugger, stop.at);
    line_breakpoint(&mut debugger, stop.at)?;
    condition(&mut debugger, stop.at, run)
}

/// A step back from places all over the run.
fn step_back(debugger: &mut Debugger, last: u64) {
    let mut times: Vec<Duration> = (1..=1000)
        .map(|place| {
            debugger.go(Move::To(last * place / 1000));
            let started = Instant::now();
            debugger.go(Move::StepBack);
            started.elapsed()
        })
        .collect();
    times.sort();
    let (median, p99) = (times[times.len() / 2], times[times.len() * 99 / 100]);
    let worst = times.last().copied().unwrap_or_default();
    println!("  step back: median {median:.2?}, p99 {p99:.2?}, worst {worst:.2?}");
}

/// Over all of the run, to the line of its first step.
fn line_breakpoint(debugger: &mut Debugger, last: u64) -> Result<(), Box<dyn Error>> {
    debugger.go(Move::To(0));
    let id = debugger
        .break_at_line(debugger.line(), &When::default())?
        .id;
    debugger.go(Move::To(last));
    // A later pass of it would not be over all of the run.
    let mut longest = Duration::ZERO;
    while debugger.now() > 0 {
        let started = Instant::now();
        debugger.go(Move::ReverseContinue);
        longest = longest.max(started.elapsed());
    }
    println!("  reverse continue to the line of the first step: {longest:.2?}");
    debugger.remove_breakpoint(id);
    Ok(())
}

/// A condition that never holds is asked at every step, all the way back.
fn condition(debugger: &mut Debugger, last: u64, run: Duration) -> Result<(), Box<dyn Error>> {
    let when = When {
        condition: Some("CYCLE < 0"),
        hits: None,
    };
    let lines: Vec<u32> = debugger
        .program()
        .steps()
        .iter()
        .map(|step| step.line)
        .collect();
    for line in lines {
        debugger.break_at_line(line, &when)?;
    }
    debugger.go(Move::To(last));
    let started = Instant::now();
    let stop = debugger.go(Move::ReverseContinue);
    assert_eq!(stop.reason, Reason::Start);
    let back = started.elapsed();
    let share = back.as_secs_f64() / run.as_secs_f64();
    println!("  reverse continue on conditions: {back:.2?}, {share:.2} of the run");
    Ok(())
}
