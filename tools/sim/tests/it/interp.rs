//! One program of each kind of step, against a scripted robot.

mod equations;
mod script;

use script::Script;
use tip_runtime::fault::Fault;
use tip_runtime::model::titan8;
use tip_runtime::program::{End, Flow, Program};
use tip_sim::Interpreter;

const A: usize = 1;
const B: usize = 2;
/// Its first member.
const P: usize = 3;

/// An interpreter of these statements and an EXIT; they may use the variables A and B, and the positions P and Q. What
/// follows only assigns them, since a program that never does is not loaded.
fn interpreter(statements: &str) -> Interpreter {
    let behind = "EXIT\nA = 0\nB = 0\nTEACH_POSITION F1 P\nEND";
    let text =
        format!("3.1\nwritten by hand\nDEF_VAR A, B\nDEF_POS P, Q\n{statements}\n{behind}\n");
    let loaded = tip_lint::load("by_hand.prg", text.as_bytes(), &tipc::Options::default());
    let diagnostics = loaded.diagnostics;
    Interpreter::new(loaded.program.unwrap_or_else(|| panic!("{diagnostics:#?}")))
}

/// Runs the statements, and gives the steps that ran, in order.
fn path(statements: &str, script: &mut Script) -> (Interpreter, Vec<u32>) {
    let mut interpreter = interpreter(statements);
    let path = path_of(&mut interpreter, script);
    (interpreter, path)
}

fn path_of(interpreter: &mut Interpreter, script: &mut Script) -> Vec<u32> {
    let mut path = Vec::new();
    loop {
        path.push(interpreter.at());
        assert!(path.len() < 100, "runs forever: {path:?}");
        match interpreter.step(script) {
            Ok(Flow::Next | Flow::Wait) => {}
            Ok(Flow::ThreadEnd | Flow::Finished(_)) | Err(_) => return path,
        }
    }
}

fn scalars(interpreter: &Interpreter) -> Vec<Option<f64>> {
    let scalars = (0..).map_while(|i| interpreter.scalar(i));
    scalars.map(|(_, value)| value).collect()
}

fn value_of(interpreter: &Interpreter, name: &str) -> Option<f64> {
    (0..)
        .map_while(|i| interpreter.scalar(i))
        .find(|(scalar, _)| *scalar == name)
        .and_then(|(_, value)| value)
}

/// Steps: 0 IF, 1 and 2 its branch, 3 ELSEIF, 4 its branch, 5 ELSE, 6 its branch, 7 ENDIF, 8 END.
const BRANCHES: &str = "IF A == 1 THEN\nREM\nREM\nELSEIF A == 2 THEN\nREM\nELSE\nREM\nENDIF";

// clauses: 2.6 2.7 2.8 2.9 2.20
#[test]
fn each_branch_of_an_if_costs_its_own_cycles() {
    for (a, expected) in [
        (1.0, vec![0, 1, 2, 3, 5, 7, 8]),
        (2.0, vec![0, 3, 4, 5, 7, 8]),
        (3.0, vec![0, 3, 5, 6, 7, 8]),
    ] {
        let mut interpreter = interpreter(BRANCHES);
        interpreter.set_scalar(A, a);
        let path = path_of(&mut interpreter, &mut Script::default());
        assert_eq!(path, expected, "A = {a}");
    }
}

// clauses: 2.7 2.9 2.20
#[test]
fn an_elseif_reached_by_a_jump_counts_as_taken() {
    // Step 3 is the label, 4 the ELSEIF, 6 the ELSE, 8 the ENDIF.
    let jump = "IF 1 < 2 THEN\nGOTO L:\nREM\nL: ELSEIF A == 2 THEN\nREM\nELSE\nREM\nENDIF";
    let (_, path) = path(jump, &mut Script::default());
    assert_eq!(path, [0, 1, 3, 4, 6, 8, 9]);
}

// clauses: 2.12 2.13
#[test]
fn for_and_next_count_and_leave_the_last_value() {
    for (from, to, step, steps, last) in [
        (1, 3, 1.0, vec![0, 1, 1, 1, 2], Some(4.0)),
        (3, 1, -2.0, vec![0, 1, 1, 2], Some(-1.0)),
        (2, 1, 1.0, vec![0, 2], Some(2.0)),
        (1, 2, 0.0, vec![0], None),
    ] {
        let mut interpreter = interpreter(&format!("FOR A = {from} TO {to} STEP B\nNEXT A"));
        interpreter.set_scalar(B, step);
        let path = path_of(&mut interpreter, &mut Script::default());
        assert_eq!(path, steps, "FOR A = {from} TO {to} STEP {step}");
        assert_eq!(value_of(&interpreter, "A"), last);
    }
}

// clauses: 2.10 2.11 2.14
#[test]
fn loops_and_jumps_lead_where_they_say() {
    let loops =
        "A = 0\nWHILE A < 1\nA = 1\nWEND\nREPEAT\nA = 2\nUNTIL A >= 2\nIF A <> 2 GOTO L:\nL:";
    let (_, ran) = path(loops, &mut Script::default());
    assert_eq!(ran, [0, 1, 2, 3, 1, 4, 5, 6, 7, 8, 9]);
}

