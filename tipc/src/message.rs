//! What findings say, as data: a reason, a help or a label is a row of a table and the arguments of its text.
//!
//! Each room that finds something has a table, and [`phrase`] one for each part of a sentence that
//! varies. Nothing else spells a sentence, so that a text is changed in one place. Each language is a column.
//! Quoted words are cut to 80 characters.

#[macro_use]
mod table;

#[cfg(feature = "build")]
mod building;
mod calculating;
mod commanding;
#[cfg(feature = "robot-files")]
mod describing;
mod habit;
mod instead;
pub mod list;
mod naming;
mod other;
mod parsing;
pub mod phrase;
mod reading;
#[doc(hidden)]
pub mod say;
mod structuring;
mod suggesting;
mod word;

#[cfg(feature = "build")]
pub use building::Building;
pub use calculating::Calculating;
pub use commanding::Commanding;
#[cfg(feature = "robot-files")]
pub use describing::Describing;
pub use habit::Habit;
pub use instead::Instead;
pub use naming::Naming;
pub use other::Other;
pub use parsing::Parsing;
pub use reading::Reading;
pub use say::{Decimal, Lang, Letter};
pub use structuring::Structuring;
pub use suggesting::Suggesting;
pub(crate) use word::Cut;
pub use word::Text;

use std::fmt::{self, Display, Formatter};

tables! {
    Reading,
    Parsing,
    Commanding,
    Calculating,
    Naming,
    Structuring,
    Suggesting,
    Habit,
    Instead,
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

    /// Its text in a language.
    pub fn in_lang(&self, lang: Lang) -> impl Display {
        say::Said(self, lang)
    }
}

impl Display for Message {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.in_lang(Lang::English).fmt(f)
    }
}

#[cfg(test)]
mod tests;
