//! Output to a terminal: control characters are escaped, and other text is unchanged.

use std::fmt::{self, Display, Formatter, Write};
use tip_runtime::printable::{Printable, is_control};

/// Shows the text as one line, as several and as a message, whole and in pieces.
///
/// # Panics
/// Something acts on the terminal, or a plain text is changed.
pub fn examine(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let line = |text: &dyn Display| Printable::line(text).to_string();
    let lines = |text: &dyn Display| Printable::lines(text).to_string();
    let message = |text: &dyn Display| Printable::message(text).to_string();
    shows(&text, "\t", line);
    shows(&text, "\t\n", lines);
    shows(&text, "\t\u{7}", message);
}

fn shows(text: &str, keeps: &str, show: impl Fn(&dyn Display) -> String) {
    let escaped = |char: &char| is_control(*char) && !keeps.contains(*char);
    let shown = show(&text);
    let mut expected = String::new();
    for char in text.chars() {
        match escaped(&char) {
            // Writing to a string cannot fail.
            true => _ = write!(expected, "\\u{{{:x}}}", u32::from(char)),
            false => expected.push(char),
        }
    }
    assert!(
        !shown.chars().any(|char| escaped(&char)),
        "{text:?}: {shown:?}"
    );
    assert_eq!(shown, expected, "{text:?}");
    assert_eq!(show(&Pieces(text)), shown, "{text:?}, in pieces");
}

/// A text that is written character by character.
struct Pieces<'a>(&'a str);

impl Display for Pieces<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|char| f.write_char(char))
    }
}
