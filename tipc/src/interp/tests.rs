//! One program of each kind of step, against a scripted robot.

mod equations;
mod script;

use super::Interpreter;
use crate::fixture::{argument, compare, constant, program, read, scalar};
use crate::program::{
    Action, Arithmetic, Condition, End, Flag, MessagePart, Op, Port, Relation, ScalarExpression,
    Target, Teach, VariableKind,
};
use script::Script;
use tip_runtime::fault::Fault;
use tip_runtime::model::titan8;
use tip_runtime::program::{Flow, Program};

const A: usize = 1;
const B: usize = 2;
const P: usize = 3;
const VARIABLES: &[(&str, VariableKind)] = &[
    ("A", VariableKind::Var),
    ("B", VariableKind::Var),
    ("P", VariableKind::Pos),
    ("Q", VariableKind::Pos),
];

/// Runs the actions, an END behind them, and gives the steps that ran, in order.
fn path(actions: Vec<Action>, script: &mut Script) -> (Interpreter, Vec<u32>) {
    let mut interpreter = interpreter(actions);
    let mut path = Vec::new();
    loop {
        path.push(interpreter.at());
        assert!(path.len() < 100, "runs forever: {path:?}");
        match interpreter.step(script) {
            Ok(Flow::Next | Flow::Wait) => {}
            Ok(Flow::Finished(_)) | Err(_) => return (interpreter, path),
        }
    }
}

fn interpreter(mut actions: Vec<Action>) -> Interpreter {
    actions.push(Action::Finish(End::End));
    Interpreter::new(program(VARIABLES, actions))
}

fn set(variable: usize, value: f64) -> Action {
    Action::SetScalar {
        target: scalar(variable),
        update: None,
        value: ScalarExpression::Operand(constant(value)),
    }
}

fn value_of(interpreter: &Interpreter, name: &str) -> Option<f64> {
    (0..)
        .map_while(|i| interpreter.scalar(i))
        .find(|(scalar, _)| *scalar == name)
        .and_then(|(_, value)| value)
}

fn a_is(relation: Relation, value: f64) -> Condition {
    compare(read(A), relation, constant(value))
}

/// IF A == 1 … ELSEIF A == 2 … ELSE … ENDIF, each branch one step.
fn branches() -> Vec<Action> {
    vec![
        Action::If {
            condition: a_is(Relation::Eq, 1.0),
            otherwise: 3,
        },
        Action::Nothing,
        Action::Nothing,
        Action::ElseIf {
            condition: a_is(Relation::Eq, 2.0),
            otherwise: 5,
        },
        Action::Nothing,
        Action::Else { end: 7 },
        Action::Nothing,
        Action::Nothing,
    ]
}

// clauses: 2.6 2.7 2.8 2.9 2.20
#[test]
fn each_branch_of_an_if_costs_its_own_cycles() {
    for (a, expected) in [
        (1.0, vec![0, 1, 2, 3, 5, 7, 8]),
        (2.0, vec![0, 3, 4, 5, 7, 8]),
        (3.0, vec![0, 3, 5, 6, 7, 8]),
    ] {
        let mut interpreter = interpreter(branches());
        interpreter.scalars[A] = Some(a);
        let mut script = Script::default();
        let mut path = vec![0];
        while let Ok(Flow::Next) = interpreter.step(&mut script) {
            path.push(interpreter.at());
        }
        assert_eq!(path, expected, "A = {a}");
    }
}

// clauses: 2.7 2.9 2.20
#[test]
fn an_elseif_reached_by_a_jump_counts_as_taken() {
    let mut actions = branches();
    actions[0] = Action::Goto { to: 3 };
    let (_, path) = path(actions, &mut Script::default());
    assert_eq!(path, [0, 3, 5, 7, 8]);
}

