//! The event flags of conditions (T.I.P. 3.1 §6-2).

use super::commands::Robots;
use super::{Bilingual, Edition};
use std::mem::discriminant;
use tip_runtime::command::{Flag, Port, Target};

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The flag; of a family, one of its members. `Display` gives its word.
    pub flag: Flag,
    /// The first edition that has it.
    pub since: Edition,
    /// The robots that have it.
    pub robots: Robots,
    /// Outside cause that makes it true.
    pub cause: Cause,
    /// The section of T.I.P. that describes it.
    pub section: &'static str,
    /// The clause of the language reference.
    pub clause: &'static str,
    /// One line for the reference.
    pub description: Bilingual,
}

/// Cause that makes a flag true.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// Someone asks the program to stop.
    Halt,
    /// Someone presses a key.
    Key,
    /// An input.
    Input(Port),
    /// The robot itself.
    Robot,
}

/// Every flag, families as one.
pub const FLAGS: &[Row] = &[
    Row::new(
        Flag::HaltRequest,
        "Somebody asked the program to stop at a good moment.",
        "切りのよいところで停止するよう求められています。",
    )
    .caused_by(Cause::Halt),
    Row::new(
        Flag::KbHit,
        "The keyboard buffer is not empty.",
        "キーボードのバッファにキーがあります。",
    )
    .caused_by(Cause::Key),
    Row::new(
        Flag::Antenna,
        "The palm touches something.",
        "手のひらが何かに触れています。",
    )
    .only(Robots::HAND)
    .caused_by(Cause::Input(Port::Antenna)),
    Row::new(
        Flag::Inpos(Target::All),
        "The target has arrived within the JUST tolerance.",
        "JUSTの許容誤差以内で到着しています。",
    ),
    Row::new(
        Flag::Near(Target::All),
        "The target has arrived within the NEAR tolerance.",
        "NEARの許容誤差以内に近づいています。",
    ),
    Row::new(
        Flag::Special(0),
        "Native code of a SPECIAL command set it.",
        "SPECIALコマンドのネイティブコードが立てるフラグです。",
    ),
];

impl Row {
    /// Creates a flag of 3.1 that every robot has and sets itself.
    const fn new(flag: Flag, english: &'static str, japanese: &'static str) -> Self {
        Row {
            flag,
            since: Edition::V3_1,
            robots: Robots::ALL,
            cause: Cause::Robot,
            section: "§6-2",
            clause: "5.1",
            description: Bilingual { english, japanese },
        }
    }

    const fn only(self, robots: Robots) -> Self {
        Row { robots, ..self }
    }

    const fn caused_by(self, cause: Cause) -> Self {
        Row { cause, ..self }
    }

    /// Returns its word; of a family, what its words begin with.
    pub const fn word(&self) -> &'static str {
        self.flag.stem()
    }

    /// Returns true if a target or a number follows its word.
    pub fn is_family(&self) -> bool {
        self.flag.to_string() != self.word()
    }
}

/// Returns the row of a flag.
pub fn row(flag: Flag) -> Option<&'static Row> {
    let mut rows = FLAGS.iter();
    rows.find(|row| discriminant(&row.flag) == discriminant(&flag))
}

/// Returns the flag that an edition writes so, in capital letters, and its row.
pub fn find(word: &str, edition: Edition) -> Option<(Flag, &'static Row)> {
    let flag = word.parse().ok()?;
    let row = row(flag).filter(|row| row.since <= edition)?;
    Some((flag, row))
}

/// Returns the words that are not families.
pub fn words() -> impl Iterator<Item = &'static str> {
    FLAGS.iter().filter(|row| !row.is_family()).map(Row::word)
}

/// Returns the first letters of the words of each family.
pub fn families() -> impl Iterator<Item = &'static str> {
    FLAGS.iter().filter(|row| row.is_family()).map(Row::word)
}

#[cfg(test)]
mod tests {
    use super::{families, find, words};
    use crate::language::Edition;

    // clauses: 5.1
    #[test]
    fn the_flags_are_those_of_the_reference() {
        let alone: Vec<&str> = words().collect();
        assert_eq!(alone, ["HALT_REQUEST", "KB_HIT", "ANTENNA_ON"]);
        let members: Vec<&str> = families().collect();
        assert_eq!(members, ["INPOS_", "NEAR_", "SPECIAL_FLAG"]);
        for word in ["HALT_REQUEST", "INPOS_J11", "NEAR_F9", "SPECIAL_FLAG9"] {
            let (flag, row) = find(word, Edition::V3_1).expect("a flag");
            assert_eq!(flag.to_string(), word);
            assert!(word.starts_with(row.word()));
        }
        for word in ["INPOS_FLOOR", "IN_POS_FLOOR", "IN_POS", "IN_NEAR_F1"] {
            assert!(find(word, Edition::V3_1).is_none(), "{word}");
        }
        for target in ["F1", "J43", "ALL"] {
            let flag = |stem| find(&format!("{stem}{target}"), Edition::V3_1).map(|(flag, _)| flag);
            assert!(flag("IN_POS_").is_some());
            assert_eq!(flag("IN_POS_"), flag("INPOS_"), "{target}");
        }
    }
}
