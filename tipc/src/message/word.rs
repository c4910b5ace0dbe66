//! What others wrote, as a sentence shows it: cut where it is too long to be read.

use super::Lang;
use super::say::Say;
use smol_str::SmolStr;
use std::fmt::{self, Display, Formatter, Write};

/// The characters of a quoted word that are shown.
const WORD: usize = 80;

/// Those of a [`Text`]: as many as the longest path of Linux has bytes.
const TEXT: usize = 4096;

/// A path, or a sentence that somebody else wrote: cut only beyond all reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text(pub String);

impl From<String> for Text {
    fn from(text: String) -> Self {
        Text(text)
    }
}

/// The start of a word, and `…` in the place of the rest if that is long.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cut<'a> {
    text: &'a str,
    most: usize,
}

impl<'a> Cut<'a> {
    /// As much of a quoted word as is shown.
    pub(crate) const fn word(text: &'a str) -> Self {
        Cut { text, most: WORD }
    }
}

impl Display for Cut<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.text.char_indices().nth(self.most) {
            Some((end, _)) => {
                f.write_str(&self.text[..end])?;
                f.write_char('…')
            }
            None => f.write_str(self.text),
        }
    }
}

impl Say for String {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        Cut::word(self).fmt(f)
    }
}

impl Say for SmolStr {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        Cut::word(self).fmt(f)
    }
}

impl Say for Text {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        let whole = Cut {
            text: &self.0,
            most: TEXT,
        };
        whole.fmt(f)
    }
}
