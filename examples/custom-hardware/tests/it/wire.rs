//! Frames and servos.

use custom_hardware::link::{Link, MemoryLink};
use custom_hardware::protocol::{BROADCAST, Frame, Instruction};
use custom_hardware::servo::Servo;

fn frame(servo: u8, instruction: Instruction, value: i16) -> [u8; 7] {
    Frame {
        servo,
        instruction,
        value,
    }
    .encode()
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
    assert_eq!(Frame::decode(bytes).unwrap().value, -300);
    for place in 0..bytes.len() {
        let mut damaged = bytes;
        damaged[place] ^= 0x10;
        assert_eq!(Frame::decode(damaged), None, "byte {place}");
    }
}

#[test]
fn servos_set_off_together_and_arrive() {
    let mut link = MemoryLink::new(vec![Servo::new(1, 0.0), Servo::new(2, 0.0)], 20.0);
    link.send(frame(1, Instruction::Target, 50));
    link.send(frame(2, Instruction::Target, -50));
    assert_eq!(
        link.servos()[0].position(),
        0.0,
        "a target alone moves nothing"
    );
    for _ in 0..50 {
        link.send(frame(BROADCAST, Instruction::Go, 0));
    }
    assert!((link.servos()[0].position() - 50.0).abs() < 0.01);
    assert!((link.servos()[1].position() + 50.0).abs() < 0.01);
}

#[test]
fn a_servo_is_no_faster_than_it_can_be() {
    let mut link = MemoryLink::new(vec![Servo::new(1, 0.0)], 20.0);
    link.send(frame(1, Instruction::Target, 4000));
    link.send(frame(BROADCAST, Instruction::Go, 0));
    // 3 counts a ms for 20 ms.
    assert_eq!(link.servos()[0].position(), 60.0);
}

#[test]
fn stop_holds_a_servo_where_it_is() {
    let mut link = MemoryLink::new(vec![Servo::new(1, 0.0)], 20.0);
    link.send(frame(1, Instruction::Target, 1000));
    link.send(frame(BROADCAST, Instruction::Go, 0));
    let reached = link.servos()[0].position();
    link.send(frame(BROADCAST, Instruction::Stop, 0));
    link.send(frame(BROADCAST, Instruction::Go, 0));
    assert_eq!(link.servos()[0].position(), reached);
}

#[test]
fn only_the_servo_asked_answers() {
    let mut link = MemoryLink::new(vec![Servo::new(1, 7.0), Servo::new(2, 9.0)], 20.0);
    link.send(frame(2, Instruction::Ask, 0));
    let answer = Frame::decode(link.receive().unwrap()).unwrap();
    assert_eq!((answer.servo, answer.value), (2, 9));
    assert_eq!(link.receive(), None);
}
