//! Simulated servos answer as their makers' manuals say: frames that are printed there, and what registers do.

use std::fmt::Write;
use tip_drives::bus::Timing;
use tip_drives::simulated::{Servo, SimulatedBus};

const MBAUD: Timing = Timing {
    baud: 1_000_000,
    return_delay: 0,
    latency: 0,
};

/// A bus and its time, µs.
struct Line {
    bus: SimulatedBus,
    now: u64,
}

impl Line {
    fn new(servos: Vec<Servo>) -> Self {
        Line {
            bus: SimulatedBus::new(servos, MBAUD),
            now: 0,
        }
    }

    /// Lets time pass, ms.
    fn pass(&mut self, time: u64) {
        self.now += time * 1000;
        self.bus.advance(self.now);
    }

    /// Sends bytes and returns the answer, which comes within a ms.
    fn send(&mut self, bytes: &[u8]) -> Vec<u8> {
        self.bus.receive(bytes, self.now);
        self.now += 1000;
        self.bus.take_bytes(self.now, 1000)
    }

    /// Sends a frame that is written in hexadecimal digits, and returns the answer in the same form.
    fn hex(&mut self, request: &str) -> String {
        let bytes: Vec<u8> = request
            .split_whitespace()
            .map(|byte| u8::from_str_radix(byte, 16).expect("hexadecimal"))
            .collect();
        let mut text = String::new();
        for byte in self.send(&bytes) {
            let blank = if text.is_empty() { "" } else { " " };
            write!(text, "{blank}{byte:02X}").expect("a string");
        }
        text
    }

    /// Writes a register with protocol 1, and returns the error byte of the answer.
    fn write_1(&mut self, id: u8, address: u8, data: &[u8]) -> u8 {
        let mut body = vec![id, data.len() as u8 + 3, 3, address];
        body.extend(data);
        let sum = body.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte));
        body.push(!sum);
        let answer = self.send(&[&[0xFF, 0xFF], &body[..]].concat());
        answer[4]
    }

    /// Writes a register with protocol 2, and returns the error byte of the answer.
    fn write_2(&mut self, id: u8, address: u16, data: &[u8]) -> u8 {
        let mut frame = vec![0xFF, 0xFF, 0xFD, 0, id, data.len() as u8 + 5, 0, 3];
        frame.extend(address.to_le_bytes());
        frame.extend(data);
        // The CRC bit by bit, as the manual's table gives it.
        let crc = frame.iter().fold(0_u16, |crc, byte| {
            (0..8).fold(crc ^ u16::from(*byte) << 8, |crc, _| {
                crc << 1 ^ if crc >> 15 == 1 { 0x8005 } else { 0 }
            })
        });
        frame.extend(crc.to_le_bytes());
        let answer = self.send(&frame);
        answer[8]
    }

    /// Sends a command to an LX.
    fn lx(&mut self, id: u8, command: u8, parameters: &[u8]) -> Vec<u8> {
        let mut body = vec![id, parameters.len() as u8 + 3, command];
        body.extend(parameters);
        let sum = body.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte));
        body.push(!sum);
        self.send(&[&[0x55, 0x55], &body[..]].concat())
    }

    fn servo(&self) -> &Servo {
        &self.bus.servos()[0]
    }
}

