//! Several steps in a cycle: TIP_SPEED_UP, threads, timers, variables of native code.

use super::*;
use crate::program::SpecialVariable;
use crate::record::{Ending, JsonLines};
use crate::special::Call;
use std::string::String;
use std::{format, vec};

/// Action of a step in a test.
#[derive(Clone, Copy)]
enum Do {
    Nop,
    /// Adds 1 to `A`.
    Count,
    Say(&'static str),
    Append(&'static str),
    Ask(Op, Target, &'static [f64]),
    Start(u8),
    Stop(u8),
    Wait(u8),
    /// Stores a timer in `A`.
    Time(u8),
    ReadVr1,
    Fail,
    Key,
    Jump(u32),
    ThreadEnd,
    End,
}

/// A program of a main part and threads: `steps[0]` is the main part. Steps of part n count from 100 n.
#[derive(Clone)]
struct Parts {
    parts: &'static [&'static [Do]],
    at: [u32; 8],
    selected: u8,
    scalars: [(&'static str, Option<f64>); 3],
}

const NAMES: [&str; 3] = ["", "ONE", "TWO"];

impl Program for Parts {
    fn signature(&self) -> Signature {
        titan8::MODEL.signature()
    }
    fn name(&self) -> &str {
        "parts"
    }
    fn title(&self) -> &str {
        ""
    }
    fn at(&self) -> u32 {
        self.at[usize::from(self.selected)]
    }
    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let part = usize::from(self.selected);
        let at = self.at[part];
        match self.parts[part][at as usize - 100 * part] {
            Do::Nop => {}
            Do::Count => self.scalars[2].1 = Some(self.scalars[2].1.unwrap_or(0.0) + 1.0),
            Do::Say(text) => cx.message(&text),
            Do::Append(text) => cx.append(&text),
            Do::Ask(op, target, values) => {
                let values: Vec<_> = values.iter().copied().map(Value::Absolute).collect();
                let command = Command {
                    op,
                    hs: false,
                    target,
                    values: &values,
                };
                if cx.command(&command)? == Poll::Pending {
                    return Ok(Flow::Wait);
                }
            }
            Do::Start(thread) => cx.start_thread(thread)?,
            Do::Stop(thread) => cx.stop_thread(thread),
            Do::Wait(thread) => {
                if cx.wait_thread(thread)? == Poll::Pending {
                    return Ok(Flow::Wait);
                }
            }
            Do::Time(n) => self.scalars[2].1 = Some(cx.timer(n)),
            Do::ReadVr1 => drop(cx.analog(crate::command::Port::Knob(1))?),
            Do::Fail => return Err(Fault::TooDeep),
            Do::Key => match cx.key() {
                Some(key) => self.scalars[0].1 = Some(f64::from(key)),
                None => return Ok(Flow::Wait),
            },
            Do::Jump(to) => {
                self.at[part] = to;
                return Ok(Flow::Next);
            }
            Do::ThreadEnd => return Ok(Flow::ThreadEnd),
            Do::End => return Ok(Flow::Finished(End::End)),
        }
        self.at[part] = at + 1;
        Ok(Flow::Next)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        self.scalars.get(i).copied()
    }
    fn set_scalar(&mut self, i: usize, value: f64) {
        self.scalars[i].1 = Some(value);
    }
    fn line(&self, step: u32) -> u32 {
        step + 3
    }
    fn reset(&mut self) {
        *self = parts(self.parts);
    }
    fn thread(&self, n: u8) -> Option<(&str, u32)> {
        let n = usize::from(n);
        (n < self.parts.len()).then(|| (NAMES[n], self.at[n]))
    }
    fn select(&mut self, thread: u8) {
        self.selected = thread;
    }
    fn begin(&mut self, thread: u8) {
        self.at[usize::from(thread)] = 100 * u32::from(thread);
    }
    fn specials(&self) -> usize {
        1
    }
}

fn parts(parts: &'static [&'static [Do]]) -> Parts {
    Parts {
        parts,
        at: [0; 8],
        selected: 0,
        scalars: [("VAR_KEY", None), ("VAR_SPECIAL_1", Some(0.0)), ("A", None)],
    }
}

type Threaded<S = ()> = Machine<Parts, Follower, Scripted, S, 4, 3>;

fn machine(program: &'static [&'static [Do]], keys: &[(u64, u8)]) -> Threaded {
    let keys = Scripted::new(keys.to_vec());
    Machine::new(parts(program), &MODEL, follower(), keys, ()).expect("made for this robot")
}

/// Runs to the end, and returns the trace: of each record cycle, sub, thread, step and next, and what follows.
fn trace<S: Special>(machine: &mut Threaded<S>) -> Vec<String> {
    let mut trace = JsonLines::new(String::new(), false);
    while machine.cycle_traced(&mut trace).is_running() {
        assert!(machine.cycles() < 100, "it never ends");
    }
    let ending = match machine.status() {
        Status::Finished(end) => Ending::Program(end),
        _ => Ending::Emergency(*machine.emergency().expect("it stopped")),
    };
    trace.end(ending, machine.cycles());
    let text = trace.into_inner();
    let short = |line: &str| {
        let line = &line[1..line.len() - 1];
        line.replace("\"", "").replace(',', " ")
    };
    text.lines().map(short).collect()
}

fn run(program: &'static [&'static [Do]]) -> Vec<String> {
    trace(&mut machine(program, &[]))
}

