//! SPECIAL commands of a user, written in Rust, behind a program that runs on either engine.

use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::{Program, Robot};
use tip_runtime::record::{Ending, JsonLines};
use tip_runtime::special::{Call, Special};
use tipc::interp::Interpreter;

const SOURCE: &str = r#"3.1
A native command
DEF_VAR TIMES
TIMES = 3
SPECIAL 14 TIMES -2.5
IF SPECIAL_FLAG7 GOTO DONE:
SPECIAL 99
DONE:
SPECIAL 15
END
"#;

tip_macros::tip!(
    Native,
    r#"3.1
A native command
DEF_VAR TIMES
TIMES = 3
SPECIAL 14 TIMES -2.5
IF SPECIAL_FLAG7 GOTO DONE:
SPECIAL 99
DONE:
SPECIAL 15
END
"#
);

/// 14 counts its first argument down, then sets flag 7 and lights a lamp; 15 takes no argument.
#[derive(Debug, Default)]
struct Handler {
    left: f64,
}

impl Special for Handler {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        match (call.number, call.arguments) {
            (14, [Some(times), Some(way)]) => {
                if call.first {
                    assert_eq!((times, way), (3.0, -2.5));
                    self.left = times;
                }
                self.left -= 1.0;
                if self.left > 0.0 {
                    return Ok(Poll::Pending);
                }
                robot.set_special_flag(7, true);
                robot.command(&Command {
                    op: Op::LampOn,
                    hs: false,
                    target: Target::None,
                    values: &[Value::absolute(1.0)],
                })
            }
            (15, [None, None]) => Ok(Poll::Done),
            _ => Err(Fault::Domain),
        }
    }
}

fn interpreted() -> Interpreter {
    let loaded = tipc::load("Native", SOURCE.as_bytes(), &tipc::Options::default());
    Interpreter::new(loaded.program.expect("it has no errors"))
}

/// The trace of a run with `special`, and whether lamp 1 shines at its end.
fn trace(program: impl Program, special: impl Special) -> (String, bool) {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    let mut machine =
        Machine::new(program, &titan8::MODEL, plant, (), special).expect("it is for TITAN VIII");
    let mut lines = JsonLines::new(String::new(), false);
    let ending = loop {
        match machine.cycle_traced(&mut lines) {
            Status::Running => {}
            Status::Finished(end) => break Ending::Program(end),
            Status::Emergency => {
                break Ending::Emergency(*machine.emergency().expect("it stopped"));
            }
        }
    };
    lines.end(ending, machine.cycles());
    let shines = machine.outputs().lamps[0] & 0b10 != 0;
    (lines.get_mut().clone(), shines)
}

// clauses: 2.17 5.1 7.43 7.48
#[test]
fn a_users_command_takes_arguments_and_cycles_and_sets_flags() {
    // Steps: 0 equation, 1 SPECIAL for three cycles, 2 IF, 4 label (3 is jumped over), 5 SPECIAL, 6 END.
    let expected = r#"{"cycle":0,"step":0,"next":1,"set":{"TIMES":3.0}}
{"cycle":1,"step":1,"next":1,"cmd":["SPECIAL",null,14.0,3.0,-2.5]}
{"cycle":2,"step":1,"next":1}
{"cycle":3,"step":1,"next":2}
{"cycle":4,"step":2,"next":4}
{"cycle":5,"step":4,"next":5}
{"cycle":6,"step":5,"next":6,"cmd":["SPECIAL",null,15.0]}
{"cycle":7,"step":6}
{"end":"END","cycles":8}
"#;
    for (text, shines) in [
        trace(Native::new(), Handler::default()),
        trace(interpreted(), Handler::default()),
    ] {
        assert_eq!(text, expected);
        assert!(shines);
    }
}

// clauses: 7.43 7.48
#[test]
fn without_native_code_every_number_is_unknown() {
    let expected =
        r#"{"end":"EMERGENCY","error":"Domain error","kind":"RuntimeError","step":1,"cycles":1}"#;
    for (text, _) in [trace(Native::new(), ()), trace(interpreted(), ())] {
        assert_eq!(text.lines().last(), Some(expected));
    }
}
