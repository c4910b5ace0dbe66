//! A session of a robot on servos: what reaches the robot, and what its viewers see.

use super::bench::Memory;
use super::page::Page;
use serde_json::{Value, json};
use tip_runtime::command::Port;
use tip_sim::{Event, Interpreter, Robot, Run};
use tip_view::live::{
    ClientRequest, DrivenSession, Driver, Order, Phase, Prepared, RobotState, Rules, Setup, Stage,
    Viewer,
};

const COUNTS: &str = "3.1\ncounts\nDEF_VAR N\nN = 0\nLOOP:\nN = N + 1\nGOTO LOOP:\nEND\n";

fn session_of(text: &str) -> DrivenSession {
    let robot = Robot::named("titan8").expect("it has a name");
    let setup = Setup::new("counts.prg", text.as_bytes(), robot);
    DrivenSession::new(setup, |_, events| events).expect("a program")
}

fn ask(session: &mut DrivenSession, request: Value, is_holder: bool) -> Value {
    let asked = ClientRequest::read(&request.to_string());
    let mut file = Memory {
        bytes: Vec::new(),
        refuses: false,
    };
    let answer = session.ask(&asked, is_holder, &mut file);
    serde_json::from_str(&answer.expect("the text is checked")).expect("JSON")
}

fn prepared(session: &mut DrivenSession) -> Box<Prepared> {
    match &mut session.take_orders()[..] {
        [Order::Prepare(prepared)] => prepared.clone(),
        other => panic!("{other:?}"),
    }
}

/// A run in the place of one on servos.
fn run_of(prepared: &Prepared) -> Run {
    let program = prepared.loaded.program.clone().expect("checked");
    let robot = Robot::named("titan8").expect("it has a name");
    Run::new(Interpreter::new(program), robot).expect("for this robot")
}

fn enter(session: &mut DrivenSession, phase: Phase) {
    let state = RobotState {
        phase,
        ..RobotState::new()
    };
    session.set_state(state, Stage::Driven);
}

fn cycle(session: &mut DrivenSession, run: &mut Run) {
    let cycle = run.cycle();
    session.take_cycle(cycle, &run.snapshot());
}

#[test]
fn only_keys_inputs_and_variables_reach_the_robot() {
    let mut session = session_of(COUNTS);
    let prepared = prepared(&mut session);
    let event = |event: &str| json!({"do": "event", "event": event});
    assert_eq!(ask(&mut session, event("key F"), true)["error"], "still");
    let run = run_of(&prepared);
    session.begin(run.clone(), &prepared);
    enter(&mut session, Phase::Running);
    for (request, error) in [
        (json!({"do": "step", "cycles": 1}), "forward"),
        (json!({"do": "go", "cycle": 0}), "forward"),
        (json!({"do": "speed", "times": 2}), "forward"),
        (json!({"do": "restart"}), "moving"),
        (event("push 1 2 3 for 4"), "forward"),
        (event("noise 0.1 0.1 seed 1"), "forward"),
        (event("touch on"), "forward"),
        (event("read fails"), "forward"),
        (event("write fails"), "forward"),
        (event("set NOBODY=1"), "impossible"),
    ] {
        assert_eq!(ask(&mut session, request.clone(), true)["error"], error);
        assert!(session.take_orders().is_empty(), "{request}");
    }
    for text in ["key F", "halt", "VR1=8", "set N=3"] {
        assert_eq!(ask(&mut session, event(text), false)["error"], "watching");
        assert!(session.take_orders().is_empty(), "{text}");
        assert_eq!(ask(&mut session, event(text), true)["ok"], true);
        assert_eq!(session.take_orders().len(), 1, "{text}");
    }
    ask(&mut session, event("VR1=8"), true);
    match &session.take_orders()[..] {
        [Order::Happen(event)] => assert_eq!(*event, Event::Sensor(Port::Knob(1), 8.0)),
        other => panic!("{other:?}"),
    }
    // The host has stopped the robot before it asks.
    assert_eq!(ask(&mut session, event("key 0x0D"), false)["ok"], true);
    assert!(session.take_orders().is_empty());
}