const NONE: Target = Target::None;
const J11: Target = Target::Joint(1, 1);

// clauses: 14.2 14.3
#[test]
fn several_steps_run_in_a_turn_from_the_next_cycle_on() {
    let program: &[&[Do]] = &[&[
        Do::Ask(Op::SpeedUp, NONE, &[3.9]),
        Do::Count,
        Do::Count,
        Do::Count,
        Do::Count,
        Do::Ask(Op::SpeedUp, NONE, &[1.0]),
        Do::Nop,
        Do::End,
    ]];
    assert_eq!(
        run(program),
        [
            "cycle:0 step:0 next:1 cmd:[TIP_SPEED_UP null 3.9]",
            "cycle:1 step:1 next:2 set:{A:1.0}",
            "cycle:1 sub:1 step:2 next:3 set:{A:2.0}",
            "cycle:1 sub:2 step:3 next:4 set:{A:3.0}",
            "cycle:2 step:4 next:5 set:{A:4.0}",
            "cycle:2 sub:1 step:5 next:6 cmd:[TIP_SPEED_UP null 1.0]",
            "cycle:2 sub:2 step:6 next:7",
            "cycle:3 step:7",
            "end:END cycles:4",
        ]
    );
    for values in [[0.9], [256.0], [-1.0]] {
        let mut machine = bench(&[nop], &[]);
        machine.cycle();
        let mut devices = crate::machine::devices::Devices {
            controller: &mut machine.controller,
            sensors: machine.sensors.view(),
            io: &mut machine.state.io,
        };
        let values = values.map(Value::Absolute);
        let command = Command {
            op: Op::SpeedUp,
            hs: false,
            target: NONE,
            values: &values,
        };
        assert_eq!(
            crate::program::Robot::command(&mut devices, &command),
            Err(Fault::Domain)
        );
    }
}

