//! Tests of T.I.P. 3.2 beyond the language cases: native code that shares variables, pauses, a program that starts
//! again, set points of ideal joints, and that speed changes no program without a clock.

use std::fs;
use tip_runtime::command::Poll;
use tip_runtime::fault::Fault;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::{Program, Robot, SpecialVariable};
use tip_runtime::special::{Call, Special};
use tip_sim::{Interpreter, Limit, Plant, Run};
use tip_tests::{cases, root};

const SHARING: &str = "3.2
Native code shares variables
DEF_VAR A
A = VAR_SPECIAL_0
SPECIAL 40
A = VAR_SPECIAL_0
VAR_SPECIAL_1 = 7
A = JNT_SPECIAL_3.J2
A = POS_SPECIAL_2.Z
END
";

tip_macros::tip!(
    Sharer,
    "3.2
Native code shares variables
DEF_VAR A
A = VAR_SPECIAL_0
SPECIAL 40
A = VAR_SPECIAL_0
VAR_SPECIAL_1 = 7
A = JNT_SPECIAL_3.J2
A = POS_SPECIAL_2.Z
END
"
);

/// Counts cycles in one variable, copies a second to a third, and tries to break a fourth.
#[derive(Clone, Debug, Default)]
struct Sharing {
    cycles: f64,
}

impl Special for Sharing {
    fn poll(&mut self, call: Call, _: &mut dyn Robot) -> Result<Poll, Fault> {
        match call.number {
            40 => Ok(Poll::Done),
            _ => Err(Fault::Domain),
        }
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.cycles += 1.0;
        let copied = robot.special_variable(SpecialVariable::Var(1));
        let counted = robot.set_special_variable(SpecialVariable::Var(0), self.cycles);
        assert_eq!(counted.is_ok(), self.cycles > 1.0, "SPECIAL is in cycle 1");
        let _ = robot.set_special_variable(SpecialVariable::Joint(3, 1), copied);
        let broken = robot.set_special_variable(SpecialVariable::Position(2, 2), f64::NAN);
        assert!(broken.is_err());
        Ok(())
    }
}

// clauses: 13.3
#[test]
fn native_code_shares_variables_from_its_first_special_on() {
    let expected = r#"{"cycle":0,"step":0,"next":1,"set":{"A":0.0}}
{"cycle":1,"step":1,"next":2,"set":{"VAR_SPECIAL_0":2.0},"cmd":["SPECIAL",null,40.0]}
{"cycle":2,"step":2,"next":3,"set":{"VAR_SPECIAL_0":3.0,"A":2.0}}
{"cycle":3,"step":3,"next":4,"set":{"VAR_SPECIAL_0":4.0,"VAR_SPECIAL_1":7.0,"JNT_SPECIAL_3.J2":7.0}}
{"cycle":4,"step":4,"next":5,"set":{"VAR_SPECIAL_0":5.0,"A":7.0}}
{"cycle":5,"step":5,"next":6,"set":{"VAR_SPECIAL_0":6.0,"A":0.0}}
{"cycle":6,"step":6}
{"end":"END","cycles":7}
"#;
    fn trace(program: impl Program + Clone + Send + 'static) -> String {
        let robot = titan8().with_special(Sharing::default());
        let run = Run::new(program, robot).expect("it is for TITAN VIII");
        let mut run = run.with_trace(false);
        run.to_end(Limit::NONE);
        run.trace()
    }
    assert_eq!(trace(Sharer::new()), expected);
    assert_eq!(trace(interpreted(SHARING)), expected);
}

// clauses: 13.1 13.3
#[test]
fn a_host_reaches_the_special_variables_that_a_program_names_and_no_constant() {
    let mut program = interpreted("3.2\nx\nDEFINE C 5\nVAR_SPECIAL_0 = C\nSLEEP C\nEND\n");
    assert_eq!(program.get("VAR_SPECIAL_0"), Ok(Some(0.0)));
    assert_eq!(program.set("VAR_SPECIAL_0", 2.0), Ok(()));
    assert_eq!(program.get("VAR_SPECIAL_0"), Ok(Some(2.0)));
    for name in ["VAR_SPECIAL_1", "C", "@TIMER0"] {
        assert!(program.get(name).is_err(), "{name}");
    }
}

// clauses: 14.1
#[test]
fn the_timers_of_a_paused_program_stand() {
    let program = interpreted("3.2\nx\nDEF_VAR A\nSTART_TIMER 0\nLOOP:\nA = @TIMER0\nGOTO\nEND\n");
    let mut machine = machine(program);
    for _ in 0..3 {
        machine.cycle();
    }
    assert_eq!(machine.program().get("A"), Ok(Some(40.0)));
    machine.pause();
    for _ in 0..10 {
        machine.cycle();
    }
    machine.resume();
    for _ in 0..3 {
        machine.cycle();
    }
    assert_eq!(machine.program().get("A"), Ok(Some(100.0)));
}

// clauses: 14.1 14.2 15.3 16.1 16.2 16.3
#[test]
fn a_program_that_starts_again_finds_nothing_of_its_last_run() {
    let program = interpreted(
        "3.2
x
DEF_VAR A
A = @TIMER0
PTP_ANGLE J11 30
START_TIMER 0
TIP_SPEED_UP 9
START_THREAD T:
SET_LIMIT J11 -1 29
LOCK ALL
SLEEP 20
SLEEP 20
GOTO LAST:
THREAD T:
SLEEP 1000
THREADEND
LAST: END
",
    );
    let mut machine = machine(program);
    // It ends in cycle 6.
    for _ in 0..6 {
        assert_eq!(machine.cycle(), Status::Running);
    }
    machine.restart();
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.program().get("A"), Ok(Some(0.0)));
    // One step a cycle: A, PTP_ANGLE, START_TIMER, TIP_SPEED_UP.
    for at in 2..5 {
        assert_eq!(machine.cycle(), Status::Running);
        assert_eq!(machine.program().at(), at);
    }
    assert_eq!(machine.cycle(), Status::Running);
}

