//! Several steps in a cycle: TIP_SPEED_UP, threads, timers, variables of native code.

use super::*;
use crate::program::SpecialVariable;
use std::format;

fn machine(parts: &[&'static [Do]], keys: &[(u64, u8)]) -> Bench {
    bench_with(parts, keys, ())
}

fn run(parts: &[&'static [Do]]) -> Vec<String> {
    trace(&mut machine(parts, &[]))
}

// clauses: 14.2 14.3
#[test]
fn several_steps_run_in_a_turn_from_the_next_cycle_on() {
    let program: &[&'static [Do]] = &[&[
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
    for steps in [
        &[Do::Ask(Op::SpeedUp, NONE, &[0.9])],
        &[Do::Ask(Op::SpeedUp, NONE, &[256.0])],
        &[Do::Ask(Op::SpeedUp, NONE, &[-1.0])],
    ] {
        let last = run(&[steps]).pop().expect("one");
        assert!(last.contains("Domain error"), "{last}");
    }
}

fn read_vr1(cx: &mut dyn Context) {
    assert_eq!(cx.analog(Port::Knob(1)), Ok(0.0));
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
        (count!(Do::Call(read_vr1)), 3),
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
    let program: &[&'static [Do]] = &[&[
        Do::Ask(Op::SpeedUp, NONE, &[5.0]),
        Do::Count,
        Do::Ask(Op::PtpAngle, J11, &[20.0]),
        Do::Ask(Op::LampOn, NONE, &[3.0]),
        Do::Fail(Fault::TooDeep),
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
    assert_eq!(machine.a(), Some(1.0));
}

// clauses: 15.1 15.2 15.3
#[test]
fn threads_run_after_the_main_program_in_the_order_of_their_text() {
    let program: &[&'static [Do]] = &[
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
    let program: &[&'static [Do]] = &[
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
    let program: &[&'static [Do]] = &[
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
    let program: &[&'static [Do]] = &[
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
    let program: &[&'static [Do]] = &[
        &[Do::Start(1), Do::Ask(Op::StandUp, NONE, &[20.0]), Do::End],
        &[Do::Nop, Do::Ask(Op::InitialPosture, NONE, &[])],
    ];
    let last = run(program).pop().expect("one");
    assert_eq!(
        last,
        "end:EMERGENCY error:Invalid control mode kind:RuntimeError thread:ONE step:101 cycles:2"
    );
    // A domain comes first.
    let program: &[&'static [Do]] = &[
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
    let program: &[&'static [Do]] = &[
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
    let program: &[&'static [Do]] = &[&[
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
    fn poll(&mut self, _: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        let variable = SpecialVariable::Var(1);
        let value = robot.special_variable(variable);
        robot.set_special_variable(variable, value + 100.0)?;
        let refused = robot.set_special_variable(variable, f64::INFINITY);
        assert_eq!(refused, Err(Fault::Domain));
        Ok(Poll::Done)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
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
    assert_eq!(
        trace(&mut bench_with(&[steps], &[], Adds)),
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
    let program: &[&'static [Do]] = &[
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