// clauses: 14.2
#[test]
fn waits_and_what_shows_outside_end_a_turn_done_or_not() {
    const FAST: Do = Do::Ask(Op::SpeedUp, NONE, &[9.0]);
    macro_rules! count {
        ($step:expr) => {{
            let lines = run(&[&[FAST, $step, Do::Nop, Do::End]]);
            lines.last().expect("a last record").clone()
        }};
    }
    // One cycle to speed up; a step that ends no turn shares the second one with END.
    for (step, cycles) in [
        (count!(Do::Nop), 2),
        (count!(Do::Ask(Op::FlushBuf, NONE, &[])), 2),
        (count!(Do::Ask(Op::LampOn, NONE, &[1.0])), 2),
        (count!(Do::Ask(Op::SilentOn, NONE, &[])), 2),
        (count!(Do::Ask(Op::PtpAngle, J11, &[5.0])), 2),
        (count!(Do::Ask(Op::StartTimer, NONE, &[5.0])), 2),
        (count!(Do::Ask(Op::Sleep, NONE, &[0.0])), 3),
        (count!(Do::Ask(Op::Sleep, NONE, &[40.0])), 4),
        (count!(Do::Ask(Op::WaitInpos, J11, &[])), 3),
        (count!(Do::Ask(Op::InitialPosture, NONE, &[])), 3),
        (count!(Do::Ask(Op::OutputVariables, NONE, &[])), 3),
        (count!(Do::Ask(Op::LogStart, NONE, &[])), 3),
        (count!(Do::Ask(Op::LogStop, NONE, &[])), 3),
        (count!(Do::Ask(Op::LogOneShot, NONE, &[])), 3),
        (count!(Do::Say("")), 3),
        (count!(Do::Append("")), 3),
        (count!(Do::ReadVr1), 3),
        (count!(Do::Wait(1)), 3),
    ] {
        assert_eq!(step, format!("end:END cycles:{cycles}"));
    }
    let lines = trace(&mut machine(
        &[&[FAST, Do::Key, Do::Nop, Do::End]],
        &[(0, b'a')],
    ));
    assert_eq!(lines.last().expect("one"), "end:END cycles:3");
}

// clauses: 14.4
#[test]
fn a_fault_in_a_later_step_leaves_what_earlier_ones_did_but_no_motion() {
    let program: &[&[Do]] = &[&[
        Do::Ask(Op::SpeedUp, NONE, &[5.0]),
        Do::Count,
        Do::Ask(Op::PtpAngle, J11, &[20.0]),
        Do::Ask(Op::LampOn, NONE, &[3.0]),
        Do::Fail,
        Do::End,
    ]];
    let mut machine = machine(program, &[]);
    assert_eq!(
        trace(&mut machine),
        [
            "cycle:0 step:0 next:1 cmd:[TIP_SPEED_UP null 5.0]",
            "cycle:1 step:1 next:2 set:{A:1.0}",
            "cycle:1 sub:1 step:2 next:3 cmd:[PTP_ANGLE J11 20.0]",
            "cycle:1 sub:2 step:3 next:4 lamp:{3:true}",
            "end:EMERGENCY error:Too deep subroutine call kind:RuntimeError step:4 cycles:1",
        ]
    );
    assert_eq!(
        machine.hardware().outputs.len(),
        1,
        "the second cycle stops"
    );
    assert_eq!(machine.hardware().stops.len(), 1);
    assert_eq!(machine.program().scalars[2].1, Some(1.0));
}

// clauses: 15.1 15.2 15.3
#[test]
fn threads_run_after_the_main_program_in_the_order_of_their_text() {
    let program: &[&[Do]] = &[
        &[Do::Start(2), Do::Start(1), Do::Nop, Do::Wait(1), Do::End],
        &[Do::Nop, Do::ThreadEnd],
        &[Do::Count, Do::Count, Do::Jump(200)],
    ];
    assert_eq!(
        run(program),
        [
            "cycle:0 step:0 next:1",
            "cycle:1 step:1 next:2",
            "cycle:1 sub:1 thread:TWO step:200 next:201 set:{A:1.0}",
            "cycle:2 step:2 next:3",
            "cycle:2 sub:1 thread:ONE step:100 next:101",
            "cycle:2 sub:2 thread:TWO step:201 next:202 set:{A:2.0}",
            // ONE ends after the main program waited in this cycle.
            "cycle:3 step:3 next:3",
            "cycle:3 sub:1 thread:ONE step:101",
            "cycle:3 sub:2 thread:TWO step:202 next:200",
            "cycle:4 step:3 next:4",
            "cycle:4 sub:1 thread:TWO step:200 next:201 set:{A:3.0}",
            // END anywhere: no later turn.
            "cycle:5 step:4",
            "end:END cycles:6",
        ]
    );
}

