//! The language as tables: each word with its edition, its clause of the reference and one line that says what it is.
//!
//! Words are listed here; what a trace prints is listed in [`tip_runtime::command`], and rows refer to it.

mod bilingual;
pub mod commands;
mod edition;
pub mod flags;
pub mod functions;
mod index;
pub mod inputs;
pub mod keywords;
pub mod names;
pub mod reserved;

pub use bilingual::Bilingual;
pub use edition::Edition;
pub use keywords::Keyword;

#[cfg(test)]
mod tests {
    use super::{Bilingual, commands, flags, functions, inputs, keywords, reserved};

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
}
