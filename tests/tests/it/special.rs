//! SPECIAL commands of a user, written in Rust, called by a program that runs on either engine.

use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::console::{Bars, Console};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Program, Robot};
use tip_runtime::special::hand::HandSpecials;
use tip_runtime::special::{Call, Special};
use tip_sim::{Interpreter, Limit, Run};

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
#[derive(Clone, Debug, Default)]
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
                    values: &[Value::Absolute(1.0)],
                })
            }
            (15, [None, None]) => Ok(Poll::Done),
            _ => Err(Fault::Domain),
        }
    }
}

fn interpreted(source: &str, robot: tipc::Robot) -> Interpreter {
    let options = tipc::Options {
        robot,
        ..tipc::Options::default()
    };
    let loaded = tipc::load("Native", source.as_bytes(), &options);
    Interpreter::new(loaded.program.expect("it has no errors"))
}

/// The trace of a run with `special`, and whether lamp 1 shines at its end.
fn trace(
    program: impl Program + Clone + Send + 'static,
    special: impl Special + Clone + Send + 'static,
) -> (String, bool) {
    let robot = simulated("titan8").with_special(special);
    let run = Run::new(program, robot).expect("it is for TITAN VIII");
    let mut run = run.with_trace(false);
    run.to_end(Limit::NONE);
    (run.trace(), run.lamp(1))
}

fn simulated(name: &str) -> tip_sim::Robot {
    tip_sim::Robot::named(name).expect("it has that name")
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
        trace(interpreted(SOURCE, tipc::Robot::Titan8), Handler::default()),
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
    for (text, _) in [
        trace(Native::new(), ()),
        trace(interpreted(SOURCE, tipc::Robot::Titan8), ()),
    ] {
        assert_eq!(text.lines().last(), Some(expected));
    }
}

const BESIDE: &str = r#"3.1
A command beside those of the hand
SPECIAL 20 0 1
SPECIAL 11 1 2
SPECIAL 31 3
IF SPECIAL_FLAG9 GOTO DONE:
SPECIAL 99
DONE:
SLEEP 250
SPECIAL 20 0 0
END
"#;

tip_macros::tip!(
    Beside,
    r#"3.1
A command beside those of the hand
SPECIAL 20 0 1
SPECIAL 11 1 2
SPECIAL 31 3
IF SPECIAL_FLAG9 GOTO DONE:
SPECIAL 99
DONE:
SLEEP 250
SPECIAL 20 0 0
END
"#,
    robot = hand
);

/// What a console was asked to draw: graph, and number of bars.
#[derive(Debug, Default)]
struct Canvas(Vec<(u8, usize)>);

impl Console for Canvas {
    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        self.0.push((graph, bars.0.len()));
    }
}

/// Knows 31, which sets flag 9, and lights a lamp in the fifth cycle.
#[derive(Clone, Debug, Default)]
struct Own {
    cycles: u32,
}

impl Special for Own {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        let (31, [Some(3.0), None]) = (call.number, call.arguments) else {
            return Err(Fault::Domain);
        };
        robot.set_special_flag(9, true);
        Ok(Poll::Done)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.cycles += 1;
        if self.cycles == 5 {
            robot.command(&Command {
                op: Op::LampOn,
                hs: false,
                target: Target::None,
                values: &[Value::Absolute(1.0)],
            })?;
        }
        Ok(())
    }
}

// clauses: 5.1 7.43 7.48
#[test]
fn a_users_commands_stand_beside_those_of_the_hand() {
    fn check(program: impl Program + Clone + Send + 'static) {
        let robot = simulated("hand").with_special(HandSpecials::beside(Own::default()));
        let run = Run::new(program, robot).expect("it is for the hand");
        let mut run = run.with_trace(false).with_console(Canvas::default());
        run.to_end(Limit::NONE);
        let text = run.trace();
        let mut lines = text.lines();
        for expected in [
            r#"{"cycle":0,"step":0,"next":1,"cmd":["SPECIAL",null,20.0,0.0,1.0]}"#,
            r#"{"cycle":1,"step":1,"next":2,"cmd":["SPECIAL",null,11.0,1.0,2.0]}"#,
            r#"{"cycle":2,"step":2,"next":3,"cmd":["SPECIAL",null,31.0,3.0]}"#,
            r#"{"cycle":3,"step":3,"next":5}"#,
        ] {
            assert_eq!(lines.next(), Some(expected));
        }
        // SLEEP takes 125 cycles of 2 ms, then come the last SPECIAL and END.
        assert_eq!(lines.last(), Some(r#"{"end":"END","cycles":132}"#));
        assert!(run.lamp(1) && !run.lamp(0));
        // The nine joints at 0, 100 and 200 ms, then nothing.
        let canvas: &Canvas = run.console().expect("it was given");
        assert_eq!(canvas.0, [(0, 9), (0, 9), (0, 9), (0, 0)]);
    }
    check(Beside::new());
    check(interpreted(BESIDE, tipc::Robot::Hand));
}