// clauses: 15.1
#[test]
fn of_a_start_and_a_stop_in_one_cycle_the_later_stands() {
    const FAST: Do = Do::Ask(Op::SpeedUp, NONE, &[9.0]);
    // A started one does not begin.
    let lines = run(&[
        &[
            FAST,
            Do::Start(1),
            Do::Stop(1),
            Do::Wait(1),
            Do::Nop,
            Do::End,
        ],
        &[Do::Count, Do::Jump(100)],
    ]);
    assert_eq!(lines.last().expect("one"), "end:END cycles:3");
    // A stopped one has its turn, and begins anew.
    let program: &[&[Do]] = &[
        &[
            Do::Start(1),
            Do::Nop,
            FAST,
            Do::Stop(1),
            Do::Start(1),
            Do::Say("x"),
            Do::End,
        ],
        &[Do::Nop, Do::Nop, Do::Say("old"), Do::Nop],
    ];
    assert_eq!(
        run(program)[5..],
        [
            "cycle:3 step:3 next:4",
            "cycle:3 sub:1 step:4 next:5",
            "cycle:3 sub:2 step:5 next:6 say:x",
            "cycle:3 sub:3 thread:ONE step:102 next:103 say:old",
            "cycle:4 step:6",
            "end:END cycles:5",
        ]
    );
    let program: &[&[Do]] = &[
        &[Do::Start(1), Do::Stop(1), Do::Nop, Do::Stop(1), Do::End],
        &[Do::Nop, Do::Nop, Do::Nop, Do::Nop],
    ];
    assert_eq!(
        run(program),
        [
            "cycle:0 step:0 next:1",
            "cycle:1 step:1 next:2",
            "cycle:1 sub:1 thread:ONE step:100 next:101",
            "cycle:2 step:2 next:3",
            "cycle:3 step:3 next:4",
            "cycle:4 step:4",
            "end:END cycles:5",
        ]
    );
}

// clauses: 15.1
#[test]
fn a_running_thread_cannot_be_started_and_none_waits_for_itself() {
    let emergency = "error:Invalid control mode kind:RuntimeError";
    let lines = run(&[&[Do::Start(1), Do::Start(1)], &[Do::Nop, Do::Nop]]);
    let last = lines.last().expect("one");
    assert_eq!(*last, format!("end:EMERGENCY {emergency} step:1 cycles:1"));
    let fast: &[&[Do]] = &[
        &[
            Do::Ask(Op::SpeedUp, NONE, &[2.0]),
            Do::Start(1),
            Do::Start(1),
        ],
        &[Do::Nop],
    ];
    let lines = run(fast);
    let last = lines.last().expect("one");
    assert_eq!(*last, format!("end:EMERGENCY {emergency} step:2 cycles:1"));
    let lines = run(&[&[Do::Start(1), Do::Jump(1)], &[Do::Wait(1)]]);
    let last = lines.last().expect("one");
    let thread = format!("end:EMERGENCY {emergency} thread:ONE step:100 cycles:1");
    assert_eq!(*last, thread);
    // Over at once, it can be started again in the same cycle.
    let lines = run(&[
        &[Do::Start(1), Do::Start(2), Do::Nop, Do::Nop, Do::End],
        &[Do::Nop, Do::ThreadEnd],
        &[Do::Start(1), Do::Wait(1), Do::ThreadEnd],
    ]);
    assert_eq!(
        lines[3..],
        [
            "cycle:2 step:2 next:3",
            "cycle:2 sub:1 thread:ONE step:101",
            "cycle:2 sub:2 thread:TWO step:200 next:201",
            "cycle:3 step:3 next:4",
            "cycle:3 sub:1 thread:ONE step:100 next:101",
            "cycle:3 sub:2 thread:TWO step:201 next:201",
            "cycle:4 step:4",
            "end:END cycles:5",
        ]
    );
}