// clauses: 2.15 2.16
#[test]
fn subroutines_return_behind_their_call_and_nest_ten_deep() {
    // Steps: 0 GOSUB, 1 EXIT, 2 S, 3 IF, 4 RETURN, 5 T, 6 RETURN.
    let calls = "GOSUB S:\nEXIT\nS:\nIF 1 < 2 GOSUB T:\nRETURN\nT:\nRETURN";
    let (_, ran) = path(calls, &mut Script::default());
    assert_eq!(ran, [0, 2, 3, 5, 6, 4, 1]);

    let mut deep = interpreter("S:\nGOSUB S:");
    let mut script = Script::default();
    for _ in 0..10 {
        assert_eq!(deep.step(&mut script), Ok(Flow::Next));
        assert_eq!(deep.step(&mut script), Ok(Flow::Next));
    }
    assert_eq!(deep.step(&mut script), Ok(Flow::Next));
    assert_eq!(deep.step(&mut script), Err(Fault::TooDeep));

    let mut lost = interpreter("RETURN");
    assert_eq!(lost.step(&mut script), Err(Fault::InvalidReturn));
}

// clauses: 2.21 2.19
#[test]
fn the_first_fault_wins_and_changes_nothing() {
    for (statement, divisor, fault) in [
        // An operand comes before the domain, the domain before the left side.
        ("A += B / P.X", 0.0, Fault::Unassigned(2)),
        ("A += 1 / P.X", 0.0, Fault::Domain),
        ("A += 1 / P.X", 2.0, Fault::Unassigned(1)),
    ] {
        let mut interpreter = interpreter(statement);
        interpreter.set_scalar(P, divisor);
        let before = scalars(&interpreter);
        assert_eq!(interpreter.step(&mut Script::default()), Err(fault));
        assert_eq!(scalars(&interpreter), before);
        assert_eq!(interpreter.at(), 0);
    }
}

// clauses: 2.17 2.4
#[test]
fn a_pending_command_stays_on_its_step() {
    let mut script = Script {
        pending: 2,
        ..Script::default()
    };
    let (_, ran) = path("SLEEP 40", &mut script);
    assert_eq!(ran, [0, 0, 0, 1]);
    assert_eq!(script.commands, ["SLEEP  [40.0]"]);
}

// clauses: 2.17 7.33
#[test]
fn key_in_waits_for_a_key() {
    let mut interpreter = interpreter("KEY_IN");
    let mut script = Script::default();
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Wait));
    script.keys.push_back(b'A');
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Next));
    assert_eq!(interpreter.scalar(0), Some(("VAR_KEY", Some(65.0))));
}

// clauses: 7.47
#[test]
fn a_message_shows_values_and_fails_before_it_shows() {
    let mut script = Script::default();
    path("A = 0.25\nMESSAGE A is %A.1%", &mut script);
    assert_eq!(script.said, ["A is 0.2"]);

    let mut unassigned = interpreter("MESSAGE A is %A.1%");
    assert_eq!(unassigned.step(&mut script), Err(Fault::Unassigned(1)));
    assert_eq!(script.said.len(), 1);
}

// clauses: 7.17 7.18 7.32
#[test]
fn measurements_arrive_in_their_variables() {
    let measure = "TEACH_POSITION F1 P\nTEACH_ANGLE J12 A\nAD_IN ANTENNA B";
    let (interpreter, _) = path(measure, &mut Script::default());
    let values = ["P.X", "P.Y", "P.Z", "A", "B"].map(|name| value_of(&interpreter, name));
    assert_eq!(values, [1.0, 2.0, 3.0, 1.0, 2.5].map(Some));
}

// clauses: 5.1
#[test]
fn a_flag_can_be_negated() {
    for (flags, not, next) in [(true, "", 1), (true, "!", 2), (false, "!", 1)] {
        let mut interpreter = interpreter(&format!("IF {not}HALT_REQUEST THEN\nREM\nENDIF"));
        let mut script = Script {
            flags,
            ..Script::default()
        };
        assert_eq!(interpreter.step(&mut script), Ok(Flow::Next));
        assert_eq!(interpreter.at(), next);
    }
}

#[test]
fn reset_forgets_everything() {
    let (mut interpreter, _) = path("A = 1", &mut Script::default());
    interpreter.reset();
    assert_eq!(interpreter.at(), 0);
    assert_eq!(value_of(&interpreter, "A"), None);
}

#[test]
fn it_says_which_program_it_runs_and_where_the_steps_stand() {
    let interpreter = interpreter("A = 1");
    assert_eq!(interpreter.name(), "by_hand.prg");
    assert_eq!(interpreter.title(), "written by hand");
    assert_eq!(interpreter.signature(), titan8::MODEL.signature());
    let lines = [0, 1, 5, 6].map(|step| interpreter.line(step));
    assert_eq!(lines, [5, 6, 10, 0]);
}

// clauses: 2.18
#[test]
fn a_fault_of_the_robot_keeps_the_step() {
    let mut interpreter = interpreter("WAIT_NEAR F1");
    let mut script = Script {
        fault: Some(Fault::InvalidMode),
        ..Script::default()
    };
    assert_eq!(interpreter.step(&mut script), Err(Fault::InvalidMode));
    assert_eq!(interpreter.at(), 0);
    script.fault = None;
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Next));
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Finished(End::Exit)));
}
