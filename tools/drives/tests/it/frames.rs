//! Frames: the examples of the makers' manuals, and streams of damaged bytes.

use std::convert::Infallible;
use tip_drives::bus::{Bus, Port, Timing};
use tip_drives::dynamixel1::{AX, Protocol1};
use tip_drives::dynamixel2::Protocol2;
use tip_drives::family::{Family, Query, Setpoint};
use tip_drives::feetech::STS;
use tip_drives::frame::{Decoder, Frame, Parsed};
use tip_drives::lx;
use tip_drives::model::Model;
use tip_drives::moteus;
use tip_drives::registers::{Framing, instruction};

/// Instruction of a ping.
const PING: u8 = 1;

#[test]
fn requests_are_those_of_the_manuals() {
    let ping = Protocol1.request(1, PING, &[]);
    assert_eq!(ping.unwrap(), [0xFF, 0xFF, 0x01, 0x02, 0x01, 0xFB]);
    let read = Protocol1.request(1, instruction::READ, &[0x2B, 1]);
    let bytes = [0xFF, 0xFF, 0x01, 0x04, 0x02, 0x2B, 0x01, 0xCC];
    assert_eq!(read.unwrap(), bytes);
    let ping = Protocol2.request(1, PING, &[]);
    let bytes = [0xFF, 0xFF, 0xFD, 0, 0x01, 0x03, 0, 0x01, 0x19, 0x4E];
    assert_eq!(ping.unwrap(), bytes);
    let read = Protocol2.request(1, instruction::READ, &[132, 0, 4, 0]);
    let bytes = [
        0xFF, 0xFF, 0xFD, 0, 0x01, 0x07, 0, 0x02, 0x84, 0, 0x04, 0, 0x1D, 0x15,
    ];
    assert_eq!(read.unwrap(), bytes);
    // Servo 1 to 500 in 1000 ms, and its supply voltage.
    let bytes = [0x55, 0x55, 1, 7, 1, 0xF4, 0x01, 0xE8, 0x03, 0x16];
    assert_eq!(lx::request(1, 1, &[0xF4, 0x01, 0xE8, 0x03]), bytes);
    let bytes = [0x55, 0x55, 1, 3, 0x1B, 0xE0];
    assert_eq!(lx::request(1, lx::command::VIN_READ, &[]), bytes);
}

/// A port that keeps what is sent, and gives the same answer to each request.
struct Recorded {
    sent: Vec<u8>,
    answer: &'static [u8],
    left: &'static [u8],
    now: u64,
}

impl embedded_io::ErrorType for Recorded {
    type Error = Infallible;
}

impl embedded_io::Read for Recorded {
    fn read(&mut self, into: &mut [u8]) -> Result<usize, Infallible> {
        let count = into.len().min(self.left.len());
        into[..count].copy_from_slice(&self.left[..count]);
        self.left = &self.left[count..];
        Ok(count)
    }
}

