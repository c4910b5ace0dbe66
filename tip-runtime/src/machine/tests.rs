//! The control loop with scripted programs on a robot that follows every command immediately.

use super::*;
use crate::command::{Command, Flag, Op, Poll, Port, Target, Value};
use crate::console::Scripted;
use crate::fault::Fault;
use crate::hardware::HardwareFault;
use crate::model::titan8;
use crate::program::{Context, End, Flow, Robot, Signature, SpecialVariable};
use crate::record::{Ending, JsonLines};
use crate::special::Call;
use std::string::String;
use std::vec::Vec;

/// Action of a step in a test.
#[derive(Clone, Copy)]
enum Do {
    Nop,
    Stay,
    /// Adds 1 to `A`.
    Count,
    /// Stores a number in `A`.
    Set(f64),
    /// Stores a flag in `A`.
    Test(Flag),
    Say(&'static str),
    Ask(Op, Target, &'static [f64]),
    Start(u8),
    Call(fn(&mut dyn Context)),
    Fail(Fault),
    End,
}

/// A program of a main part and threads: `parts[0]` is the main part. Steps of part n count from 100 n.
#[derive(Clone)]
struct Script {
    parts: Vec<&'static [Do]>,
    at: [u32; 8],
    selected: u8,
    scalars: [(&'static str, Option<f64>); 3],
}

const NAMES: [&str; 3] = ["", "ONE", "TWO"];

impl Program for Script {
    fn signature(&self) -> Signature {
        titan8::MODEL.signature()
    }
    fn name(&self) -> &str {
        "script"
    }
    fn title(&self) -> &str {
        "a test"
    }
    fn at(&self) -> u32 {
        self.at[usize::from(self.selected)]
    }
    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let part = usize::from(self.selected);
        let at = self.at[part];
        let (_, a) = &mut self.scalars[2];
        match self.parts[part][at as usize - 100 * part] {
            Do::Nop => {}
            Do::Stay => return Ok(Flow::Wait),
            Do::Count => *a = Some(a.unwrap_or(0.0) + 1.0),
            Do::Set(value) => *a = Some(value),
            Do::Test(flag) => *a = Some(f64::from(u8::from(cx.flag(flag)))),
            Do::Say(text) => cx.message(&text),
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
            Do::Call(call) => call(cx),
            Do::Fail(fault) => return Err(fault),
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
        step + 4
    }
    fn reset(&mut self) {
        *self = script(&self.parts);
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

fn script(parts: &[&'static [Do]]) -> Script {
    Script {
        parts: parts.to_vec(),
        at: [0; 8],
        selected: 0,
        scalars: [("VAR_KEY", None), ("VAR_SPECIAL_1", Some(0.0)), ("A", None)],
    }
}

/// Joints that are where they were commanded to be, and a count of what happened.
#[derive(Clone, Debug)]
struct Follower {
    sensors: Sensors<4, 3>,
    outputs: Vec<Outputs<4, 3>>,
    stops: Vec<Fault>,
    read_fault: Option<HardwareFault>,
    write_fault: Option<HardwareFault>,
    stop_fault: Option<HardwareFault>,
}

fn follower() -> Follower {
    let mut sensors = Sensors::ZERO;
    sensors.angles = titan8::MODEL.legs.map(|leg| leg.initial);
    Follower {
        sensors,
        outputs: Vec::new(),
        stops: Vec::new(),
        read_fault: None,
        write_fault: None,
        stop_fault: None,
    }
}

impl Hardware<4, 3> for Follower {
    fn read(&mut self, into: &mut Sensors<4, 3>) -> Result<(), HardwareFault> {
        *into = self.sensors;
        self.read_fault.map_or(Ok(()), Err)
    }
    fn write(&mut self, outputs: &Outputs<4, 3>) -> Result<(), HardwareFault> {
        self.outputs.push(*outputs);
        for (angle, command) in
            (self.sensors.angles.iter_mut().flatten()).zip(outputs.joints.iter().flatten())
        {
            if let JointCommand::Angle { angle: target, .. } = command {
                *angle = *target;
            }
        }
        self.write_fault.map_or(Ok(()), Err)
    }
    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.stops.push(*why);
        self.stop_fault.map_or(Ok(()), Err)
    }
}

type Bench<S = ()> = Machine<Script, Follower, Scripted, S, 4, 3>;

static MODEL: Model<4, 3> = titan8::MODEL;

const NONE: Target = Target::None;
const J11: Target = Target::Joint(1, 1);

/// A machine of a main part and threads, with native code.
fn bench_with<S: Special>(parts: &[&'static [Do]], keys: &[(u64, u8)], special: S) -> Bench<S> {
    let keys = Scripted::new(keys.to_vec());
    Machine::new(script(parts), &MODEL, follower(), keys, special).expect("made for this robot")
}

fn bench(steps: &'static [Do], keys: &[(u64, u8)]) -> Bench {
    bench_with(&[steps], keys, ())
}

impl<S> Bench<S> {
    /// Returns the value of `A`.
    fn a(&self) -> Option<f64> {
        self.program.scalars[2].1
    }
}

/// Runs to the end, and returns the trace: of each record cycle, sub, thread, step and next, and what follows.
fn trace<S: Special>(machine: &mut Bench<S>) -> Vec<String> {
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

fn lamps<S>(machine: &Bench<S>) -> Vec<u32> {
    let outputs = machine.hardware.outputs.iter();
    outputs.map(|outputs| outputs.lamps[0]).collect()
}

// clauses: 2.1 2.18 2.19
#[test]
fn one_step_runs_in_each_cycle_and_the_servo_loop_outlives_the_program() {
    let mut machine = bench(&[Do::Nop, Do::Nop, Do::End], &[]);
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.program().at(), 1);
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    assert_eq!((machine.cycles(), machine.console().inner().ended), (3, 1));
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    assert_eq!((machine.cycles(), machine.console().inner().ended), (3, 1));
    assert_eq!(machine.hardware().outputs.len(), 4);
}

// clauses: 2.19
#[test]
fn the_servo_holds_the_initial_posture_at_program_start() {
    let mut machine = bench(&[Do::Nop, Do::End], &[]);
    machine.cycle();
    let sent = machine.hardware().outputs[0].joints;
    let initial = MODEL.legs.map(|leg| leg.initial.map(JointCommand::at));
    assert_eq!(sent, initial);
}

#[test]
fn a_pause_runs_no_step_and_does_not_count() {
    let mut machine = bench(&[Do::Nop, Do::Nop, Do::End], &[]);
    machine.cycle();
    machine.pause();
    for _ in 0..5 {
        assert_eq!(machine.cycle(), Status::Running);
    }
    assert_eq!((machine.program().at(), machine.cycles()), (1, 1));
    assert!(machine.controller().is_held());
    assert_eq!(machine.hardware().outputs.len(), 6);
    machine.resume();
    assert!(!machine.controller().is_held());
    machine.cycle();
    assert_eq!((machine.program().at(), machine.cycles()), (2, 2));
}

#[test]
fn a_machine_is_cloned_with_all_its_state() {
    let mut machine = bench(&[Do::Nop, Do::Nop, Do::End], &[]);
    machine.cycle();
    let mut copy = machine.clone();
    copy.cycle();
    assert_eq!((machine.program().at(), copy.program().at()), (1, 2));
}

#[test]
fn a_program_for_another_robot_is_refused_by_name() {
    let other = crate::model::generic::MODEL;
    let refused = Machine::new(script(&[]), &other, follower(), (), ())
        .err()
        .expect("another robot");
    assert_eq!(
        std::format!("{refused}"),
        "the program was compiled for titan8 (commands of TITAN VIII, 4 legs of 3 joints), \
         the robot is generic (commands of generic robots, 4 legs of 3 joints)"
    );
}

// clauses: 7.36
#[test]
fn lamps_are_fitted_devices_with_truncated_numbers() {
    let mut machine = bench(
        &[
            Do::Ask(Op::LampOn, NONE, &[7.9]),
            Do::Nop,
            Do::Ask(Op::LampOff, NONE, &[7.0]),
            Do::End,
        ],
        &[],
    );
    for _ in 0..4 {
        machine.cycle();
    }
    assert_eq!(lamps(&machine), [1 << 7, 1 << 7, 0, 0]);

    for steps in [
        &[Do::Ask(Op::LampOn, NONE, &[8.0])],
        &[Do::Ask(Op::LampOff, NONE, &[-1.0])],
    ] {
        let mut machine = bench(steps, &[]);
        assert_eq!(machine.cycle(), Status::Emergency);
        assert_eq!(machine.emergency().map(|e| e.fault), Some(Fault::Domain));
    }
}

// clauses: 7.35 7.37
#[test]
fn messages_and_silence_reach_the_console() {
    let mut machine = bench(
        &[
            Do::Say("hello"),
            Do::Ask(Op::SilentOn, NONE, &[]),
            Do::Ask(Op::SilentOff, NONE, &[]),
            Do::End,
        ],
        &[],
    );
    for _ in 0..4 {
        machine.cycle();
    }
    let commanded = machine.console().inner();
    assert_eq!(commanded.messages, ["hello"]);
    assert_eq!(commanded.silent, [true, false]);
}

// clauses: 7.40
#[test]
fn sampling_goes_on_between_start_and_stop_and_once_for_a_shot() {
    const START: Do = Do::Ask(Op::LogStart, NONE, &[]);
    const STOP: Do = Do::Ask(Op::LogStop, NONE, &[]);
    const SHOT: Do = Do::Ask(Op::LogOneShot, NONE, &[]);
    const NOP: Do = Do::Nop;
    let steps = &[NOP, START, NOP, STOP, NOP, SHOT, NOP, START, SHOT, Do::End];
    let mut machine = bench(steps, &[]);
    while machine.cycle().is_running() {}
    let text = std::format!("{}", machine.console().inner().log);
    let column = |number: usize| {
        let rows = text.lines().skip(1);
        rows.map(move |row| row.split('\t').nth(number).expect("a column"))
            .collect::<Vec<_>>()
    };
    assert_eq!(column(0), ["1", "2", "5", "7", "8", "9"]);
    assert_eq!(column(1)[..2], ["20.0", "40.0"]);
    // TITAN VIII senses no torque.
    assert!(!text.contains("\tT11"));
}

const DUMP: Do = Do::Ask(Op::OutputVariables, NONE, &[]);

// clauses: 7.41 9.5
#[test]
fn every_variable_is_written_and_the_robot_held_for_that_cycle() {
    let mut machine = bench(&[Do::Set(-0.5), DUMP, Do::Nop, Do::End], &[]);
    machine.cycle();
    machine.cycle();
    assert_eq!(
        machine.console().inner().variables,
        ["# cycle 1, step 1, line 5\nVAR_KEY\tunassigned\nVAR_SPECIAL_1\t0.0\nA\t-0.5\n"]
    );
    assert!(!machine.controller().is_held());
}

// clauses: 7.41
#[test]
fn a_robot_that_was_held_stays_held_behind_a_dump() {
    let stop = &[Do::Ask(Op::AllStop, NONE, &[]), DUMP, Do::Nop, Do::End];
    let mut machine = bench(stop, &[]);
    machine.cycle();
    machine.cycle();
    assert!(machine.controller().is_held());
}

const DIVIDE: Do = Do::Fail(Fault::Domain);

// clauses: 2.19 8.1
#[test]
fn a_fault_stops_the_robot_in_every_cycle_and_is_told_once() {
    let mut machine = bench(&[Do::Nop, DIVIDE, Do::End], &[]);
    machine.cycle();
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.cycle(), Status::Emergency);
    let robot = machine.hardware();
    assert_eq!((robot.outputs.len(), robot.stops.len()), (1, 3));
    assert_eq!((machine.program().at(), machine.cycles()), (1, 1));
    let commanded = &machine.console().inner();
    assert_eq!(
        commanded.emergency.as_deref(),
        Some(
            "TIP_ERR:Domain error (RuntimeError)\nprogram\tscript\ntitle\ta test\n\
             step\t1\nline\t5\ncycle\t1\n"
        )
    );
    assert_eq!(commanded.ended, 1);
}

// clauses: 3.4 8.1
#[test]
fn the_report_names_the_variable_that_was_read_too_early() {
    let mut machine = bench(&[Do::Fail(Fault::Unassigned(2))], &[]);
    machine.cycle();
    let text = machine.console().inner().emergency.clone().expect("told");
    assert!(
        text.starts_with("TIP_ERR:Possible use of Variable before definition (RuntimeError)\n")
    );
    assert!(text.ends_with("variable\tA\n"));
}

// clauses: 2.22 8.1
#[test]
fn sensors_are_judged_before_the_step() {
    let mut machine = bench(&[Do::Nop, Do::Nop, Do::End], &[]);
    machine.cycle();
    machine.hardware_mut().sensors.angles[1][2] = 170.0;
    assert_eq!(machine.cycle(), Status::Emergency);
    let emergency = machine.emergency().expect("stopped");
    assert_eq!(emergency.fault, Fault::JointLimit(2, 3));
    assert_eq!((emergency.step, emergency.cycle), (1, 1));
}

// clauses: 2.22 8.1
#[test]
fn hardware_that_cannot_read_stops_at_once_and_one_that_cannot_write_in_the_next_cycle() {
    let mut machine = bench(&[Do::Nop, Do::Nop, Do::End], &[]);
    machine.hardware_mut().read_fault = Some(HardwareFault::new("bus"));
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.cycles(), 0);
    let text = machine.console().inner().emergency.clone().expect("told");
    assert!(text.starts_with("TIP_ERR:Hardware fault bus (RobotError)\n"));

    let mut machine = bench(&[Do::Nop, Do::Nop, Do::End], &[]);
    machine.hardware_mut().write_fault = Some(HardwareFault::new("bus"));
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.emergency().map(|e| e.cycle), Some(1));
}

#[test]
fn a_stop_that_fails_is_reported_and_tried_again() {
    let silent = HardwareFault::new("no answer").at_joint(2, 3).of_servo(9);
    let mut machine = bench(&[Do::Stay], &[]);
    machine.hardware_mut().stop_fault = Some(silent);
    machine.emergency_stop();
    assert_eq!(machine.cycle(), Status::Emergency);
    let text = machine.console().inner().emergency.clone().expect("told");
    assert!(text.starts_with("TIP_ERR:Emergency stop key (RobotError)\n"));
    assert!(
        text.ends_with("cycle\t0\nstop\tJ23 (servo 9): no answer\n"),
        "{text}"
    );
    // It is tried again, and the first failure is kept.
    machine.hardware_mut().stop_fault = None;
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.hardware().stops, [Fault::EmergencyKey; 2]);
    let kept = machine.emergency().and_then(|it| it.stop_fault);
    assert_eq!(kept, Some(silent));
}

#[test]
fn a_later_stop_that_fails_is_kept() {
    let [first, second] = ["bus", "other"].map(HardwareFault::new);
    let mut machine = bench(&[Do::Stay], &[]);
    machine.emergency_stop();
    machine.cycle();
    let text = machine.console().inner().emergency.clone().expect("told");
    assert!(text.ends_with("cycle\t0\n"), "{text}");
    for fault in [first, second] {
        assert_eq!(machine.cycle(), Status::Emergency);
        machine.hardware_mut().stop_fault = Some(fault);
    }
    machine.cycle();
    let kept = machine.emergency().and_then(|it| it.stop_fault);
    assert_eq!(kept, Some(first));
}

// clauses: 8.1
#[test]
fn a_host_stops_the_robot_as_the_return_key_does() {
    let mut machine = bench(&[Do::Stay], &[]);
    machine.cycle();
    machine.emergency_stop();
    assert_eq!(machine.cycle(), Status::Emergency);
    let text = machine.console().inner().emergency.clone().expect("told");
    assert!(text.starts_with("TIP_ERR:Emergency stop key (RobotError)\n"));
}

#[test]
fn a_restart_runs_the_program_again() {
    let mut machine = bench(&[Do::Nop, DIVIDE, Do::End], &[]);
    machine.cycle();
    machine.cycle();
    assert_eq!(machine.cycle(), Status::Emergency);
    machine.restart();
    assert_eq!(machine.status(), Status::Running);
    assert_eq!(machine.emergency(), None);
    assert_eq!((machine.program().at(), machine.cycles()), (0, 0));
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.console().inner().ended, 2);

    let mut machine = bench(&[Do::End], &[]);
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    machine.restart();
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    assert_eq!(machine.console().inner().ended, 2);
}

#[test]
fn a_host_requests_a_halt_as_escape_does() {
    const HALTED: Do = Do::Test(Flag::HaltRequest);
    let mut machine = bench(&[HALTED, HALTED], &[]);
    machine.cycle();
    assert_eq!(machine.a(), Some(0.0));
    machine.request_halt();
    machine.cycle();
    assert_eq!(machine.a(), Some(1.0));
}

// clauses: 2.23
#[test]
fn return_stops_the_robot_in_any_cycle_even_behind_a_full_buffer() {
    let mut keys = std::vec![(1, b'a'); 70];
    keys.push((1, 0x0D));
    let mut machine = bench(&[Do::Stay], &keys);
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Emergency);
    let emergency = machine.emergency().expect("stopped");
    assert_eq!(emergency.fault, Fault::EmergencyKey);
    assert_eq!((emergency.step, emergency.cycle), (0, 1));
}

// clauses: 2.23
#[test]
fn return_stops_the_robot_behind_the_end_as_well() {
    let mut machine = bench(&[Do::End], &[(1, 0x0D)]);
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.console().inner().ended, 1);
}

