//! The language as tables: each word with its edition, its clause of the reference and one line that says what it is.
//!
//! Words are listed here; what a trace prints is listed in [`tip_runtime::command`], and rows refer to it.

pub mod commands;
pub mod flags;
pub mod functions;
pub mod inputs;
pub mod keywords;
pub mod names;
pub mod reserved;

pub use keywords::Keyword;

use std::fmt;

/// An edition of the language, in the order in which they came. Line 1 of a program chooses it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Edition {
    /// T.I.P. 3.1: what a program is read by if its number names no edition.
    #[default]
    V3_1,
    /// T.I.P. 3.2: what the author of the language planned next (T.I.P. 3.1 §1-2).
    V3_2,
}

impl Edition {
    /// Every edition, the oldest first.
    pub const ALL: &'static [Edition] = &[Edition::V3_1, Edition::V3_2];

    /// Returns the number that line 1 names it by.
    pub const fn number(self) -> f64 {
        match self {
            Edition::V3_1 => 3.1,
            Edition::V3_2 => 3.2,
        }
    }

    /// Returns the edition of that number; 3.1 if it names none.
    pub fn of(number: f64) -> Edition {
        let mut all = Edition::ALL.iter().copied();
        all.find(|edition| edition.number() == number)
            .unwrap_or_default()
    }

    /// Returns true if a mistake that stops the program when it runs is refused when it loads; 3.1 warns of it.
    pub const fn is_strict(self) -> bool {
        matches!(self, Edition::V3_2)
    }
}

impl fmt::Display for Edition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.number())
    }
}

/// A text in each language that messages are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bilingual {
    /// In English.
    pub english: &'static str,
    /// In Japanese.
    pub japanese: &'static str,
}

impl Bilingual {
    /// Nothing to say.
    pub const EMPTY: Bilingual = Bilingual::new("", "");

    /// Creates a text in each language.
    const fn new(english: &'static str, japanese: &'static str) -> Self {
        Bilingual { english, japanese }
    }
}

#[cfg(test)]
mod tests {
    use super::{Bilingual, Edition, commands, flags, functions, inputs, keywords, reserved};

    #[test]
    fn every_row_describes_its_word_in_both_languages() {
        let commands = commands::COMMANDS.iter().map(|row| row.description);
        let keywords = keywords::KEYWORDS.iter().map(|row| row.description);
        let functions = functions::FUNCTIONS.iter().map(|row| row.description);
        let flags = flags::FLAGS.iter().map(|row| row.description);
        let inputs = inputs::INPUTS.iter().map(|row| row.description);
        let reserved = reserved::RESERVED.iter().map(|row| row.description);
        let all = commands.chain(keywords).chain(functions).chain(flags);
        for Bilingual { english, japanese } in all.chain(inputs).chain(reserved) {
            assert!(english.is_ascii() || english.contains('…'), "{english}");
            assert!(
                english.ends_with('.') && japanese.ends_with('。'),
                "{english}"
            );
            let is_kana =
                |char: char| ('\u{3040}'..='\u{30FF}').contains(&char) || char > '\u{4E00}';
            assert!(japanese.chars().any(is_kana), "{japanese}");
        }
    }

    // clauses: 1.3 12.1
    #[test]
    fn a_number_that_names_no_edition_is_read_by_the_rules_of_3_1() {
        assert_eq!(Edition::of(3.1), Edition::V3_1);
        assert_eq!(Edition::of(3.2), Edition::V3_2);
        for number in [0.0, 2.0, 3.0, 3.10001, 9.9, f64::NAN] {
            assert_eq!(Edition::of(number), Edition::V3_1, "{number}");
        }
    }

    #[test]
    fn editions_are_ordered_by_their_numbers() {
        let pairs = Edition::ALL.windows(2);
        for pair in pairs {
            assert!(pair[0] < pair[1] && pair[0].number() < pair[1].number());
        }
        assert_eq!(Edition::V3_1.to_string(), "3.1");
    }
}