// clauses: 15.2
#[test]
fn each_sleeps_for_itself_and_the_first_that_asks_takes_the_key() {
    let program: &[&[Do]] = &[
        &[
            Do::Start(1),
            Do::Start(2),
            Do::Ask(Op::Sleep, NONE, &[60.0]),
            Do::End,
        ],
        &[Do::Ask(Op::Sleep, NONE, &[40.0]), Do::Key, Do::Say("one")],
        &[Do::Key, Do::Say("two"), Do::Jump(201)],
    ];
    let lines = trace(&mut machine(program, &[(3, b'k')]));
    assert_eq!(
        lines,
        [
            "cycle:0 step:0 next:1",
            "cycle:1 step:1 next:2",
            "cycle:1 sub:1 thread:ONE step:100 next:100",
            "cycle:2 step:2 next:2",
            "cycle:2 sub:1 thread:ONE step:100 next:101",
            "cycle:2 sub:2 thread:TWO step:200 next:200",
            "cycle:3 step:2 next:2",
            "cycle:3 sub:1 thread:ONE step:101 next:102 set:{VAR_KEY:75.0}",
            "cycle:3 sub:2 thread:TWO step:200 next:200",
            "cycle:4 step:2 next:3",
            "cycle:4 sub:1 thread:ONE step:102 next:103 say:one",
            "cycle:4 sub:2 thread:TWO step:200 next:200",
            "cycle:5 step:3",
            "end:END cycles:6",
        ]
    );
}

// clauses: 15.4
#[test]
fn one_command_that_moves_the_whole_robot_excludes_others() {
    let program: &[&[Do]] = &[
        &[Do::Start(1), Do::Ask(Op::StandUp, NONE, &[20.0]), Do::End],
        &[Do::Nop, Do::Ask(Op::InitialPosture, NONE, &[])],
    ];
    let last = run(program).pop().expect("one");
    assert_eq!(
        last,
        "end:EMERGENCY error:Invalid control mode kind:RuntimeError thread:ONE step:101 cycles:2"
    );
    // A domain comes first.
    let program: &[&[Do]] = &[
        &[Do::Start(1), Do::Ask(Op::StandUp, NONE, &[20.0]), Do::End],
        &[Do::Nop, Do::Ask(Op::DetectFloor, Target::All, &[4.0])],
    ];
    let last = run(program).pop().expect("one");
    assert!(
        last.starts_with("end:EMERGENCY error:Domain error"),
        "{last}"
    );
}

// clauses: 15.1 15.4
#[test]
fn a_stop_gives_up_the_wait_and_its_speed_comes_back() {
    let program: &[&[Do]] = &[
        &[
            Do::Start(1),
            Do::Ask(Op::Sleep, NONE, &[100.0]),
            Do::Stop(1),
            Do::Nop,
            Do::Ask(Op::SitDown, NONE, &[5.0]),
            Do::End,
        ],
        &[Do::Ask(Op::StandUp, NONE, &[50.0]), Do::Nop],
    ];
    let mut machine = machine(program, &[]);
    while machine.program().at() < 2 {
        assert!(machine.cycle().is_running());
    }
    let lines = trace(&mut machine);
    let last = lines.last().expect("one");
    assert!(
        last.starts_with("end:END"),
        "{last}: SIT_DOWN is free to begin"
    );
    // In the cycle of STOP_THREAD the thread has its turn.
    assert!(lines[1].contains("thread:ONE"));
    assert!(!lines.iter().skip(2).any(|line| line.contains("thread")));
}

// clauses: 14.1
#[test]
fn timers_count_cycles_from_the_end_of_the_one_that_starts_them() {
    let program: &[&[Do]] = &[&[
        Do::Ask(Op::StartTimer, NONE, &[7.9]),
        Do::Time(7),
        Do::Ask(Op::StopTimer, NONE, &[7.0]),
        Do::Nop,
        Do::Time(7),
        Do::Ask(Op::RestartTimer, NONE, &[7.0]),
        Do::Ask(Op::SetSamplingTime, NONE, &[10.0]),
        Do::Time(7),
        Do::Ask(Op::ResetTimer, NONE, &[7.0]),
        Do::Time(7),
        Do::Time(0),
        Do::End,
    ]];
    let sets: Vec<_> = run(program)
        .into_iter()
        .filter_map(|line| line.split_once("set:").map(|(_, set)| set.replace('}', "")))
        .collect();
    // 20 ms a cycle; STOP is the second cycle after START, so two cycles have ended before it.
    assert_eq!(sets, ["{A:20.0", "{A:40.0", "{A:70.0", "{A:10.0", "{A:0.0"]);
    let last = run(&[&[Do::Ask(Op::StartTimer, NONE, &[8.0])]]).pop();
    assert!(last.expect("one").contains("Domain error"));
}