#[test]
fn a_console_that_never_falls_silent_does_not_stall_the_loop() {
    struct Endless;
    impl Console for Endless {
        fn key(&mut self, _cycle: u64) -> Option<u8> {
            Some(b'y')
        }
    }
    let program = script(&[&[Do::End]]);
    let mut machine =
        Machine::new(program, &MODEL, follower(), Endless, ()).expect("made for this robot");
    assert_eq!(machine.cycle(), Status::Finished(End::End));
}

// clauses: 7.43
#[test]
fn a_number_that_no_native_command_has_is_a_domain_error() {
    let accepting = |_: Call, _: &mut dyn Robot| Ok(Poll::Done);
    let steps: &[Do] = &[Do::Ask(Op::Special, NONE, &[256.0])];
    let mut machine = bench_with(&[steps], &[], accepting);
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.emergency().map(|e| e.fault), Some(Fault::Domain));
}

const LAMP_2: Command<'static> = Command {
    op: Op::LampOn,
    hs: false,
    target: NONE,
    values: &[Value::Absolute(2.0)],
};

// clauses: 7.43
#[test]
fn native_code_calls_no_special_and_its_commands_are_not_recorded() {
    let special = |_: Call, robot: &mut dyn Robot| {
        let command = Command {
            op: Op::Special,
            ..LAMP_2
        };
        assert_eq!(robot.command(&command), Err(Fault::Domain));
        robot.set_special_flag(10, true);
        robot.command(&LAMP_2)
    };
    let steps: &[Do] = &[Do::Ask(Op::Special, NONE, &[14.0, 30.0]), Do::End];
    let mut machine = bench_with(&[steps], &[], special);
    let first = trace(&mut machine).swap_remove(0);
    assert_eq!(first, "cycle:0 step:0 next:1 cmd:[SPECIAL null 14.0 30.0]");
    assert_eq!(lamps(&machine)[0], 0b100);
}

