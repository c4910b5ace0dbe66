//! The program on the bus, and what a broken bus does.

use custom_hardware::Feet;
use custom_hardware::bus::{BROADCAST, DRIVES, Frame, Instruction, Link, ServoBus};
use custom_hardware::servos::MemoryLink;
use tip_runtime::fault::{Fault, HardwareFault};
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::titan8;
use tip_runtime::program::End;

fn machine() -> Machine<Feet, ServoBus<MemoryLink>, (), (), 4, 3> {
    let robot = ServoBus(MemoryLink::titan8());
    Machine::new(Feet::new(), &titan8::MODEL, robot, (), ()).expect("a program of TITAN VIII")
}

fn frame(servo: u8, instruction: Instruction, value: i16) -> [u8; 7] {
    let frame = Frame {
        servo,
        instruction,
        value,
    };
    frame.encode()
}

#[test]
fn a_frame_has_the_documented_bytes() {
    // 11 + 0 + 0x34 + 0x12 = 81; 256 − 81 = 175.
    let expected = [0xFF, 0xFE, 11, 0, 0x34, 0x12, 175];
    assert_eq!(frame(11, Instruction::Target, 0x1234), expected);
}

#[test]
fn a_frame_survives_and_a_damaged_one_does_not() {
    let bytes = frame(21, Instruction::Position, -300);
    assert_eq!(Frame::decode(bytes).map(|frame| frame.value), Some(-300));
    for place in 0..bytes.len() {
        let mut damaged = bytes;
        damaged[place] ^= 0x10;
        assert_eq!(Frame::decode(damaged), None, "byte {place}");
    }
}

#[test]
fn sign_and_offset_turn_a_joint_angle_into_a_motor_angle_and_back() {
    // J13: motor = −1 × 45 + 90 = 45 deg, an eighth of 4096 counts beyond the middle 2048.
    assert_eq!(DRIVES[0][2].counts(45.0), 2560.0);
    for drive in DRIVES.iter().flatten() {
        let angle = drive.angle(drive.counts(37.5));
        assert!((angle - 37.5).abs() < 1e-9, "{}", drive.id);
    }
}

#[test]
fn servos_set_off_together_at_a_limited_speed_and_hold_when_stopped() {
    let mut link = MemoryLink::titan8();
    let start = link.servos[0].position;
    let target = start as i16 + 1000;
    link.send(frame(11, Instruction::Target, target));
    assert_eq!(
        link.servos[0].position, start,
        "a target alone moves nothing"
    );
    link.send(frame(BROADCAST, Instruction::Go, 0));
    // 3 counts a ms for 20 ms.
    assert_eq!(link.servos[0].position, start + 60.0);
    link.send(frame(BROADCAST, Instruction::Stop, 0));
    link.send(frame(BROADCAST, Instruction::Go, 0));
    assert_eq!(link.servos[0].position, start + 60.0);
}

#[test]
fn the_program_ends_with_every_servo_where_it_was_sent() {
    let mut machine = machine();
    let mut knee = 0.0_f64;
    while machine.cycle().is_running() {
        knee = knee.max(machine.sensors().angles[0][2]);
    }
    assert_eq!(machine.status(), Status::Finished(End::End));
    // A foot 30 mm higher bends the knee from 90 to 96.6 deg.
    assert!((95.0..97.5).contains(&knee), "J13 reached {knee} deg");
    let measured = machine.sensors().angles.iter().flatten();
    let initial = titan8::MODEL.legs.iter().flat_map(|leg| leg.initial);
    for (measured, initial) in measured.zip(initial) {
        // A count of the encoder is 0.09 deg.
        assert!((measured - initial).abs() < 0.5, "{measured} for {initial}");
    }
}

#[test]
fn a_servo_that_falls_silent_is_an_emergency_stop() {
    let mut machine = machine();
    for _ in 0..10 {
        assert!(machine.cycle().is_running());
    }
    machine
        .hardware_mut()
        .0
        .servos
        .retain(|servo| servo.id != 32);
    assert_eq!(machine.cycle(), Status::Emergency);
    let fault = machine.emergency().map(|emergency| emergency.fault);
    let silent = HardwareFault::new("no answer").at_joint(3, 2).of_servo(32);
    assert_eq!(fault, Some(Fault::Hardware(silent)));
    let positions = |machine: &Machine<_, ServoBus<MemoryLink>, _, _, 4, 3>| -> Vec<f64> {
        let servos = machine.hardware().0.servos.iter();
        servos.map(|servo| servo.position).collect()
    };
    let held = positions(&machine);
    for _ in 0..5 {
        machine.cycle();
    }
    assert_eq!(positions(&machine), held, "every servo holds where it is");
}