// clauses: 14.1
#[test]
fn the_timers_of_a_paused_program_stand() {
    let mut machine = machine(
        &[&[Do::Ask(Op::StartTimer, NONE, &[0.0]), Do::Nop, Do::Nop]],
        &[],
    );
    machine.cycle();
    assert_eq!(machine.timer(0), 20.0);
    machine.pause();
    machine.cycle();
    assert_eq!(machine.timer(0), 20.0);
    machine.resume();
    machine.cycle();
    assert_eq!(machine.timer(0), 40.0);
    machine.restart();
    assert_eq!(machine.timer(0), 0.0);
}

/// Adds 1 to VAR_SPECIAL_1 in each motion phase, and 100 when it is called.
struct Adds;

impl Special for Adds {
    fn poll(&mut self, _: Call, robot: &mut dyn crate::program::Robot) -> Result<Poll, Fault> {
        let variable = SpecialVariable::Var(1);
        let value = robot.special_variable(variable);
        robot.set_special_variable(variable, value + 100.0)?;
        let refused = robot.set_special_variable(variable, f64::INFINITY);
        assert_eq!(refused, Err(Fault::Domain));
        Ok(Poll::Done)
    }

    fn cycle(&mut self, robot: &mut dyn crate::program::Robot) -> Result<(), Fault> {
        let variable = SpecialVariable::Var(1);
        let value = robot.special_variable(variable);
        let _ = robot.set_special_variable(variable, value + 1.0);
        Ok(())
    }
}

// clauses: 13.3
#[test]
fn native_code_writes_variables_that_the_next_steps_see() {
    let steps: &[Do] = &[
        Do::Nop,
        Do::Ask(Op::Special, NONE, &[9.0]),
        Do::Ask(Op::SpeedUp, NONE, &[2.0]),
        Do::Nop,
        Do::Nop,
        Do::End,
    ];
    let keys = Scripted::new(vec![]);
    let mut machine: Threaded<Adds> =
        Machine::new(parts(const { &[&[]] }), &MODEL, follower(), keys, Adds).expect("made for it");
    machine.program_mut().parts = std::boxed::Box::leak(std::boxed::Box::new([steps]));
    assert_eq!(
        trace(&mut machine),
        [
            "cycle:0 step:0 next:1",
            "cycle:1 step:1 next:2 set:{VAR_SPECIAL_1:101.0} cmd:[SPECIAL null 9.0]",
            "cycle:2 step:2 next:3 set:{VAR_SPECIAL_1:102.0} cmd:[TIP_SPEED_UP null 2.0]",
            "cycle:3 step:3 next:4",
            "cycle:3 sub:1 step:4 next:5 set:{VAR_SPECIAL_1:103.0}",
            "cycle:4 step:5",
            "end:END cycles:5",
        ]
    );
}

// clauses: 7.41
#[test]
fn a_stop_and_a_dump_in_one_cycle_do_not_undo_each_other() {
    let program: &[&[Do]] = &[
        &[
            Do::Start(1),
            Do::Ask(Op::OutputVariables, NONE, &[]),
            Do::Nop,
            Do::End,
        ],
        &[Do::Ask(Op::AllStop, NONE, &[]), Do::Nop],
    ];
    let mut machine = machine(program, &[]);
    machine.cycle();
    machine.cycle();
    assert!(machine.controller().is_held());
    machine.cycle();
    assert!(machine.controller().is_held(), "ALL_STOP stays");
}
