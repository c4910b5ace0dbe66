//! Round trips of the vocabulary between values and words.

extern crate std;

use super::{Flag, Op, Port, Target};
use core::fmt::{Debug, Display};
use core::str::FromStr;
use std::string::ToString;

/// Asserts that `thing` prints as `word` and is parsed from it.
fn is_spelled<T: Copy + Debug + Display + FromStr + PartialEq>(thing: T, word: &str) {
    assert_eq!(thing.to_string(), word);
    assert_eq!(word.parse::<T>().ok(), Some(thing), "{word}");
}

fn is_refused<T: Debug + FromStr>(words: &[&str]) {
    for word in words {
        let read = word.parse::<T>().ok();
        assert!(read.is_none(), "{word}: {read:?}");
    }
}

#[test]
fn targets_are_feet_joints_all_and_the_slider() {
    is_spelled(Target::All, "ALL");
    is_spelled(Target::Floor, "FLOOR");
    for leg in 1..=9 {
        is_spelled(Target::Foot(leg), &["F", &leg.to_string()].concat());
        for joint in 1..=9 {
            let digits = (10 * leg + joint).to_string();
            is_spelled(Target::Joint(leg, joint), &["J", &digits].concat());
        }
    }
    is_refused::<Target>(&[
        "", "F", "F0", "F10", "J1", "J10", "J01", "J111", "f1", "all", "ALL ", "FLOORS",
    ]);
    assert_eq!(Target::None.to_string(), "");
}

// clauses: 7.32
#[test]
fn inputs_are_knobs_soles_joints_and_the_feeler() {
    for (port, word) in [
        (Port::Knob(1), "VR1"),
        (Port::Knob(3), "VR3"),
        (Port::Paw(1), "PAW1"),
        (Port::Paw(4), "PAW4"),
        (Port::Joint(4, 3), "J43"),
        (Port::Antenna, "ANTENNA"),
    ] {
        is_spelled(port, word);
    }
    is_refused::<Port>(&[
        "",
        "VR",
        "VR0",
        "VR4",
        "VR11",
        "PAW0",
        "PAW5",
        "J1",
        "J10",
        "F1",
        "ALL",
        "ANTENNA1",
        "ANTENNA_ON",
        "13",
        "vr1",
    ]);
    assert_eq!(Port::Channel(13).to_string(), "13");
}

#[test]
fn every_named_input_is_read_from_its_word() {
    let kinds = [
        Port::Channel(0),
        Port::Joint(1, 1),
        Port::Knob(1),
        Port::Paw(1),
        Port::Antenna,
    ];
    let words: std::vec::Vec<_> = kinds
        .into_iter()
        .flat_map(Port::named)
        .inspect(|port| is_spelled(*port, &port.to_string()))
        .map(|port| port.to_string())
        .collect();
    let expected = [
        "VR1", "VR2", "VR3", "PAW1", "PAW2", "PAW3", "PAW4", "ANTENNA",
    ];
    assert_eq!(words, expected);
}

#[test]
fn flags_name_what_they_await() {
    for (flag, word) in [
        (Flag::HaltRequest, "HALT_REQUEST"),
        (Flag::KbHit, "KB_HIT"),
        (Flag::Antenna, "ANTENNA_ON"),
        (Flag::Inpos(Target::All), "INPOS_ALL"),
        (Flag::Inpos(Target::Foot(9)), "INPOS_F9"),
        (Flag::Near(Target::Joint(1, 1)), "NEAR_J11"),
        (Flag::Special(0), "SPECIAL_FLAG0"),
        (Flag::Special(9), "SPECIAL_FLAG9"),
    ] {
        is_spelled(flag, word);
    }
    is_refused::<Flag>(&[
        "",
        "INPOS",
        "INPOS_",
        "INPOS_FLOOR",
        "NEAR_FLOOR",
        "INPOS_5",
        "NEAR_",
        "SPECIAL_FLAG",
        "SPECIAL_FLAG10",
        "SPECIAL_FLAGF1",
        "ANTENNA",
        "KB_HITS",
        "kb_hit",
    ]);
}

#[test]
fn every_command_is_read_from_its_name() {
    for op in Op::ALL {
        is_spelled(*op, op.name());
    }
    assert_eq!("PTP".parse(), Ok(Op::Ptp));
    is_refused::<Op>(&["", "ptp", "PTP ", "WAIT_IN_POS"]);
}
