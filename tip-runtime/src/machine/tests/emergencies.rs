//! Emergency stop.

use super::*;
use crate::record::JsonLines;
use std::string::String;

fn assign_then_fail(_: &mut Scalars, _: &mut dyn Context) -> Result<Flow, Fault> {
    Err(Fault::Unassigned(1))
}

fn divide(_: &mut Scalars, _: &mut dyn Context) -> Result<Flow, Fault> {
    Err(Fault::Domain)
}

// clauses: 2.19 8.1
#[test]
fn a_fault_stops_the_robot_in_every_cycle_and_is_told_once() {
    let mut machine = bench(&[nop, divide, end], &[]);
    machine.cycle();
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.cycle(), Status::Emergency);
    let robot = machine.hardware();
    assert_eq!((robot.outputs.len(), robot.stops.len()), (1, 3));
    assert_eq!((machine.program().at(), machine.cycles()), (1, 1));
    let told = &machine.console().inner();
    assert_eq!(
        told.emergency.as_deref(),
        Some(
            "TIP_ERR:Domain error (RuntimeError)\nprogram\tscript\ntitle\ta test\n\
             step\t1\nline\t5\ncycle\t1\n"
        )
    );
    assert_eq!(told.ended, 1);
}

// clauses: 3.4 8.1
#[test]
fn the_report_names_the_variable_that_was_read_too_early() {
    let mut machine = bench(&[assign_then_fail], &[]);
    machine.cycle();
    let text = machine
        .console()
        .inner()
        .emergency
        .as_deref()
        .expect("told");
    assert!(
        text.starts_with("TIP_ERR:Possible use of Variable before definition (RuntimeError)\n")
    );
    assert!(text.ends_with("variable\tA\n"));
}

// clauses: 2.19
#[test]
fn the_failing_cycle_leaves_no_record() {
    let mut trace = JsonLines::new(String::new(), false);
    let mut machine = bench(&[nop, divide], &[]);
    machine.cycle_traced(&mut trace);
    machine.cycle_traced(&mut trace);
    machine.cycle_traced(&mut trace);
    assert_eq!(trace.into_inner(), "{\"cycle\":0,\"step\":0,\"next\":1}\n");
}

// clauses: 2.22 8.1
#[test]
fn sensors_are_judged_before_the_step() {
    let mut machine = bench(&[nop, nop, end], &[]);
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
    let mut machine = bench(&[nop, nop, end], &[]);
    machine.hardware_mut().read_fault = Some(HardwareFault("bus"));
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.cycles(), 0);
    let text = machine.console().inner().emergency.clone().expect("told");
    assert!(text.starts_with("TIP_ERR:Hardware fault bus (RobotError)\n"));

    let mut machine = bench(&[nop, nop, end], &[]);
    machine.hardware_mut().write_fault = Some(HardwareFault("bus"));
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.emergency().map(|e| e.cycle), Some(1));
}

// clauses: 8.1
#[test]
fn a_host_stops_the_robot_as_the_return_key_does() {
    let mut machine = bench(&[stay], &[]);
    machine.cycle();
    machine.emergency_stop();
    assert_eq!(machine.cycle(), Status::Emergency);
    let text = machine.console().inner().emergency.clone().expect("told");
    assert!(text.starts_with("TIP_ERR:Emergency stop key (RobotError)\n"));
}

#[test]
fn a_restart_runs_the_program_again() {
    let mut machine = bench(&[nop, divide, end], &[]);
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

    let mut machine = bench(&[end], &[]);
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    machine.restart();
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    assert_eq!(machine.console().inner().ended, 2);
}
