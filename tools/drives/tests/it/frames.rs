//! Frames: the examples of the makers' manuals, and streams of damaged bytes.

use tip_drives::frame::{Decoder, Protocol, Reads, instruction};

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
