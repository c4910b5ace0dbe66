//! Frames: the examples of the makers' manuals, and streams of damaged bytes.

use tip_drives::frame::{Decoder, Protocol, Reads, instruction};
use tip_drives::moteus::{self, address};

const ALL: [Protocol; 3] = [
    Protocol::Dynamixel1,
    Protocol::Dynamixel2,
    Protocol::Feetech,
];

#[test]
fn requests_are_those_of_the_manuals() {
    let ping = Protocol::Dynamixel1.request(1, instruction::PING, &[]);
    assert_eq!(ping.unwrap(), [0xFF, 0xFF, 0x01, 0x02, 0x01, 0xFB]);
    let read = Protocol::Dynamixel1.request(1, instruction::READ, &[0x2B, 1]);
    let bytes = [0xFF, 0xFF, 0x01, 0x04, 0x02, 0x2B, 0x01, 0xCC];
    assert_eq!(read.unwrap(), bytes);
    let ping = Protocol::Dynamixel2.request(1, instruction::PING, &[]);
    let bytes = [0xFF, 0xFF, 0xFD, 0, 0x01, 0x03, 0, 0x01, 0x19, 0x4E];
    assert_eq!(ping.unwrap(), bytes);
    let read = Protocol::Dynamixel2.request(1, instruction::READ, &[132, 0, 4, 0]);
    let bytes = [
        0xFF, 0xFF, 0xFD, 0, 0x01, 0x07, 0, 0x02, 0x84, 0, 0x04, 0, 0x1D, 0x15,
    ];
    assert_eq!(read.unwrap(), bytes);
}

#[test]
fn an_answer_is_that_of_the_manual() {
    let bytes = [
        0xFF, 0xFF, 0xFD, 0, 0x01, 0x08, 0, 0x55, 0, 0xA6, 0, 0, 0, 0x8C, 0xC0,
    ];
    let mut decoder = Decoder::new(Protocol::Dynamixel2);
    bytes.iter().for_each(|byte| decoder.push(*byte));
    let frame = decoder.next(Reads::Answers(4)).unwrap();
    assert_eq!((frame.id, frame.code), (1, 0));
    assert_eq!(frame.parameters, [0xA6, 0, 0, 0]);
}

#[test]
fn headers_inside_of_a_message_are_stuffed() {
    for parameters in [
        &[0xFF, 0xFF, 0xFD, 1][..],
        &[0xFF, 0xFF, 0xFD, 0xFD, 0],
        &[0xFF, 0xFF, 0xFF, 0xFD, 0xFF, 0xFF, 0xFD],
    ] {
        let frame = Protocol::Dynamixel2.answer(7, 0, parameters).unwrap();
        let header = frame.windows(4).skip(1);
        assert!(!header.clone().any(|it| it == [0xFF, 0xFF, 0xFD, 0]));
        let mut decoder = Decoder::new(Protocol::Dynamixel2);
        frame.iter().for_each(|byte| decoder.push(*byte));
        let found = decoder.next(Reads::Answers(parameters.len()));
        assert_eq!(found.unwrap().parameters, parameters);
        assert_eq!(decoder.discarded(), 0);
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

    let mut command = moteus::Command::default();
    // Nothing is sent before the torque is on, except the stop that ends a time-out.
    assert!(command.set(address::WATCHDOG, 0));
    let stop = command.line(2, 0x70, false);
    assert_eq!(str::from_utf8(&stop), Ok("can send 7002 010000 BF\n"));
    assert!(!command.set(address::WATCHDOG, 10));
    assert!(!command.set(address::TORQUE_LIMIT, 50));
    assert!(!command.set(address::GOAL_SPEED, 180));
    assert!(!command.set(address::GOAL_POSITION, 550_000));
    assert!(command.set(address::TORQUE_ENABLE, 1));
    // Mode 10; floats: position 0.5, maximum torque 0.5 Nm, time-out 0.2 s and velocity limit 0.5 turns/s; filled up to 32 bytes.
    let line = command.line(2, 0x70, false);
    let text =
        "can send 7002 01000A0D200000003F0D250000003F0E27CDCC4C3E0000003F50505050505050 BF\n";
    assert_eq!(str::from_utf8(&line), Ok(text));
}

#[test]
fn an_answer_of_a_moteus_proves_itself() {
    let line = ANSWER.to_owned();
    let answer = moteus::answer(line.as_bytes()).expect("intact");
    assert_eq!((answer.id, answer.to, answer.is_faulty), (1, 0x70, false));
    // A half turn from the middle of ten.
    let mut table = [0, 0, 1, 1, 0, 0, 0, 0, 100, 0, 240, 0, 31, 0];
    table[4..8].copy_from_slice(&550_000_i32.to_le_bytes());
    assert_eq!(answer.table, table);
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

/// Returns the position of an answer's table.
fn position(answer: &moteus::Answer) -> i32 {
    i32::from_le_bytes([4, 5, 6, 7].map(|place: usize| answer.table[place]))
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
        if let Some(answer) = moteus::answer(&damaged) {
            accepted += 1;
            let difference = position(&answer).abs_diff(550_000);
            assert!(answer.id == 1 && difference <= 2 * moteus::BETWEEN);
        }
    }
    assert!(accepted > 100_000, "{accepted}");
}

/// A frame that is cut off in the middle must not hide the next one.
#[test]
fn an_intact_frame_is_found_after_any_beginning_of_another() {
    for protocol in ALL {
        let lost = protocol.answer(3, 0, &[1, 2, 3, 4, 5, 6, 7, 8]).unwrap();
        let next = protocol.answer(4, 0, &[8, 7, 6, 5, 4, 3, 2, 1]).unwrap();
        for length in 0..lost.len() {
            let mut decoder = Decoder::new(protocol);
            for byte in lost[..length].iter().chain(&next) {
                decoder.push(*byte);
            }
            let reads = Reads::Answers(8);
            let found = decoder.next(reads);
            let found = found.or_else(|| decoder.next_after_silence(reads));
            assert_eq!(found.unwrap().id, 4, "{protocol:?} {length}");
        }
    }
}

/// Neither a flipped bit nor another byte passes as a frame, in any place.
#[test]
fn no_single_damage_passes() {
    for protocol in ALL {
        let good = protocol.answer(3, 0, &[0x34, 0x02, 0, 0, 0, 0, 120, 31]);
        let good = good.unwrap();
        for place in 0..good.len() {
            for change in 1..=255 {
                let mut bytes = good.clone();
                bytes[place] ^= change;
                let mut decoder = Decoder::new(protocol);
                bytes.iter().for_each(|byte| decoder.push(*byte));
                let reads = Reads::Answers(8);
                let found = decoder.next(reads);
                let found = found.or_else(|| decoder.next_after_silence(reads));
                assert_eq!(found, None, "{protocol:?} {place} {change}");
            }
        }
    }
}

#[test]
fn noise_is_bounded_and_never_panics() {
    let mut random = 1_u64;
    for protocol in ALL {
        let mut decoder = Decoder::new(protocol);
        let mut found = 0;
        for _ in 0..300_000 {
            random = random
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            // Many bytes of headers, so that frames seem to begin.
            let byte = match random >> 60 {
                0..6 => 0xFF,
                6..8 => 0xFD,
                8..10 => (random >> 56 & 15) as u8,
                _ => (random >> 40) as u8,
            };
            decoder.push(byte);
            found += u32::from(decoder.next(Reads::Answers(8)).is_some());
        }
        // A checksum of 8 bits lets some noise pass.
        assert!(found < 100, "{protocol:?}: {found}");
    }
}