#[test]
fn viewers_follow_the_cycles_of_a_run_that_is_elsewhere() {
    let mut session = session_of(COUNTS);
    let prepared = prepared(&mut session);
    let (mut viewer, driver) = (Viewer::default(), Driver::new(Rules::default()));
    let mut page = Page::default();
    let mut look = |session: &DrivenSession| {
        let mut robot = Value::Null;
        while let Some(update) = session.update(&mut viewer, 7, &driver) {
            let update: Value = serde_json::from_str(&update).expect("JSON");
            match update["type"].as_str() {
                Some("robot") => robot = update,
                _ => page.take(&update),
            }
        }
        (page.cycles, robot)
    };
    let (cycles, robot) = look(&session);
    assert_eq!((cycles, &robot["phase"]), (1, &json!("ready")));
    let mut run = run_of(&prepared);
    session.begin(run.clone(), &prepared);
    enter(&mut session, Phase::Running);
    (0..50).for_each(|_| cycle(&mut session, &mut run));
    let (cycles, robot) = look(&session);
    assert_eq!((cycles, &robot["phase"]), (50, &json!("running")));
    assert_eq!(
        (&robot["driver"], &robot["stage"]),
        (&json!(false), &json!("driven"))
    );
    assert_eq!(look(&session), (50, Value::Null), "nothing is new");
}

#[test]
fn another_program_is_prepared_where_the_robot_does_not_move() {
    let mut session = session_of(COUNTS);
    let first = prepared(&mut session);
    session.begin(run_of(&first), &first);
    enter(&mut session, Phase::Left);
    let restart = json!({"do": "restart"});
    assert_eq!(
        ask(&mut session, restart.clone(), false)["error"],
        "watching"
    );
    session.file_changed(b"3.1\nanother\nEND\n");
    assert!(session.take_orders().is_empty(), "a file runs nothing");
    let unchecked = session.unchecked().expect("another text");
    let robot = Robot::named("titan8").expect("it has a name");
    session.checked(tip_view::live::TextChecker::new(robot).read(unchecked));
    assert_eq!(ask(&mut session, restart, true)["ok"], true);
    let next = prepared(&mut session);
    assert_eq!(next.loaded.source.text(), "3.1\nanother\nEND\n");
}

/// An input that nothing drives would stop the robot in the middle of its motion.
#[test]
fn a_program_that_reads_what_nothing_drives_is_not_prepared() {
    let robot = Robot::named("titan8").expect("it has a name");
    let text = b"3.1\nreads\nDEF_VAR V\nAD_IN VR1 V\nEND\n";
    let setup = Setup::new("reads.prg", text, robot);
    assert!(DrivenSession::new(setup, |_, events| events).is_err());
}

/// Before the start the page has the inputs with which the program will begin, so that its sticks show that they rest.
#[test]
fn sticks_rest_before_the_start() {
    let robot = Robot::named("titan8").expect("it has a name");
    let text = b"3.1\nreads\nDEF_VAR V\nAD_IN VR1 V\nEND\n";
    let setup = Setup::new("reads.prg", text, robot);
    let rests = |_: &_, _| "0:VR1=5".parse().expect("an event");
    let session = DrivenSession::new(setup, rests).expect("VR1 is driven");
    let (mut viewer, driver) = (Viewer::default(), Driver::new(Rules::default()));
    let updates = std::iter::from_fn(|| session.update(&mut viewer, 7, &driver));
    let updates = updates.map(|update| serde_json::from_str(&update).expect("JSON"));
    let updates: Vec<Value> = updates.collect();
    assert_eq!(updates[1]["log"]["event"], json!([[0], ["VR1=5"]]));
}
