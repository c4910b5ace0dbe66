//! A control cycle allocates nothing on the heap.

use crate::cycle::program::{Step, bench, hand_bench};
use allocation_counter::measure;
use tip_runtime::command::{Op, Target};
use tip_runtime::machine::Status;

const BUSY: [Step; 12] = [
    (Op::LogStart, Target::None, &[]),
    (Op::StandUp, Target::None, &[50.0]),
    (Op::Ptp, Target::Foot(1), &[-391.0, 201.0, -210.0]),
    (Op::PtpAngle, Target::Joint(2, 1), &[5.0]),
    (Op::WaitInpos, Target::All, &[]),
    (Op::LampOn, Target::None, &[3.0]),
    (Op::SetVMax, Target::All, &[100.0]),
    (Op::OutputVariables, Target::None, &[]),
    (Op::AllStop, Target::None, &[]),
    (Op::AllStopRelease, Target::None, &[]),
    (Op::SitDown, Target::None, &[50.0]),
    (Op::Sleep, Target::None, &[100.0]),
];

#[test]
fn no_cycle_allocates_from_the_first_to_beyond_the_last() {
    let mut machine = bench(&BUSY);
    let heap = measure(|| {
        for _ in 0..1000 {
            machine.cycle();
        }
    });
    assert!(
        matches!(machine.status(), Status::Finished(_)),
        "{:?}",
        machine.emergency()
    );
    assert_eq!(heap.count_total, 0);
}

const GRASPING: [Step; 14] = [
    (Op::Special, Target::None, &[20.0, 0.0, 1.0]),
    (Op::Special, Target::None, &[20.0, 1.0, 1.0]),
    (Op::Special, Target::None, &[1.0]),
    (Op::Special, Target::None, &[2.0, 2.0]),
    (Op::Torque, Target::Foot(1), &[60.0, 60.0, 60.0]),
    (Op::Torque, Target::Foot(2), &[60.0, 60.0, 60.0]),
    (Op::Torque, Target::Foot(3), &[60.0, 60.0, 60.0]),
    (Op::Special, Target::None, &[11.0, 4.0, 2.0]),
    (Op::Special, Target::None, &[14.0, 60.0]),
    (Op::Sleep, Target::None, &[500.0]),
    (Op::Special, Target::None, &[10.0]),
    (Op::Special, Target::None, &[5.0, 2.0, 1.0]),
    (Op::Special, Target::None, &[6.0, 0.0, 5.0]),
    (Op::Sleep, Target::None, &[100.0]),
];

// clauses: 7.48
#[test]
fn native_commands_take_nothing_from_the_heap_either() {
    let mut machine = hand_bench(&GRASPING);
    let heap = measure(|| {
        for _ in 0..400 {
            machine.cycle();
        }
    });
    let ended = matches!(machine.status(), Status::Finished(_));
    assert!(ended, "{:?}", machine.emergency());
    assert_eq!(heap.count_total, 0);
}

#[test]
fn an_emergency_allocates_nothing_either() {
    const LAMP_THAT_IS_NOT_FITTED: [Step; 1] = [(Op::LampOn, Target::None, &[200.0])];
    let mut machine = bench(&LAMP_THAT_IS_NOT_FITTED);
    let heap = measure(|| {
        for _ in 0..10 {
            machine.cycle();
        }
    });
    assert_eq!(machine.status(), Status::Emergency);
    assert_eq!(heap.count_total, 0);
}

#[test]
fn the_counter_counts() {
    let heap = measure(|| drop(std::hint::black_box(vec![1_u8])));
    assert_eq!(heap.count_total, 1);
}
