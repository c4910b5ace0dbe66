//! Texts of programs and files in comments of Rust: whatever they hold, they end no line and turn no text around.

use std::fmt::Write;

/// The text with an escape in the place of each character that a comment may not hold; a tab stays.
pub(crate) fn in_comment(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for char in text.chars() {
        match breaks_comments(char) {
            // Writing to a string cannot fail.
            true => _ = write!(shown, "{}", char.escape_unicode()),
            false => shown.push(char),
        }
    }
    shown
}

/// Control characters, line separators, and characters that set the direction of text.
fn breaks_comments(char: char) -> bool {
    let sets_direction = matches!(
        char,
        '\u{61C}' | '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}'
    );
    let parts_lines = matches!(char, '\u{2028}' | '\u{2029}');
    sets_direction || parts_lines || (char.is_control() && char != '\t')
}

#[cfg(test)]
mod tests {
    use super::in_comment;

    #[test]
    fn what_ends_a_line_or_turns_text_is_an_escape() {
        assert_eq!(in_comment("a\nb\r\u{202E}c"), "a\\u{a}b\\u{d}\\u{202e}c");
        assert_eq!(in_comment("\u{1b}\u{85}\u{7f}"), "\\u{1b}\\u{85}\\u{7f}");
        assert_eq!(in_comment("\u{2028}\u{2066}"), "\\u{2028}\\u{2066}");
        assert_eq!(in_comment("歩く\t\\n → ok"), "歩く\t\\n → ok");
    }
}