// clauses: 14.3
#[test]
fn the_state_stands_in_the_last_record_of_a_cycle() {
    let program = interpreted(
        "3.2
x
DEF_VAR A
TIP_SPEED_UP 3
START_THREAD T:
A = 1; A = 2; A = 3; A = 4; A = 5
EXIT
THREAD T:
A = 10
THREADEND
END
",
    );
    let mut run = Run::new(program, titan8())
        .expect("it is for TITAN VIII")
        .with_trace(true);
    run.to_end(Limit::NONE);
    let trace = run.trace();
    let cycle = |record: &str| {
        let (_, rest) = record.split_once("\"cycle\":")?;
        Some(rest.split_once(',')?.0.to_owned())
    };
    let records: Vec<&str> = trace.lines().collect();
    assert!(records.len() > 8, "{trace}");
    for pair in records.windows(2) {
        let is_last = cycle(pair[0]) != cycle(pair[1]);
        assert_eq!(pair[0].contains("\"state\""), is_last, "{}", pair[0]);
    }
}

// clauses: 16.1
#[test]
fn the_set_point_of_ideal_joints_takes_its_target_in_that_cycle() {
    let program = interpreted(
        "3.2
x
DEF_VAR A
DIRECT J11
PTP_ANGLE J11 30
A = @AGL_J11
REL_PTP_ANGLE J11 -50
A = @AGL_J11
TRAJECTORY J11
PTP_ANGLE J11 0
A = @AGL_J11
DIRECT F2
PTP F2 391 281 -180
IF !INPOS_F2 GOTO BAD:
A = 1000
BAD: END
",
    );
    let robot = titan8().with_plant(Plant::Echo);
    let mut run = Run::new(program, robot)
        .expect("it is for TITAN VIII")
        .with_trace(false);
    run.to_end(Limit::NONE);
    let trace = run.trace();
    let values: Vec<f64> = trace
        .lines()
        .filter_map(|record| {
            record
                .split_once("\"A\":")?
                .1
                .split_once('}')?
                .0
                .parse()
                .ok()
        })
        .collect();
    let [direct, relative, trajectory, in_position] = values[..] else {
        panic!("{trace}");
    };
    assert_eq!((direct, relative, in_position), (30.0, -20.0, 1000.0));
    // From rest at 360 deg/s² for a cycle of 20 ms.
    assert!(-20.0 < trajectory && trajectory < -19.8, "{trajectory}");
}

/// Programs without clocks, keys, sensors and threads.
const STEADY: &[&str] = &["arithmetic", "control", "equations", "structure"];

// clauses: 14.2
#[test]
fn programs_without_a_clock_take_the_same_steps_at_every_speed() {
    let folder = root().join("cases");
    let mut compared = 0;
    for case in cases(&folder) {
        let area = case.split('/').next().unwrap_or_default();
        let Ok(source) = fs::read_to_string(folder.join(format!("{case}.prg"))) else {
            continue;
        };
        let uses = ["KEY", "KB_HIT", "HALT_REQUEST", "SLEEP", "@TIMER", "THREAD"];
        if !STEADY.contains(&area) || uses.iter().any(|word| source.contains(word)) {
            continue;
        }
        let Some(one) = steps(&source, 1) else {
            continue;
        };
        for speed in [2, 7, 255] {
            assert_eq!(
                steps(&source, speed).as_ref(),
                Some(&one),
                "{case} at {speed}"
            );
        }
        compared += 1;
    }
    assert!(compared > 40, "{compared}");
}

/// Returns the steps of a program in 3.2, how it ends, and what they set and say; `None` if it does not load or end.
fn steps(source: &str, speed: u32) -> Option<Vec<String>> {
    let (_, rest) = source.split_once('\n')?;
    let (title, rest) = rest.split_once('\n')?;
    let source = format!("3.2\n{title}\nTIP_SPEED_UP {speed}\n{rest}");
    let loaded = tipc::load("steady", source.as_bytes(), &tipc::Options::default());
    let run = Run::new(Interpreter::new(loaded.program?), titan8()).ok()?;
    let mut run = run.with_trace(false);
    run.to_end(Limit::cycles(2_000));
    let trace = run.trace();
    if trace.contains("\"LIMIT\"") {
        return None;
    }
    // The records of steps without their cycles; the end without its count of them.
    let records = trace.lines().skip(1).map(|record| {
        let from = record.find("\"step\"").unwrap_or_default();
        let to = record.find("\"cycles\"").unwrap_or(record.len());
        record[from.min(to)..to].to_owned()
    });
    Some(records.collect())
}

fn titan8() -> tip_sim::Robot {
    tip_sim::Robot::named("titan8").expect("it has that name")
}

fn interpreted(source: &str) -> Interpreter {
    let loaded = tipc::load("later", source.as_bytes(), &tipc::Options::default());
    Interpreter::new(loaded.program.expect("it loads"))
}

fn machine(program: Interpreter) -> Machine<Interpreter, SimulatedPlant<4, 3>, 4, 3> {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    Machine::new(program, &titan8::MODEL, plant).expect("it is for TITAN VIII")
}