// clauses: 2.12 2.13
#[test]
fn for_and_next_count_and_leave_the_last_value() {
    let loop_of = |from, to, step| {
        vec![
            Action::For {
                variable: scalar(A),
                from: constant(from),
                to: constant(to),
                step: constant(step),
                exit: 2,
            },
            Action::Next {
                variable: scalar(A),
                to: constant(to),
                step: constant(step),
                body: 1,
            },
        ]
    };
    for (from, to, step, steps, last) in [
        (1.0, 3.0, 1.0, vec![0, 1, 1, 1, 2], Some(4.0)),
        (3.0, 1.0, -2.0, vec![0, 1, 1, 2], Some(-1.0)),
        (2.0, 1.0, 1.0, vec![0, 2], Some(2.0)),
        (1.0, 2.0, 0.0, vec![0], None),
    ] {
        let (interpreter, path) = path(loop_of(from, to, step), &mut Script::default());
        assert_eq!(path, steps, "FOR A = {from} TO {to} STEP {step}");
        assert_eq!(value_of(&interpreter, "A"), last);
    }
}

// clauses: 2.10 2.11 2.14
#[test]
fn loops_and_jumps_lead_where_they_say() {
    let (_, ran) = path(
        vec![
            set(A, 0.0),
            Action::While {
                condition: a_is(Relation::Lt, 1.0),
                exit: 4,
            },
            set(A, 1.0),
            Action::Goto { to: 1 },
            Action::Nothing,
            set(A, 2.0),
            Action::Until {
                condition: a_is(Relation::Ge, 2.0),
                back: 4,
            },
            Action::IfGoto {
                condition: a_is(Relation::Ne, 2.0),
                to: 0,
            },
        ],
        &mut Script::default(),
    );
    assert_eq!(ran, [0, 1, 2, 3, 1, 4, 5, 6, 7, 8]);
}

// clauses: 2.15 2.16
#[test]
fn subroutines_return_behind_their_call_and_nest_ten_deep() {
    let (_, ran) = path(
        vec![
            Action::Gosub { to: 2 },
            Action::Finish(End::Exit),
            Action::IfGosub {
                condition: compare(constant(1.0), Relation::Lt, constant(2.0)),
                to: 4,
            },
            Action::Return,
            Action::Return,
        ],
        &mut Script::default(),
    );
    assert_eq!(ran, [0, 2, 4, 3, 1]);

    let mut deep = interpreter(vec![Action::Gosub { to: 0 }]);
    let mut script = Script::default();
    for _ in 0..10 {
        assert_eq!(deep.step(&mut script), Ok(Flow::Next));
    }
    assert_eq!(deep.step(&mut script), Err(Fault::TooDeep));

    let mut lost = interpreter(vec![Action::Return]);
    assert_eq!(lost.step(&mut script), Err(Fault::InvalidReturn));
}

// clauses: 2.21 2.19
#[test]
fn the_first_fault_wins_and_changes_nothing() {
    let update = |value| Action::SetScalar {
        target: scalar(A),
        update: Some(Arithmetic::Add),
        value,
    };
    let divide = |left, right| ScalarExpression::Binary {
        left,
        operation: Arithmetic::Div,
        right,
    };
    for (value, fault) in [
        // An operand comes before the domain, the domain before the left side.
        (divide(read(B), constant(0.0)), Fault::Unassigned(2)),
        (divide(constant(1.0), constant(0.0)), Fault::Domain),
        (divide(constant(1.0), constant(2.0)), Fault::Unassigned(1)),
    ] {
        let mut interpreter = interpreter(vec![update(value)]);
        let before = interpreter.scalars.clone();
        assert_eq!(interpreter.step(&mut Script::default()), Err(fault));
        assert_eq!(interpreter.scalars, before);
        assert_eq!(interpreter.at(), 0);
    }
}

