//! Untrusted texts, made safe for a terminal or a log, where a control character could act and a
//! line end could forge a line.
//!
//! ```
//! use tip_runtime::printable::Printable;
//!
//! let name = "walk\u{1b}[31m.prg\n";
//! assert_eq!(Printable::line(name).to_string(), r"walk\u{1b}[31m.prg\u{a}");
//! assert_eq!(Printable::lines("two\nlines").to_string(), "two\nlines");
//! ```

use core::fmt::{self, Display, Write};

/// A text whose control characters and marks of direction are shown as escapes, `\u{1b}`; a tab
/// stays.
///
/// All texts of a program, a robot's description or a file name are shown through it: C0, DEL and
/// C1 move the cursor or recolour other text, and marks of direction change the order in which
/// letters are shown. Formatting allocates nothing.
#[derive(Clone, Copy, Debug)]
pub struct Printable<T> {
    text: T,
    keeps: &'static str,
}

impl<T: Display> Printable<T> {
    /// Wraps a text of one line: a line end is escaped as well.
    pub const fn line(text: T) -> Self {
        Printable { text, keeps: "\t" }
    }

    /// Wraps a text of several lines.
    pub const fn lines(text: T) -> Self {
        Printable {
            text,
            keeps: "\t\n",
        }
    }

    /// Wraps the text of MESSAGE: `\a` rings the bell (T.I.P. 3.1 §7-9-4).
    pub const fn message(text: T) -> Self {
        Printable {
            text,
            keeps: "\t\u{7}",
        }
    }
}

impl<T: Display> Display for Printable<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let keeps = self.keeps;
        write!(Escaping { out: f, keeps }, "{}", self.text)
    }
}

/// A writer that escapes its input.
struct Escaping<'a, 'f> {
    out: &'a mut fmt::Formatter<'f>,
    keeps: &'static str,
}

impl Write for Escaping<'_, '_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let keeps = self.keeps;
        let escapes = |c: char| is_control(c) && !keeps.contains(c);
        for part in text.split_inclusive(escapes) {
            match part.chars().next_back().filter(|last| escapes(*last)) {
                Some(last) => {
                    self.out
                        .write_str(part.strip_suffix(last).unwrap_or_default())?;
                    Display::fmt(&last.escape_unicode(), self.out)?;
                }
                None => self.out.write_str(part)?,
            }
        }
        Ok(())
    }
}

/// Returns true if a character is a control: of C0, DEL, of C1, or of Unicode's bidirectional
/// algorithm (UAX #9, 2.1 to 2.6).
pub fn is_control(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61C}' | '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::Printable;
    extern crate std;
    use std::format;
    use std::string::{String, ToString};

    /// Returns true for the same characters by code point, as the standards list it.
    fn is_control(c: char) -> bool {
        let number = u32::from(c);
        let is_control = number < 0x20 || (0x7F..0xA0).contains(&number);
        let directions = [
            0x61C, 0x200E, 0x200F, 0x202A, 0x202B, 0x202C, 0x202D, 0x202E, 0x2066, 0x2067, 0x2068,
            0x2069,
        ];
        is_control || directions.contains(&number)
    }

    #[test]
    fn controls_are_escaped_and_all_else_stays() {
        for c in '\0'..=char::MAX {
            let text = format!("a{c}{c}b");
            let escape = format!("\\u{{{:x}}}", u32::from(c));
            let escaped = format!("a{escape}{escape}b");
            let expected = |kept: &str| match is_control(c) && !kept.contains(c) {
                true => escaped.clone(),
                false => text.clone(),
            };
            assert_eq!(Printable::line(&text).to_string(), expected("\t"));
            assert_eq!(Printable::lines(&text).to_string(), expected("\t\n"));
            assert_eq!(Printable::message(&text).to_string(), expected("\t\x07"));
        }
    }

    #[test]
    fn a_text_in_pieces_is_escaped_piece_by_piece() {
        let text = format!(
            "{}",
            Printable::line(format_args!("{}[{}m{}", '\u{1b}', 31, ""))
        );
        assert_eq!(text, "\\u{1b}[31m");
        assert_eq!(Printable::line("").to_string(), String::new());
    }
}
