//! Records compared with lines written by hand from the trace's definition.

use super::*;
use crate::command::Op;
use crate::fault::Fault;
use crate::hardware::JointCommand;
use crate::model::titan8;
use crate::program::{Context, Flow, Signature};
use crate::record::Sample;

struct Variables(Vec<(&'static str, Option<f64>)>);

impl Program for Variables {
    fn signature(&self) -> Signature {
        titan8::MODEL.signature()
    }
    fn name(&self) -> &str {
        ""
    }
    fn title(&self) -> &str {
        ""
    }
    fn at(&self) -> u32 {
        0
    }
    fn step(&mut self, _: &mut dyn Context) -> Result<Flow, Fault> {
        Ok(Flow::Next)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        self.0.get(i).copied()
    }
    fn set_scalar(&mut self, i: usize, value: f64) {
        self.0[i].1 = Some(value);
    }
    fn line(&self, _: u32) -> u32 {
        0
    }
    fn reset(&mut self) {}
}

fn cycle(number: u64, step: u32, next: Option<u32>, program: &Variables) -> Cycle<'_> {
    Cycle {
        sub: 0,
        last: true,
        thread: None,
        step,
        next,
        program,
        sample: Sample {
            cycle: number,
            time: 0.0,
            joints_per_leg: 1,
            angles: &[0.0],
            commands: const { &[JointCommand::at(0.0)] },
            torques: &[],
            paws: &[],
            knobs: &[],
            antenna: 0.0,
        },
    }
}

fn line(act: impl FnOnce(&mut JsonLines<String>)) -> String {
    let program = Variables(std::vec![("VAR_KEY", None)]);
    let mut trace = JsonLines::new(String::new(), false);
    trace.begin(&program);
    act(&mut trace);
    trace.cycle(&cycle(3, 7, Some(8), &program));
    assert_eq!(trace.result(), Ok(()));
    trace.into_inner()
}

fn command_line(op: Op, hs: bool, target: Target, values: &[Value]) -> String {
    line(|trace| {
        trace.command(&Command {
            op,
            hs,
            target,
            values,
        });
    })
}

#[test]
fn a_step_with_nothing_to_say_is_three_keys() {
    assert_eq!(line(|_| {}), "{\"cycle\":3,\"step\":7,\"next\":8}\n");
}

// clauses: 2.18
#[test]
fn the_record_of_the_end_has_no_next_step() {
    let program = Variables(std::vec![("VAR_KEY", None)]);
    let mut trace = JsonLines::new(String::new(), false);
    trace.begin(&program);
    trace.cycle(&cycle(0, 0, None, &program));
    assert_eq!(trace.into_inner(), "{\"cycle\":0,\"step\":0}\n");
}

// clauses: 3.3 3.4
#[test]
fn set_holds_what_changed_bit_by_bit_in_declaration_order() {
    let mut program = Variables(std::vec![
        ("VAR_KEY", None),
        ("A", None),
        ("P.X", Some(0.0)),
        ("Q.J2", Some(4.0)),
    ]);
    let mut trace = JsonLines::new(String::new(), false);
    trace.begin(&program);
    program.0[3].1 = Some(0.1 + 0.2);
    program.0[2].1 = Some(-0.0);
    program.0[1].1 = Some(1.0);
    trace.cycle(&cycle(0, 0, Some(1), &program));
    // Assigned again with the value that it has: no change.
    trace.begin(&program);
    program.0[1].1 = Some(1.0);
    trace.cycle(&cycle(1, 1, Some(2), &program));
    trace.begin(&program);
    program.0[0].1 = Some(65.0);
    trace.cycle(&cycle(2, 2, Some(3), &program));
    assert_eq!(
        trace.into_inner(),
        "{\"cycle\":0,\"step\":0,\"next\":1,\"set\":{\"A\":1.0,\"P.X\":-0.0,\"Q.J2\":0.30000000000000004}}\n\
         {\"cycle\":1,\"step\":1,\"next\":2}\n\
         {\"cycle\":2,\"step\":2,\"next\":3,\"set\":{\"VAR_KEY\":65.0}}\n"
    );
}

// clauses: 7.35 7.47
#[test]
fn say_is_json_text() {
    assert_eq!(
        line(|trace| trace.say(&"a\tb\x07 \"q\" \\ あ")),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"say\":\"a\\tb\\u0007 \\\"q\\\" \\\\ あ\"}\n"
    );
    assert_eq!(
        line(|trace| trace.say(&"")),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"say\":\"\"}\n"
    );
}

// clauses: 7.36
#[test]
fn a_lamp_is_an_object() {
    assert_eq!(
        line(|trace| trace.lamp(4, true)),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"lamp\":{\"4\":true}}\n"
    );
    assert_eq!(
        line(|trace| trace.lamp(0, false)),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"lamp\":{\"0\":false}}\n"
    );
}

// clauses: 7.2
#[test]
fn a_command_stands_with_flag_target_and_values_as_evaluated() {
    assert_eq!(
        command_line(
            Op::Ptp,
            true,
            Target::Foot(1),
            &[
                Value::Absolute(391.0),
                Value::Relative(10.5),
                Value::Relative(-1e-7)
            ]
        ),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"cmd\":[\"PTP\",\"HS\",\"F1\",391.0,\"R10.5\",\"R-1e-7\"]}\n"
    );
}

// clauses: 7.5 7.26
#[test]
fn a_command_without_target_has_null_in_its_place() {
    assert_eq!(
        command_line(Op::AllStop, false, Target::None, &[]),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"cmd\":[\"ALL_STOP\",null]}\n"
    );
    assert_eq!(
        command_line(
            Op::SetOmegaMax,
            false,
            Target::Joint(2, 3),
            &[Value::Absolute(90.0)]
        ),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"cmd\":[\"SET_OMEGA_MAX\",\"J23\",90.0]}\n"
    );
    assert_eq!(
        command_line(Op::SetVMax, false, Target::All, &[Value::Absolute(1e21)]),
        "{\"cycle\":3,\"step\":7,\"next\":8,\"cmd\":[\"SET_V_MAX\",\"ALL\",1e21]}\n"
    );
}

#[test]
fn state_ends_the_record_in_sixteen_digits() {
    let program = Variables(std::vec![("VAR_KEY", None)]);
    let mut trace = JsonLines::new(String::new(), true);
    trace.begin(&program);
    let mut record = cycle(0, 0, Some(1), &program);
    record.sample.commands = &[];
    record.sample.angles = &[];
    trace.say(&"x");
    trace.cycle(&record);
    assert_eq!(
        trace.into_inner(),
        "{\"cycle\":0,\"step\":0,\"next\":1,\"say\":\"x\",\"state\":\"cbf29ce484222325\"}\n"
    );
}

// clauses: 8.1
#[test]
fn the_last_record_says_how_it_ended() {
    let last = |ending| {
        let mut trace = JsonLines::new(String::new(), true);
        trace.end(ending, 12);
        trace.into_inner()
    };
    assert_eq!(
        last(Ending::Program(End::End)),
        "{\"end\":\"END\",\"cycles\":12}\n"
    );
    assert_eq!(
        last(Ending::Program(End::Exit)),
        "{\"end\":\"EXIT\",\"cycles\":12}\n"
    );
    assert_eq!(
        last(Ending::Interrupted),
        "{\"end\":\"INTERRUPTED\",\"cycles\":12}\n"
    );
    assert_eq!(last(Ending::Limit), "{\"end\":\"LIMIT\",\"cycles\":12}\n");
    let emergency = Emergency {
        fault: Fault::OutOfReach(Target::Foot(1)),
        step: 4,
        cycle: 12,
        thread: None,
    };
    assert_eq!(
        last(Ending::Emergency(emergency)),
        "{\"end\":\"EMERGENCY\",\"error\":\"Out of reach F1\",\"kind\":\"RobotError\",\"step\":4,\"cycles\":12}\n"
    );
}

// clauses: 14.3 15.3 17.4
#[test]
fn a_record_of_a_later_step_has_its_number_and_its_thread() {
    let program = Variables(std::vec![("VAR_KEY", None)]);
    let mut trace = JsonLines::new(String::new(), true);
    for (sub, last) in [(0, false), (1, true)] {
        trace.begin(&program);
        trace.out(&"a\n");
        trace.cycle(&Cycle {
            sub,
            last,
            thread: (sub > 0).then_some("WATCH"),
            ..cycle(3, 7, None, &program)
        });
    }
    trace.end(
        Ending::Emergency(Emergency {
            fault: Fault::Domain,
            step: 9,
            cycle: 3,
            thread: Some(crate::emergency::ThreadName::new("WATCH")),
        }),
        3,
    );
    let text = trace.into_inner();
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines[0], r#"{"cycle":3,"step":7,"out":"a\n"}"#);
    let start = r#"{"cycle":3,"sub":1,"thread":"WATCH","step":7,"out":"a\n","state":""#;
    assert!(lines[1].starts_with(start), "{text}");
    assert_eq!(
        lines[2],
        r#"{"end":"EMERGENCY","error":"Domain error","kind":"RuntimeError","thread":"WATCH","step":9,"cycles":3}"#
    );
}

#[test]
fn a_writer_that_refuses_is_remembered() {
    struct Full;
    impl Write for Full {
        fn write_str(&mut self, _: &str) -> fmt::Result {
            Err(fmt::Error)
        }
    }
    let mut trace = JsonLines::new(Full, false);
    assert_eq!(trace.result(), Ok(()));
    trace.end(Ending::Limit, 0);
    assert_eq!(trace.result(), Err(fmt::Error));
}

#[test]
fn numbers_that_json_lacks_are_null() {
    let mut out = String::new();
    let all = [1.5, f64::NAN, -0.0, f64::INFINITY, f64::NEG_INFINITY, 1e300];
    assert_eq!(numbers(&mut out, &all), Ok(()));
    assert_eq!(out, "[1.5,null,-0.0,null,null,1e300]");
}
