//! Words that are not commands, functions, flags or inputs, and which words nothing may have as a name (T.I.P. 3.1 §4).

use super::{Bilingual, Edition, commands, flags, functions, inputs, keywords};
use tip_runtime::command::{self, CONSTANT, Reading, Target};

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The word; of a family, what its words begin with.
    pub word: &'static str,
    /// Kind of the word.
    pub kind: Kind,
    /// The first edition that has it.
    pub since: Edition,
    /// The section of T.I.P. that describes it.
    pub section: &'static str,
    /// The clause of the language reference.
    pub clause: &'static str,
    /// One line for the reference.
    pub description: Bilingual,
}

/// Kind of a word of the language.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A target of commands; of feet and joints, one of them.
    Target(Target),
    /// A variable that every program has.
    Variable,
    /// Ten variables that every program has; a digit follows.
    Variables,
    /// Special variables, which are read only; one of them.
    Reading(Reading),
    /// A constant.
    Constant(f64),
    /// A constant for each digit and letter: its ASCII code. The character follows.
    Characters,
    /// A flag among the arguments of motions; elsewhere a name like any other.
    MotionFlag,
    /// A label that may appear many times.
    Label,
    /// A member of a POS; of a JOINT, what its names begin with.
    Member,
}

/// The variable of KEY_IN without argument.
pub const VAR_KEY: &str = "VAR_KEY";

/// First letters of the variables that a program shares with native code: VARs, POSs, JOINTs. A digit follows.
pub const SPECIALS: [&str; 3] = ["VAR_SPECIAL_", "POS_SPECIAL_", "JNT_SPECIAL_"];

/// The label that may appear many times.
pub const LOOP: &str = "LOOP";

/// The members of a POS.
pub const POSITION: [&str; 3] = ["X", "Y", "Z"];

/// First letter of the members of a JOINT; a number follows.
pub const JOINT: &str = "J";

/// Every such word.
pub const RESERVED: &[Row] = &[
    Row::target(
        Target::All,
        "Everything that the command can act on.",
        "そのコマンドが対象にできるものすべて。",
    ),
    Row::target(
        Target::Floor,
        "The slider of the Hiroshima Hand.",
        "Hiroshima Handのスライダ。",
    ),
    Row::target(Target::Foot(1), "A foot or finger.", "足または指。"),
    Row::target(
        Target::Joint(1, 1),
        "A joint: its leg and its number.",
        "関節。脚の番号と関節の番号で表します。",
    ),
    Row::new(
        VAR_KEY,
        Kind::Variable,
        "§7-9-2",
        "3.3",
        "Receives the key of KEY_IN without argument.",
        "引数のないKEY_INのキーが入ります。",
    ),
    Row::special(
        SPECIALS[0],
        "A number that the program shares with native code of SPECIAL; a digit follows.",
        "SPECIALのネイティブコードと共有する数。数字が1桁続きます。",
    ),
    Row::special(
        SPECIALS[1],
        "A position that the program shares with native code of SPECIAL; a digit follows.",
        "SPECIALのネイティブコードと共有する位置。数字が1桁続きます。",
    ),
    Row::special(
        SPECIALS[2],
        "Joint values that the program shares with native code of SPECIAL; a digit follows.",
        "SPECIALのネイティブコードと共有する関節の値。数字が1桁続きます。",
    ),
    Row::reading(
        Reading::KINDS[0],
        "The angle of a joint, deg.",
        "関節の角度(deg)。",
    ),
    Row::reading(
        Reading::KINDS[1],
        "The torque of a joint.",
        "関節のトルク。",
    ),
    Row::reading(
        Reading::KINDS[5],
        "The contact force at a fingertip, N.",
        "指先の接触力(N)。",
    ),
    Row::reading(
        Reading::KINDS[4],
        "The position of a foot or fingertip, mm.",
        "足先または指先の位置(mm)。",
    ),
    Row::reading(
        Reading::KINDS[6],
        "The time of a timer, ms.",
        "タイマの時間(ms)。",
    ),
    Row::new(
        "CHAR_SPC",
        Kind::Constant(32.0),
        "§4-5",
        "3.3",
        "The ASCII code of the space bar.",
        "スペースキーのASCIIコード。",
    ),
    Row::new(
        CONSTANT,
        Kind::Characters,
        "§4-5",
        "3.3",
        "The ASCII code of a digit or letter.",
        "数字または英字のASCIIコード。",
    ),
    Row::new(
        command::RELATIVE,
        Kind::MotionFlag,
        "§7-1",
        "3.2",
        "The value after it counts from where the foot or joint is.",
        "続く値を、足先や関節の現在値からの相対値とします。",
    ),
    Row::new(
        command::ABSOLUTE,
        Kind::MotionFlag,
        "§7-1",
        "3.2",
        "The value after it is taken as it is.",
        "続く値を、そのままの値(絶対値)とします。",
    ),
    Row::new(
        command::FAST,
        Kind::MotionFlag,
        "§7-1",
        "3.2",
        "Lifts the limit of acceleration of a motion.",
        "動作の加速度制限をなくします。",
    ),
    Row::new(
        LOOP,
        Kind::Label,
        "§7-7-1",
        "6.2",
        "Where GOTO without a label leads: the nearest one above.",
        "ラベルのないGOTOの行き先。上にある最も近いものへ飛びます。",
    ),
    Row::new(
        POSITION[0],
        Kind::Member,
        "§4-4",
        "3.1",
        "To the right, in mm.",
        "右方向(mm)。",
    ),
    Row::new(
        POSITION[1],
        Kind::Member,
        "§4-4",
        "3.1",
        "Forward, in mm.",
        "前方向(mm)。",
    ),
    Row::new(
        POSITION[2],
        Kind::Member,
        "§4-4",
        "3.1",
        "Up, in mm.",
        "上方向(mm)。",
    ),
    Row::new(
        JOINT,
        Kind::Member,
        "§4-4",
        "3.1",
        "A joint of the leg, by its number.",
        "脚の関節。番号で表します。",
    ),
];