impl embedded_io::Write for Recorded {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        self.sent.extend(bytes);
        self.left = self.answer;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl Port for Recorded {
    fn now(&mut self) -> u64 {
        self.now
    }

    fn wait(&mut self, until: u64) -> Result<bool, Infallible> {
        if self.left.is_empty() {
            self.now = self.now.max(until);
        }
        Ok(!self.left.is_empty())
    }
}

fn recorded(answer: &'static [u8]) -> Bus<Recorded> {
    let port = Recorded {
        sent: Vec::new(),
        answer,
        left: &[],
        now: 0,
    };
    let timing = Timing {
        baud: 1_000_000,
        return_delay: 0,
        latency: 1000,
    };
    Bus::new(port, timing)
}

/// The exchange of "AX-12 User's Manual", example 8: model 116 and firmware 8.
#[test]
fn a_model_number_is_asked_for_as_in_the_manual() {
    let mut bus = recorded(&[0xFF, 0xFF, 0x01, 0x05, 0x00, 0x74, 0x00, 0x08, 0x7D]);
    assert_eq!(AX.identify(&mut bus, 1), Ok(Some(116)));
    let request = [0xFF, 0xFF, 0x01, 0x04, 0x02, 0x00, 0x03, 0xF5];
    assert_eq!(bus.port().sent, request);
}

/// The sync read of Feetech's protocol manual: eight bytes from 0x38 of servos 1 and 2. The answer is in the middle, at rest, with
/// 12.1 V and 30 °C.
#[test]
fn many_sts_are_read_as_in_the_manual() {
    let mut bus = recorded(&[
        0xFF, 0xFF, 0x01, 0x0A, 0x00, 0x00, 0x08, 0x00, 0x00, 0x00, 0x00, 0x79, 0x1E, 0x55,
    ]);
    let servos = [1, 2].map(|id| Query {
        id,
        turn: 0,
        is_late: false,
    });
    let mut found = Vec::new();
    let asked = STS.read(&mut bus, &servos, u64::MAX, false, &mut |place, reading| {
        let values = (reading.position, reading.load, reading.voltage);
        found.push((place, values, reading.temperature));
    });
    assert_eq!(asked, Ok(2));
    assert_eq!(found, [(0, (2048, Some(0), Some(12.1)), Some(30.0))]);
    let request = [0xFF, 0xFF, 0xFE, 0x06, 0x82, 0x38, 0x08, 0x01, 0x02, 0x36];
    assert_eq!(bus.port().sent, request);
}

/// A move of servo 1 to 500 in 1000 ms. Its time is the sampling time.
#[test]
fn a_move_of_an_lx_takes_the_sampling_time() {
    let mut bus = recorded(&[]);
    let setpoint = Setpoint {
        id: 1,
        model: Model::named("LX-16A").unwrap(),
        position: 500,
        speed: 180.0,
        torque: 1.0,
        period: 1000.0,
        timeout: None,
    };
    lx::LX.write_goals(&mut bus, &[setpoint]).unwrap();
    let request = [0x55, 0x55, 1, 7, 1, 0xF4, 0x01, 0xE8, 0x03, 0x16];
    assert_eq!(bus.port().sent, request);
}

/// Returns the frame in a stream of bytes.
fn decoded(bytes: &[u8], parse: &dyn Fn(&[u8]) -> Parsed) -> Option<Frame> {
    let mut decoder = Decoder::new();
    bytes.iter().for_each(|byte| decoder.push(*byte));
    let found = decoder.next(parse);
    found.or_else(|| decoder.next_after_silence(parse))
}

#[test]
fn an_answer_is_that_of_the_manual() {
    let bytes = [
        0xFF, 0xFF, 0xFD, 0, 0x01, 0x08, 0, 0x55, 0, 0xA6, 0, 0, 0, 0x8C, 0xC0,
    ];
    let frame = decoded(&bytes, &|bytes| Protocol2.parse(bytes, 4)).unwrap();
    assert_eq!((frame.id, frame.code), (1, 0));
    assert_eq!(frame.parameters, [0xA6, 0, 0, 0]);
}

/// Returns an answer of each kind of frame with 8 bytes of parameters, and the parser for it.
type Parser = fn(&[u8]) -> Parsed;
fn answers(id: u8, parameters: [u8; 8]) -> [(Vec<u8>, Parser); 3] {
    let answer_2 = || {
        let mut parameters = parameters.to_vec();
        // The error byte.
        parameters.insert(0, 0);
        Protocol2.request(id, 0x55, &parameters).unwrap().to_vec()
    };
    [
        (
            Protocol1.request(id, 0, &parameters).unwrap().to_vec(),
            |bytes| Protocol1.parse(bytes, 8),
        ),
        (answer_2(), |bytes| Protocol2.parse(bytes, 8)),
        (lx::request(id, 28, &parameters).to_vec(), |bytes| {
            lx::parse(bytes, 28, 8)
        }),
    ]
}

#[test]
fn headers_inside_of_a_message_are_stuffed() {
    for parameters in [
        &[0, 0xFF, 0xFF, 0xFD, 1][..],
        &[0, 0xFF, 0xFF, 0xFD, 0xFD, 0],
        &[0, 0xFF, 0xFF, 0xFF, 0xFD, 0xFF, 0xFF, 0xFD],
    ] {
        let frame = Protocol2.request(7, 0x55, parameters).unwrap();
        let header = frame.windows(4).skip(1);
        assert!(!header.clone().any(|it| it == [0xFF, 0xFF, 0xFD, 0]));
        let found = decoded(&frame, &|bytes| {
            Protocol2.parse(bytes, parameters.len() - 1)
        });
        assert_eq!(found.unwrap().parameters, parameters[1..]);
    }
}

/// The answer of controller 1 to sender 0x70: mode 10, half a turn, 1 Nm, 24 V, 31 °C, no fault, identity 1, and again its
/// position, which is one count more by then.
const ANSWER: &str =
    "rcv 0170 21000A290150C3000025036400250DF000220E1F002590020100290151C30000 B F";

#[test]
fn requests_to_a_moteus_are_those_of_its_protocol() {
    // Sender 0x70, an answer is wanted; 8-bit mode, 32-bit position, 16-bit torque and voltage, two 8-bit registers from 0x00E,
    // 16-bit identity 0x110, 32-bit position; filled up to 16 bytes.
    let line = moteus::query(1, 0x70);
    let text = "can send f001 110019011503150D120E159002190150 BF\n";
    assert_eq!(str::from_utf8(&line), Ok(text));

    let stop = moteus::stop(2, 0x70, false);
    assert_eq!(str::from_utf8(&stop), Ok("can send 7002 010000 BF\n"));
    // Mode 10; floats: position 0.5, maximum torque 0.5 Nm, time-out 0.2 s and velocity limit 0.5 turns/s; filled up to 32 bytes.
    let setpoint = Setpoint {
        id: 2,
        model: Model::named("moteus-mj5208").unwrap(),
        position: 550_000,
        speed: 180.0,
        // Of 1.7 Nm.
        torque: 0.5 / 1.7,
        period: 20.0,
        timeout: Some(200.0),
    };
    let line = moteus::command(&setpoint, 0x70, false);
    let text =
        "can send 7002 01000A0D200000003F0D250000003F0E27CDCC4C3E0000003F50505050505050 BF\n";
    assert_eq!(str::from_utf8(&line), Ok(text));
}

#[test]
fn an_answer_of_a_moteus_proves_itself() {
    let line = ANSWER.to_owned();
    let (answer, to) = moteus::answer(line.as_bytes()).expect("intact");
    assert_eq!(to, 0x70);
    let right = moteus::Answer {
        id: 1,
        is_on: true,
        // A half turn from the middle of ten.
        position: 550_000,
        torque: 100,
        voltage: 240,
        temperature: 31,
        fault: 0,
    };
    assert_eq!(answer, right);
    for (good, bad) in [
        // Another controller, another identity, positions that differ, a missing register, another register.
        ("rcv 0170", "rcv 0270"),
        ("2590020100", "2590020200"),
        ("290151C3", "290171C3"),
        ("290151C30000", ""),
        ("250DF000", "250EF000"),
    ] {
        let damaged = line.replace(good, bad);
        assert_ne!(damaged, line);
        assert_eq!(moteus::answer(damaged.as_bytes()), None, "{damaged}");
    }
    // A checksum is not needed, but a wrong one is not believed.
    let sum = moteus_protocol_sum(&line);
    assert!(moteus::answer(format!("{line} *{sum:02X}").as_bytes()).is_some());
    assert!(moteus::answer(format!("{line} *{:02X}", sum ^ 1).as_bytes()).is_none());
}

/// Returns the checksum of a line: CRC-8 with the polynomial 0x97, most significant bit first, over everything before the star.
fn moteus_protocol_sum(line: &str) -> u8 {
    line.bytes().chain([b' ']).fold(0, |crc, byte| {
        (0..8).fold(crc ^ byte, |crc: u8, _| match crc >> 7 {
            0 => crc << 1,
            _ => crc << 1 ^ 0x97,
        })
    })
}

/// No damage of up to four bytes in a row gives a wrong angle, and none stops the reader.
#[test]
fn damaged_answers_of_a_moteus_give_no_wrong_angle() {
    let line = ANSWER.as_bytes().to_vec();
    let mut random = 1_u64;
    let mut next = move || {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (random >> 40) as usize
    };
    let mut accepted = 0;
    for _ in 0..1_000_000 {
        let mut damaged = line.clone();
        let first = next() % line.len();
        for byte in damaged.iter_mut().skip(first).take(1 + next() % 4) {
            // Mostly characters that may be there.
            *byte = match next() % 4 {
                0 => next() as u8,
                _ => b"0123456789ABCDEF"[next() % 16],
            };
        }
        if let Some((answer, _)) = moteus::answer(&damaged) {
            accepted += 1;
            let difference = answer.position.abs_diff(550_000);
            assert!(answer.id == 1 && difference <= 2 * moteus::BETWEEN);
        }
    }
    assert!(accepted > 100_000, "{accepted}");
}

/// A frame that is cut off in the middle must not hide the next one.
#[test]
fn an_intact_frame_is_found_after_any_beginning_of_another() {
    let lost = answers(3, [1, 2, 3, 4, 5, 6, 7, 8]);
    let next = answers(4, [8, 7, 6, 5, 4, 3, 2, 1]);
    for ((lost, _), (next, parse)) in lost.iter().zip(&next) {
        for length in 0..lost.len() {
            let bytes = [&lost[..length], next].concat();
            let found = decoded(&bytes, parse);
            assert_eq!(found.unwrap().id, 4, "{next:?} {length}");
        }
    }
}

/// Neither a flipped bit nor another byte passes as a frame, in any place.
#[test]
fn no_single_damage_passes() {
    for (good, parse) in answers(3, [0x34, 0x02, 0, 0, 0, 0, 120, 31]) {
        for place in 0..good.len() {
            for change in 1..=255 {
                let mut bytes = good.clone();
                bytes[place] ^= change;
                assert_eq!(decoded(&bytes, &parse), None, "{good:?} {place} {change}");
            }
        }
    }
}

#[test]
fn noise_is_bounded_and_never_panics() {
    let mut random = 1_u64;
    for (good, parse) in answers(3, [0; 8]) {
        let mut decoder = Decoder::new();
        let mut found = 0;
        for _ in 0..300_000 {
            random = random
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            // Many bytes of headers, so that frames seem to begin.
            let byte = match random >> 60 {
                0..6 => good[0],
                6..8 => 0xFD,
                8..10 => (random >> 56 & 15) as u8,
                _ => (random >> 40) as u8,
            };
            decoder.push(byte);
            found += u32::from(decoder.next(&parse).is_some());
        }
        // A checksum of 8 bits lets some noise pass.
        assert!(found < 100, "{good:?}: {found}");
    }
}
