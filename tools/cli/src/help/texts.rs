//! The Japanese texts of the help, as `tools/cli/help` holds them.

const LINES: &str = include_str!("../../help/lines.txt");
const ENDINGS: &str = include_str!("../../help/endings.txt");

/// What a command, an option or a value is said to be in English, and in Japanese.
pub(super) fn lines() -> impl Iterator<Item = (&'static str, &'static str)> {
    let rows = LINES.split("\n\n").filter(|row| !row.starts_with('#'));
    rows.filter_map(|row| row.trim_end().split_once('\n'))
}

/// A command, its words joined by `_`, and what stands below its options: examples, and what it does and answers.
pub(super) fn endings() -> impl Iterator<Item = (&'static str, &'static str)> {
    let texts = ENDINGS.trim_start_matches("== ").split("\n== ");
    texts.filter_map(|text| text.split_once('\n'))
}
