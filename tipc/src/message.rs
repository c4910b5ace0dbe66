//! Messages of diagnostics, as data: a reason, a help or a label is a row of a table and the arguments of its text.
//!
//! Each module that finds something has a table, and [`phrase`] one for each part of a sentence that
//! varies. No other module contains sentences, so that a text is changed in one place. Each language is a column.
//! Quoted words are cut to 80 characters.

use say::Say;
use smol_str::SmolStr;
use std::any::Any;
use std::fmt::{self, Debug, Display, Formatter, Write};
use std::sync::Arc;

#[macro_use]
mod table;

mod checking;
#[cfg(feature = "robot-files")]
mod describing;
pub mod list;
mod parsing;
pub mod phrase;
#[doc(hidden)]
pub mod say;
mod suggesting;

pub use checking::{Calculating, Commanding, Naming, Structuring};
#[cfg(feature = "robot-files")]
pub use describing::Describing;
#[cfg(feature = "build")]
pub use parsing::Building;
pub use parsing::{Parsing, Reading};
pub use say::{Decimal, Lang, Letter};
pub use suggesting::Suggestion;

tables! {
    Reading,
    Parsing,
    Commanding,
    Calculating,
    Naming,
    Structuring,
    Suggestion,
    #[cfg(feature = "robot-files")]
    Describing,
    #[cfg(feature = "build")]
    Building,
}

impl Message {
    /// Returns the message if it is of the table `T` of another crate.
    pub fn get<T: std::any::Any>(&self) -> Option<&T> {
        match self {
            Message::Other(message) => message.get(),
            _ => None,
        }
    }

    /// Returns its text in a language.
    pub fn in_lang(&self, lang: Lang) -> impl Display {
        say::Said(self, lang)
    }
}

impl Display for Message {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(&self.in_lang(Lang::English), f)
    }
}

/// A message of a table that another crate defines with [`message_table!`](crate::message_table).
#[derive(Clone)]
pub struct Other(Arc<dyn AnyMessage>);

/// Requirements of [`Other`] on a message.
trait AnyMessage: Any + Debug + Say + Send + Sync {
    /// Returns true if the other message is of the same table and row, with the same arguments.
    fn equals(&self, other: &dyn Any) -> bool;
}

impl<T: Any + Debug + PartialEq + Say + Send + Sync> AnyMessage for T {
    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref() == Some(self)
    }
}

impl Other {
    /// Wraps a message of any table.
    #[doc(hidden)]
    pub fn new(message: impl Any + Debug + PartialEq + Say + Send + Sync) -> Self {
        Other(Arc::new(message))
    }

    /// Returns the message if it is of the table `T`.
    pub fn get<T: Any>(&self) -> Option<&T> {
        let message: &dyn Any = &*self.0;
        message.downcast_ref()
    }
}

impl Debug for Other {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Debug::fmt(&self.0, f)
    }
}

impl PartialEq for Other {
    fn eq(&self, other: &Self) -> bool {
        self.0.equals(&*other.0)
    }
}

impl Say for Other {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.say(lang, f)
    }
}

/// The characters of a quoted word that are shown.
const WORD: usize = 80;

/// Maximum length of a [`Text`], bytes: that of the longest path of Linux.
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
    /// Shortens a quoted word for display.
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
        Display::fmt(&Cut::word(self), f)
    }
}

impl Say for SmolStr {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(&Cut::word(self), f)
    }
}

impl Say for Text {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        let whole = Cut {
            text: &self.0,
            most: TEXT,
        };
        Display::fmt(&whole, f)
    }
}

#[cfg(test)]
mod tests;