/// Counts the cycles that it sees, lights a lamp in the second one, and fails in cycle `fails`.
struct Activity {
    cycles: u32,
    fails: u32,
}

impl Special for Activity {
    fn poll(&mut self, _: Call, _: &mut dyn Robot) -> Result<Poll, Fault> {
        Err(Fault::Domain)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.cycles += 1;
        if self.cycles == self.fails {
            return Err(Fault::InvalidMode);
        }
        if self.cycles == 2 {
            robot.command(&LAMP_2)?;
        }
        Ok(())
    }
}

fn active(steps: &'static [Do], fails: u32) -> Bench<Activity> {
    bench_with(&[steps], &[], Activity { cycles: 0, fails })
}

// clauses: 2.17 7.43
#[test]
fn native_code_goes_on_behind_every_step_of_a_running_program() {
    let mut machine = active(&[Do::Nop, Do::Nop, Do::Stay], 0);
    machine.cycle();
    machine.cycle();
    assert_eq!(lamps(&machine), [0, 0b100]);
    machine.pause();
    machine.cycle();
    machine.resume();
    machine.cycle();
    assert_eq!(machine.special.cycles, 3);

    let mut ended = active(&[Do::Nop, Do::End], 0);
    for _ in 0..5 {
        ended.cycle();
    }
    assert_eq!(ended.special.cycles, 1);
}