// clauses: 2.17 2.4
#[test]
fn a_pending_command_stays_on_its_step() {
    let command = Action::Command {
        op: Op::Sleep,
        hs: false,
        target: Target::None,
        arguments: vec![argument(40.0)],
    };
    let mut script = Script {
        pending: 2,
        ..Script::default()
    };
    let (_, ran) = path(vec![command], &mut script);
    assert_eq!(ran, [0, 0, 0, 1]);
    assert_eq!(script.commands, ["SLEEP  [40.0]"]);
}

// clauses: 2.17 7.33
#[test]
fn key_in_waits_for_a_key() {
    let mut interpreter = interpreter(vec![Action::KeyIn { into: scalar(0) }]);
    let mut script = Script::default();
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Wait));
    script.keys.push_back(b'A');
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Next));
    assert_eq!(interpreter.scalar(0), Some(("VAR_KEY", Some(65.0))));
}

// clauses: 7.47
#[test]
fn a_message_shows_values_and_fails_before_it_shows() {
    let message = Action::Message {
        parts: vec![
            MessagePart::Text("A is ".to_owned()),
            MessagePart::Value {
                scalar: scalar(A),
                decimals: 1,
            },
        ],
    };
    let mut script = Script::default();
    path(vec![set(A, 0.25), message.clone()], &mut script);
    assert_eq!(script.said, ["A is 0.2"]);

    let mut unassigned = interpreter(vec![message]);
    assert_eq!(unassigned.step(&mut script), Err(Fault::Unassigned(1)));
    assert_eq!(script.said.len(), 1);
}

// clauses: 7.17 7.18 7.32
#[test]
fn measurements_arrive_in_their_variables() {
    let (interpreter, _) = path(
        vec![
            Action::TeachStruct {
                what: Teach::Position,
                target: Target::Foot(1),
                into: P,
            },
            Action::TeachScalar {
                what: Teach::Angle,
                target: Target::Joint(1, 2),
                into: scalar(A),
            },
            Action::AdIn {
                port: Port::Antenna,
                into: scalar(B),
            },
        ],
        &mut Script::default(),
    );
    let values = ["P.X", "P.Y", "P.Z", "A", "B"].map(|name| value_of(&interpreter, name));
    assert_eq!(values, [1.0, 2.0, 3.0, 1.0, 2.5].map(Some));
}

// clauses: 5.1
#[test]
fn a_flag_can_be_negated() {
    for (flags, negated, next) in [(true, false, 1), (true, true, 2), (false, true, 1)] {
        let mut interpreter = interpreter(vec![
            Action::If {
                condition: Condition::Flag {
                    flag: Flag::HaltRequest,
                    negated,
                },
                otherwise: 2,
            },
            Action::Nothing,
            Action::Nothing,
        ]);
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
    let (mut interpreter, _) = path(vec![set(A, 1.0)], &mut Script::default());
    interpreter.reset();
    assert_eq!(interpreter.at(), 0);
    assert_eq!(value_of(&interpreter, "A"), None);
}

#[test]
fn it_says_which_program_it_runs_and_where_the_steps_stand() {
    let interpreter = interpreter(vec![set(A, 1.0)]);
    assert_eq!(interpreter.name(), "by_hand.prg");
    assert_eq!(interpreter.title(), "built by hand");
    assert_eq!(interpreter.signature(), titan8::MODEL.signature());
    let lines = [0, 1, 2].map(|step| interpreter.line(step));
    assert_eq!(lines, [3, 4, 0]);
}

// clauses: 2.18
#[test]
fn a_fault_of_the_robot_keeps_the_step() {
    let mut interpreter = interpreter(vec![Action::Command {
        op: Op::WaitNear,
        hs: false,
        target: Target::Foot(1),
        arguments: Vec::new(),
    }]);
    let mut script = Script {
        fault: Some(Fault::InvalidMode),
        ..Script::default()
    };
    assert_eq!(interpreter.step(&mut script), Err(Fault::InvalidMode));
    assert_eq!(interpreter.at(), 0);
    script.fault = None;
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Next));
    assert_eq!(interpreter.step(&mut script), Ok(Flow::Finished(End::End)));
}
