//! Keyboard and halt request.

use super::*;
use crate::command::Flag;

fn key_in(scalars: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    Ok(match cx.key() {
        Some(byte) => {
            scalars[0].1 = Some(f64::from(byte));
            Flow::Next
        }
        None => Flow::Wait,
    })
}

fn hit(scalars: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    scalars[1].1 = Some(f64::from(u8::from(cx.flag(Flag::KbHit))));
    Ok(Flow::Next)
}

fn halted(scalars: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    scalars[1].1 = Some(f64::from(u8::from(cx.flag(Flag::HaltRequest))));
    Ok(Flow::Wait)
}

fn flush(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::FlushBuf, &[])
}

// clauses: 2.17 7.33
#[test]
fn key_in_waits_takes_the_oldest_key_upper_cased_and_empties_the_buffer() {
    let mut machine = bench(&[key_in, hit, end], &[(2, b'q'), (2, b'x')]);
    machine.cycle();
    machine.cycle();
    assert_eq!(machine.program().at(), 0);
    machine.cycle();
    assert_eq!(machine.program().scalars[0].1, Some(81.0));
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(0.0));
}

// clauses: 5.1
#[test]
fn a_hit_key_is_not_consumed_by_looking() {
    let mut machine = bench(&[hit, hit, key_in, end], &[(1, b'7')]);
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(0.0));
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(1.0));
    machine.cycle();
    assert_eq!(machine.program().scalars[0].1, Some(55.0));
}

// clauses: 7.34
#[test]
fn flush_buf_forgets_all_keys() {
    let mut machine = bench(&[flush, hit, end], &[(0, b'a'), (0, b'b')]);
    machine.cycle();
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(0.0));
}

// clauses: 2.23 5.1
#[test]
fn escape_requests_a_halt_and_is_no_key() {
    let mut machine = bench(&[hit, halted, end], &[(0, 0x1B)]);
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(0.0));
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(1.0));

    let mut machine = bench(&[halted], &[]);
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(0.0));
    machine.request_halt();
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(1.0));
}

// clauses: 2.23
#[test]
fn return_stops_the_robot_in_any_cycle_even_behind_a_full_buffer() {
    let mut keys = std::vec![(1, b'a'); 70];
    keys.push((1, 0x0D));
    let mut machine = bench(&[stay], &keys);
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Emergency);
    let emergency = machine.emergency().expect("stopped");
    assert_eq!(emergency.fault, Fault::EmergencyKey);
    assert_eq!((emergency.step, emergency.cycle), (0, 1));
}

// clauses: 2.23
#[test]
fn return_stops_the_robot_behind_the_end_as_well() {
    let mut machine = bench(&[end], &[(1, 0x0D)]);
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
    let mut machine =
        Machine::new(script(&[end]), &MODEL, follower(), Endless, ()).expect("made for this robot");
    assert_eq!(machine.cycle(), Status::Finished(End::End));
}