// clauses: 2.22
#[test]
fn a_fault_of_native_code_behind_a_step_is_found_in_the_next_cycle() {
    let mut machine = active(&[Do::Nop, Do::Nop, Do::Nop, Do::End], 2);
    machine.cycle();
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Emergency);
    let emergency = machine.emergency().map(|e| (e.fault, e.step, e.cycle));
    assert_eq!(emergency, Some((Fault::InvalidMode, 2, 2)));
}

const PORTS: [Port; 8] = [
    Port::Channel(13),
    Port::Knob(1),
    Port::Channel(0),
    Port::Joint(1, 1),
    Port::Channel(12),
    Port::Paw(4),
    Port::Antenna,
    Port::Channel(15),
];

fn read_ports(cx: &mut dyn Context) {
    let volts = PORTS.map(|port| cx.analog(port));
    let expected = [1.25, 1.25, 2.5, 2.5, 0.0, 4.0, 0.75, -3.0];
    assert_eq!(volts, expected.map(Ok));
    assert_eq!(cx.analog(Port::Channel(16)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Knob(4)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Knob(0)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Joint(5, 1)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Paw(5)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Knob(2)), Err(Fault::Sensor(Port::Knob(2))));
    assert!(cx.flag(Flag::Antenna));
}

// clauses: 7.32
#[test]
fn every_input_reads_in_volts_by_channel_and_by_name() {
    let mut machine = bench(&[Do::Call(read_ports), Do::End], &[]);
    let sensors = &mut machine.hardware_mut().sensors;
    for (knob, volts) in (1..).zip([1.25, f64::NAN, -3.0]) {
        sensors.inputs.set(Port::Knob(knob), volts);
    }
    // J11 ranges over ±65 degrees up to its outer limits: half way is 2.5 V.
    sensors.angles[0][0] = 32.5;
    sensors.inputs.set(Port::Paw(4), 4.0);
    sensors.inputs.set(Port::Antenna, 0.75);
    assert_eq!(machine.cycle(), Status::Running);
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
    let mut machine = bench_with(program, &[], ());
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

// clauses: 15.4
#[test]
fn a_wrong_operand_comes_before_a_command_that_excludes_another() {
    let program: &[&'static [Do]] = &[
        &[Do::Start(1), Do::Ask(Op::StandUp, NONE, &[20.0]), Do::End],
        &[Do::Nop, Do::Ask(Op::DetectFloor, Target::All, &[4.0])],
    ];
    let mut machine = bench_with(program, &[], ());
    while machine.cycle().is_running() {}
    assert_eq!(machine.emergency().map(|e| e.fault), Some(Fault::Domain));
}

// clauses: 14.1
#[test]
fn the_timers_of_a_paused_program_stand() {
    let steps = &[Do::Ask(Op::StartTimer, NONE, &[0.0]), Do::Nop, Do::Nop];
    let mut machine = bench(steps, &[]);
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
    let mut machine = bench_with(program, &[], ());
    machine.cycle();
    machine.cycle();
    assert!(machine.controller().is_held());
    machine.cycle();
    assert!(machine.controller().is_held(), "ALL_STOP stays");
}