impl Row {
    /// Creates a word of 3.1.
    const fn new(
        word: &'static str,
        kind: Kind,
        section: &'static str,
        clause: &'static str,
        english: &'static str,
        japanese: &'static str,
    ) -> Self {
        Row {
            word,
            kind,
            since: Edition::V3_1,
            section,
            clause,
            description: Bilingual { english, japanese },
        }
    }

    /// Creates ten variables of 3.2.
    const fn special(word: &'static str, english: &'static str, japanese: &'static str) -> Self {
        Row {
            since: Edition::V3_2,
            ..Row::new(word, Kind::Variables, "§1-2-14", "13.3", english, japanese)
        }
    }

    /// Creates a special variable of 3.2.
    const fn reading(reading: Reading, english: &'static str, japanese: &'static str) -> Self {
        Row {
            since: Edition::V3_2,
            ..Row::new(
                reading.stem(),
                Kind::Reading(reading),
                "§1-2-11",
                "13.2",
                english,
                japanese,
            )
        }
    }

    /// Creates a target of 3.1.
    const fn target(target: Target, english: &'static str, japanese: &'static str) -> Self {
        let kind = Kind::Target(target);
        Row::new(target.stem(), kind, "§4-4", "3.2", english, japanese)
    }

    /// Returns true if the row describes this word and reserves it, so that nothing may have it as a name.
    fn reserves(&self, word: &str) -> bool {
        match self.kind {
            Kind::Target(_) => {
                word.starts_with(self.word)
                    && word
                        .parse()
                        .is_ok_and(|target: Target| target.stem() == self.word)
            }
            Kind::Variable | Kind::Constant(_) => word == self.word,
            Kind::Characters => character(word, self.word).is_some(),
            Kind::Variables => digit(word, self.word).is_some(),
            // No name begins with `@`.
            Kind::Reading(_) | Kind::MotionFlag | Kind::Label | Kind::Member => false,
        }
    }
}

/// Returns the digit after what the names of such variables begin with.
fn digit(word: &str, stem: &str) -> Option<u8> {
    match word.strip_prefix(stem)?.as_bytes() {
        [digit @ b'0'..=b'9'] => Some(digit - b'0'),
        _ => None,
    }
}

/// Returns the index among [`SPECIALS`] and the number of a variable that the program shares with native code.
pub fn special(word: &str, edition: Edition) -> Option<(usize, u8)> {
    let mut all = SPECIALS.iter().enumerate();
    let named = all.find_map(|(kind, stem)| Some((kind, digit(word, stem)?)));
    named.filter(|_| edition >= Edition::V3_2)
}

/// Returns the special variable that an edition writes so, in capital letters.
pub fn reading(word: &str, edition: Edition) -> Option<Reading> {
    let reading = word.parse().ok()?;
    (edition >= Edition::V3_2).then_some(reading)
}

/// Returns the digit or letter after what the names of such constants begin with.
fn character(word: &str, stem: &str) -> Option<u8> {
    match word.strip_prefix(stem)?.as_bytes() {
        [char @ (b'0'..=b'9' | b'A'..=b'Z')] => Some(*char),
        _ => None,
    }
}