/// ROBOTIS e-Manual, "DYNAMIXEL Protocol 1.0", and "AX-12 User's Manual", examples 13 to 15.
#[test]
fn an_ax_answers_frames_of_its_manual() {
    let mut line = Line::new(vec![Servo::of("AX-12", 1, 512.0)]);
    assert_eq!(line.hex("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
    // Present temperature; it is 30 °C here and 32 in the manual.
    assert_eq!(line.hex("FF FF 01 04 02 2B 01 CC"), "FF FF 01 03 00 1E DD");
    // Voltage limits of 10 and 17 V.
    assert_eq!(line.hex("FF FF 01 05 03 0C 64 AA DC"), "FF FF 01 02 00 FC");
    assert_eq!(line.servo().register(13, 1), Some(170));

    let mut line = Line::new(vec![
        Servo::of("AX-12", 0, 512.0),
        Servo::of("AX-12", 1, 512.0),
    ]);
    // 0x010 and 0x150, 0x220 and 0x360: goals and speeds of both.
    assert_eq!(
        line.hex("FF FF FE 0E 83 1E 04 00 10 00 50 01 01 20 02 60 03 67"),
        ""
    );
    let goals = line.bus.servos().iter().map(|servo| {
        let speed = servo.register(32, 2).expect("a register");
        (servo.goal(), speed)
    });
    assert_eq!(goals.collect::<Vec<_>>(), [(16.0, 0x150), (544.0, 0x360)]);

    let mut line = Line::new(vec![Servo::of("AX-12", 0, 512.0)]);
    assert_eq!(line.hex("FF FF 00 05 03 0E FF 01 E9"), "FF FF 00 02 00 FD");
    assert_eq!(line.servo().register(14, 2), Some(0x1FF));
    // "To verify the effect, the power needs to be turned off and then on."
    assert_eq!(line.servo().torque_limit(), 1.0);
    line.bus.reset(0);
    assert!((line.servo().torque_limit() - 0.5).abs() < 0.001);
    assert_eq!(line.hex("FF FF 00 05 03 11 04 04 DE"), "FF FF 00 02 00 FD");
    // No answers from here on.
    line.hex("FF FF 00 04 03 10 00 E8");
    assert_eq!(line.hex("FF FF 00 04 03 19 01 DE"), "");
}

/// ROBOTIS e-Manual, "DYNAMIXEL Protocol 2.0".
#[test]
fn an_x_answers_frames_of_its_manual() {
    let servos = [(1, 166.0), (2, 2079.0)];
    let servo = |(id, at)| Servo::of("XM430-W210", id, at).with(6, 38);
    let mut line = Line::new(servos.map(servo).to_vec());
    assert_eq!(
        line.hex("FF FF FD 00 01 03 00 01 19 4E"),
        "FF FF FD 00 01 07 00 55 00 06 04 26 65 5D"
    );
    assert_eq!(
        line.hex("FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"),
        "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"
    );
    assert_eq!(
        line.hex("FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89"),
        "FF FF FD 00 01 04 00 55 00 A1 0C"
    );
    assert_eq!(line.servo().goal(), 512.0);
    assert_eq!(
        line.hex("FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA"),
        "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0 FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE"
    );
    line.hex("FF FF FD 00 FE 11 00 83 74 00 04 00 01 96 00 00 00 02 AA 00 00 00 82 87");
    let goals = line.bus.servos().iter().map(Servo::goal);
    assert_eq!(goals.collect::<Vec<_>>(), [150.0, 170.0]);
    // Torque on, as ROBOTIS answered a user.
    assert!(!line.servo().has_torque());
    line.hex("FF FF FD 00 01 06 00 03 40 00 01 DB 66");
    assert!(line.servo().has_torque());
}

/// Feetech, "SCS Servo Communication Protocol".
#[test]
fn an_sts_answers_frames_of_its_manual() {
    let servos = [(1, 1304.0), (2, 2048.0)];
    let mut line = Line::new(servos.map(|(id, at)| Servo::of("STS3215", id, at)).to_vec());
    assert_eq!(line.hex("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
    assert_eq!(
        line.hex("FF FF 01 04 02 38 02 BE"),
        "FF FF 01 04 00 18 05 DD"
    );
    assert_eq!(line.hex("FF FF 01 04 03 28 01 CE"), "FF FF 01 02 00 FC");
    assert!(line.servo().has_torque());
    // Goal 2048, time 0, speed 1000 steps/s.
    assert_eq!(
        line.hex("FF FF 01 09 03 2A 00 08 00 00 E8 03 D5"),
        "FF FF 01 02 00 FC"
    );
    assert_eq!(line.servo().goal(), 2048.0);
    assert!((line.servo().speed_limit() - 1000.0 * 360.0 / 4096.0).abs() < 0.01);
    // The same position for both.
    line.hex("FF FF FE 0E 83 2A 04 01 00 08 E8 03 02 00 08 E8 03 59");
    let goals = line.bus.servos().iter().map(Servo::goal);
    assert_eq!(goals.collect::<Vec<_>>(), [2048.0, 2048.0]);
}

/// mjbots, "CAN Protocol", section "Example", and "CAN-FD", section "Decoding frames".
#[test]
fn a_moteus_answers_frames_of_its_manual() {
    // 80 counts of 0.0001 turns are 2.88 deg.
    let mut line = Line::new(vec![Servo::of("moteus-mj5208", 1, 500_800.0)]);
    let mut say = |text: &str| String::from_utf8(line.send(text.as_bytes())).expect("text");
    assert_eq!(
        say("can send 8001 1100110F\n"),
        "OK\nrcv 0100 210000210F00 B F\n"
    );
    // In mode 10; it is at rest, at 12 V and 30 °C.
    assert_eq!(
        say("can send 8001 01000a07206000200150ff140400130d\n"),
        "OK\nrcv 0100 2404000000500000000000230D181E00 B F\n"
    );
    let next = say("can send 8001 140400130d\n");
    // It moves: 2.88 deg or a little more.
    assert!(next.starts_with("OK\nrcv 0100 2404000A005"), "{next}");
    // No answer without the highest bit.
    assert_eq!(say("can send 0001 110000\n"), "OK\n");
    assert_eq!(line.servo().mode(), Some(10));
    // 96 counts are 3.456 deg.
    assert!((line.servo().goal() - 500_960.0).abs() < 1e-6);
}

/// LewanSoul, "Bus Servo Communication Protocol".
#[test]
fn an_lx_answers_frames_of_its_manual() {
    let mut line = Line::new(vec![Servo::of("LX-16A", 1, 300.0)]);
    // To 500 in 1000 ms; writing has no answer.
    assert_eq!(line.hex("55 55 01 07 01 F4 01 E8 03 16"), "");
    line.pass(499);
    // "Uniform speed": half of the way, but for the lag.
    let half = line.servo().position();
    assert!((385.0..=401.0).contains(&half), "{half}");
    line.pass(700);
    assert!((line.servo().position() - 500.0).abs() < 1.0);
    assert_eq!(line.hex("55 55 01 03 1C DF"), "55 55 01 05 1C F4 01 E8");
    assert_eq!(
        line.hex("55 55 01 03 02 F9"),
        "55 55 01 07 02 F4 01 E8 03 15"
    );
    assert!(line.servo().has_torque());
    line.hex("55 55 01 04 1F 00 DB");
    assert!(!line.servo().has_torque());
    // All servos listen to 254, and answer only to the question for their identity.
    assert_eq!(line.hex("55 55 FE 03 1C E2"), "");
    assert_eq!(line.hex("55 55 FE 03 0E F0"), "55 55 01 04 0E 01 EB");
}

#[test]
fn an_ax_refuses_what_its_manual_refuses() {
    let servo = Servo::of("AX-12", 1, 512.0).with(6, 200).with(8, 800);
    let mut line = Line::new(vec![servo]);
    // Bit 1: outside of the angle limits. Bit 3: out of range.
    assert_eq!(line.write_1(1, 30, &[100, 0]), 1 << 1);
    assert_eq!(line.write_1(1, 24, &[2]), 1 << 3);
    assert_eq!(line.write_1(1, 36, &[0, 0]), 1 << 3);
    assert_eq!(line.servo().goal(), 512.0);
    assert!(!line.servo().has_torque());
    // A goal switches the torque on, and the torque locks the EEPROM.
    assert_eq!(line.write_1(1, 30, &[0x2C, 1]), 0);
    assert!(line.servo().has_torque());
    assert_eq!(line.write_1(1, 3, &[9]), 1 << 3);
    line.pass(1000);
    assert!((line.servo().position() - 300.0).abs() < 1.0);
    // Lock: until the power is off.
    assert_eq!(line.write_1(1, 24, &[0]), 0);
    assert_eq!(line.write_1(1, 47, &[1]), 0);
    assert_eq!(line.write_1(1, 3, &[9]), 1 << 3);
    line.bus.reset(1);
    assert_eq!(line.write_1(1, 3, &[9]), 0);
    assert_eq!(line.servo().id(), 9);
}

#[test]
fn an_ax_in_wheel_mode_turns_on_and_an_mx_counts_turns() {
    let wheel = Servo::of("AX-12", 1, 512.0).with(6, 0).with(8, 0);
    let mut line = Line::new(vec![wheel]);
    // Half of the output, clockwise.
    assert_eq!(line.write_1(1, 32, &[0x00, 0x06]), 0);
    assert_eq!(line.write_1(1, 24, &[1]), 0);
    line.pass(4000);
    assert!(line.servo().angle() < -360.0, "{}", line.servo().angle());

    let multi = Servo::of("MX-28", 1, 2048.0).with(6, 4095).with(8, 4095);
    let mut line = Line::new(vec![multi]);
    assert_eq!(line.write_1(1, 30, &[0x00, 0x20]), 0);
    line.pass(4000);
    assert_eq!(line.servo().register(36, 2), Some(8192));
}

#[test]
fn a_hot_ax_has_no_torque_limit_left() {
    let mut line = Line::new(vec![Servo::of("AX-12", 1, 512.0)]);
    line.write_1(1, 24, &[1]);
    line.bus.overheat(1);
    line.pass(4000);
    assert_eq!(line.servo().torque_limit(), 0.0);
    assert_eq!(line.hex("FF FF 01 02 01 FB"), "FF FF 01 02 04 F8");
}

#[test]
fn an_x_refuses_what_its_manual_refuses() {
    let servo = Servo::of("XL430-W250", 1, 2048.0)
        .with(48, 3000)
        .with(52, 1000);
    let mut line = Line::new(vec![servo]);
    let goal = |value: i32| value.to_le_bytes();
    // 6: limit. 4: range. 5: length. 7: access, which the EEPROM denies while the torque is on.
    assert_eq!(line.write_2(1, 116, &goal(3500)), 6);
    assert_eq!(line.write_2(1, 98, &[200]), 4);
    assert_eq!(line.write_2(1, 116, &[0, 8]), 5);
    assert_eq!(line.write_2(1, 132, &goal(0)), 7);
    assert_eq!(line.write_2(1, 7, &[3]), 0);
    assert_eq!(line.write_2(3, 64, &[1]), 0);
    assert_eq!(line.write_2(3, 7, &[1]), 7);
    assert_eq!(line.write_2(3, 11, &[4]), 7);
    assert_eq!(line.servo().goal(), 2048.0);
}

/// "Bus Watchdog(98) Example".
#[test]
fn the_watchdog_of_an_x_latches_an_error() {
    let mut line = Line::new(vec![Servo::of("XL430-W250", 1, 2048.0)]);
    let goal = |value: i32| value.to_le_bytes();
    assert_eq!(line.write_2(1, 64, &[1]), 0);
    // 0.229 rev/min times 10 is 13.7 deg/s.
    assert_eq!(line.write_2(1, 112, &goal(10)), 0);
    assert_eq!(line.write_2(1, 98, &[5]), 0);
    assert_eq!(line.write_2(1, 116, &goal(4000)), 0);
    line.pass(90);
    assert_eq!(line.servo().register(98, 1), Some(5));
    line.pass(15);
    assert_eq!(line.servo().register(98, 1), Some(0xFF));
    assert!(line.servo().has_torque());
    let stopped = line.servo().position();
    assert_eq!(line.write_2(1, 116, &goal(4000)), 4);
    line.pass(500);
    assert!((line.servo().position() - stopped).abs() < 1.0);
    assert_eq!(line.write_2(1, 98, &[0]), 0);
    assert_eq!(line.write_2(1, 116, &goal(4000)), 0);
    line.pass(500);
    assert!(line.servo().position() > stopped + 50.0);
}

#[test]
fn modes_of_an_x_change_what_a_goal_means() {
    let goal = |value: i32| value.to_le_bytes();
    let moved = |servo: Servo, to: i32| {
        let mut line = Line::new(vec![servo]);
        assert_eq!(line.write_2(1, 64, &[1]), 0);
        assert_eq!(line.write_2(1, 116, &goal(to)), 0);
        line.pass(3000);
        line.servo().angle()
    };
    let x = || Servo::of("XL430-W250", 1, 2048.0);
    let near = |angle: f64, expected: f64| {
        assert!((angle - expected).abs() < 0.1, "{angle} {expected}");
    };
    near(moved(x(), 3072), 90.0);
    // Reverse mode, homing offset (ignored beyond a quarter of a turn), extended position control.
    near(moved(x().with(10, 1), 3072), -90.0);
    near(moved(x().with(20, 512), 3072), 45.0);
    near(moved(x().with(20, 1025), 3072), 90.0);
    near(moved(x().with(11, 4), 6144), 360.0);
    near(moved(x().with(11, 16), 3072), 0.0);
    // Time-based profile: a quarter of a turn in 2 s.
    let mut line = Line::new(vec![x().with(10, 4)]);
    line.write_2(1, 112, &goal(2000));
    line.write_2(1, 64, &[1]);
    line.write_2(1, 116, &goal(3072));
    line.pass(1000);
    let half = line.servo().angle();
    assert!((42.0..46.0).contains(&half), "{half}");
}

#[test]
fn a_hot_x_shuts_down_until_it_is_restarted() {
    let mut line = Line::new(vec![Servo::of("XL430-W250", 1, 2048.0)]);
    line.write_2(1, 64, &[1]);
    line.bus.overheat(1);
    line.pass(4000);
    assert!(!line.servo().has_torque());
    assert_eq!(line.servo().register(70, 1), Some(1 << 2));
    // Result fail, and the alert bit.
    assert_eq!(line.write_2(1, 64, &[1]), 0x81);
    assert!(!line.servo().has_torque());
}

#[test]
fn an_sts_clips_goals_to_its_own_limits_and_keeps_what_is_unlocked() {
    let limits = Servo::of("STS3215", 1, 2048.0).with(9, 2000).with(11, 2096);
    let mut line = Line::new(vec![limits]);
    assert!(!line.servo().has_torque());
    assert_eq!(line.write_1(1, 42, &[0xB8, 0x0B]), 0);
    assert_eq!(line.servo().goal(), 2096.0);
    assert!(line.servo().has_torque());
    // With the lock, an identity lasts until the power goes off.
    line.write_1(1, 5, &[7]);
    assert_eq!(line.servo().id(), 7);
    line.bus.reset(7);
    assert_eq!(line.servo().id(), 1);
    line.write_1(1, 55, &[0]);
    line.write_1(1, 5, &[7]);
    line.bus.reset(7);
    assert_eq!(line.servo().id(), 7);

    // Offset, bit 11 of which is the sign, and 128: here is 2048.
    let mut line = Line::new(vec![Servo::of("STS3215", 1, 2048.0)]);
    line.write_1(1, 31, &[100, 0]);
    line.pass(2);
    assert_eq!(line.servo().register(56, 2), Some(1948));
    line.write_1(1, 31, &[100, 8]);
    line.pass(2);
    assert_eq!(line.servo().register(56, 2), Some(2148));
    line.bus.turn(1, 45.0);
    line.pass(2);
    assert_eq!(line.servo().register(56, 2), Some(2660));
    line.write_1(1, 40, &[128]);
    line.pass(2);
    assert_eq!(line.servo().register(56, 2), Some(2048));
}

/// "Overload torque 80 %, protection time 2 s, then holding torque 20 %".
#[test]
fn a_blocked_sts_gives_way_after_two_seconds() {
    let mut line = Line::new(vec![Servo::of("STS3215", 1, 2048.0)]);
    line.write_1(1, 42, &[0xB8, 0x0B]);
    line.bus.block(1);
    line.pass(1900);
    assert_eq!(line.servo().torque_limit(), 1.0);
    line.pass(200);
    assert_eq!(line.servo().torque_limit(), 0.2);
    assert_eq!(line.hex("FF FF 01 02 01 FB"), "FF FF 01 02 20 DC");
}

/// "Once in the timeout mode, moteus will only leave it upon receiving a stop command."
#[test]
fn only_a_stop_ends_the_time_out_of_a_moteus() {
    let mut line = Line::new(vec![Servo::of("moteus-mj5208", 1, 500_000.0)]);
    // Mode 10 to half a turn with a velocity limit of 0.5 turns/s; the time-out is the default, 0.1 s.
    let go = "can send 0001 01000A0D200000003F0D280000003F\n";
    line.send(go.as_bytes());
    line.pass(90);
    assert_eq!(line.servo().mode(), Some(10));
    line.pass(30);
    assert_eq!(line.servo().mode(), Some(11));
    assert!(!line.servo().has_torque());
    let stopped = line.servo().angle();
    assert!((5.0..25.0).contains(&stopped), "{stopped}");
    line.send(go.as_bytes());
    line.pass(50);
    assert_eq!(line.servo().mode(), Some(11));
    assert!((line.servo().angle() - stopped).abs() < 1.0);
    line.send(b"can send 0001 010000\n");
    assert_eq!(line.servo().mode(), Some(0));
    line.send(go.as_bytes());
    assert_eq!(line.servo().mode(), Some(10));
    // What a command does not state has its default: here neither limit, nor a time-out (NaN).
    line.send(b"can send 0001 01000A0D200000003F0D270000C07F\n");
    assert_eq!(line.servo().speed_limit(), f64::INFINITY);
    line.pass(5000);
    assert_eq!(line.servo().mode(), Some(10));
    assert!((line.servo().angle() - 180.0).abs() < 0.1);
}

#[test]
fn an_lx_keeps_its_limits_and_unloads_when_it_is_hot() {
    let mut line = Line::new(vec![Servo::of("LX-16A", 1, 500.0)]);
    // Limits 400 to 600; the smaller one must come first.
    line.lx(1, 20, &[0x90, 1, 0x58, 2]);
    line.lx(1, 20, &[0x58, 2, 0x90, 1]);
    assert_eq!(line.lx(1, 21, &[])[5..9], [0x90, 1, 0x58, 2]);
    line.lx(1, 1, &[0xE8, 3, 0, 0]);
    line.pass(2000);
    assert!((line.servo().position() - 600.0).abs() < 1.0);
    // Beyond 1000, no move at all.
    line.lx(1, 1, &[0xE9, 3, 0, 0]);
    assert_eq!(line.servo().goal(), 1000.0);
    line.bus.overheat(1);
    line.pass(4000);
    assert!(!line.servo().has_torque());
    assert_eq!(line.lx(1, 32, &[])[5], 0);

    // A move that waits, and a stop in the middle of it.
    let mut line = Line::new(vec![Servo::of("HTS-35H", 1, 500.0)]);
    line.lx(1, 7, &[0xE8, 3, 0xE8, 3]);
    line.pass(1000);
    assert!(!line.servo().has_torque());
    line.lx(254, 11, &[]);
    line.pass(500);
    line.lx(1, 12, &[]);
    line.pass(500);
    let stopped = line.servo().position();
    assert!((700.0..760.0).contains(&stopped), "{stopped}");
}