/// Returns the rows that an edition has.
fn rows(edition: Edition) -> impl Iterator<Item = &'static Row> {
    RESERVED.iter().filter(move |row| row.since <= edition)
}

/// Returns the value of a constant's name.
pub fn constant(word: &str, edition: Edition) -> Option<f64> {
    rows(edition).find_map(|row| match row.kind {
        Kind::Constant(value) => (word == row.word).then_some(value),
        Kind::Characters => character(word, row.word).map(f64::from),
        _ => None,
    })
}

/// Returns the flags of motions.
pub fn motion_flags() -> impl Iterator<Item = &'static str> {
    let flags = RESERVED.iter().filter(|row| row.kind == Kind::MotionFlag);
    flags.map(|row| row.word)
}

/// Returns true if motions read this word as their flag.
pub fn is_motion_flag(word: &str, edition: Edition) -> bool {
    rows(edition).any(|row| row.kind == Kind::MotionFlag && row.word == word)
}

/// Returns true if an edition's word, in capital letters, belongs to the language, so that nothing may have it as a
/// name.
pub fn is_reserved(word: &str, edition: Edition) -> bool {
    commands::find_in(word, edition).is_some()
        || keywords::find(word, edition).is_some()
        || functions::find(word, edition).is_some()
        || flags::find(word, edition).is_some()
        || inputs::find(word, edition).is_some()
        || rows(edition).any(|row| row.reserves(word))
}

#[cfg(test)]
mod tests {
    use super::{constant, is_motion_flag, is_reserved};
    use crate::language::Edition;

    // clauses: 3.3
    #[test]
    fn constants_are_the_codes_of_their_keys() {
        let of = |word| constant(word, Edition::V3_1);
        assert_eq!(of("CHAR_SPC"), Some(32.0));
        assert_eq!(of("CHAR_0"), Some(48.0));
        assert_eq!(of("CHAR_Z"), Some(90.0));
        for word in ["CHAR_", "CHAR_AB", "CHAR_a", "CHAR", "SPC", ""] {
            assert_eq!(of(word), None, "{word}");
        }
    }

    // clauses: 3.2
    #[test]
    fn the_words_of_the_language_are_reserved() {
        for word in [
            "PTP",
            "SIN",
            "KB_HIT",
            "TO",
            "VR1",
            "ANTENNA",
            "VAR_KEY",
            "CHAR_A",
            "CHAR_9",
            "CHAR_SPC",
            "ALL",
            "FLOOR",
            "F1",
            "F9",
            "J11",
            "J99",
            "INPOS_ALL",
            "INPOS_F9",
            "IN_POS_F9",
            "NEAR_J11",
            "SPECIAL_FLAG0",
            "SPECIAL_FLAG9",
        ] {
            assert!(is_reserved(word, Edition::V3_1), "{word}");
        }
        for word in [
            "R",
            "A",
            "HS",
            "X",
            "CHAR_AB",
            "CHAR_",
            "F0",
            "F10",
            "J10",
            "J01",
            "J111",
            "INPOS",
            "INPOS_",
            "INPOS_FLOOR",
            "NEAR_FLOOR",
            "INPOS_5",
            "SPECIAL_FLAG",
            "SPECIAL_FLAG10",
            "SPECIAL_FLAGF1",
            "SPECIAL_FLAGFLOOR",
        ] {
            assert!(!is_reserved(word, Edition::V3_1), "{word}");
        }
    }

    // clauses: 12.1 13.3
    #[test]
    fn the_words_of_3_2_are_free_in_3_1() {
        for word in [
            "DIRECT",
            "THREAD",
            "START_TIMER",
            "F_MESSAGE",
            "DEFINE",
            "VAR_SPECIAL_0",
            "POS_SPECIAL_9",
            "JNT_SPECIAL_5",
        ] {
            assert!(!is_reserved(word, Edition::V3_1), "{word}");
            assert!(is_reserved(word, Edition::V3_2), "{word}");
        }
        for word in ["VAR_SPECIAL_", "VAR_SPECIAL_10", "JNT_SPECIAL", "TIMER0"] {
            assert!(!is_reserved(word, Edition::V3_2), "{word}");
        }
    }

    // clauses: 3.2
    #[test]
    fn flags_of_motions_are_names_like_any_other() {
        for word in ["R", "A", "HS"] {
            assert!(is_motion_flag(word, Edition::V3_1), "{word}");
            assert!(!is_reserved(word, Edition::V3_1), "{word}");
        }
        assert!(!is_motion_flag("ALL", Edition::V3_1));
    }
}
