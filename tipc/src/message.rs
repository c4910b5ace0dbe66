//! What findings say, as data: a reason, a help or a label is a row of a table and the arguments of its text.
//!
//! Each room that finds something has a table, and [`phrase`] one for each part of a sentence that
//! varies. Nothing else spells a sentence, so that a text is changed in one place. Each language is a column.
//! Quoted words are cut to 80 characters.

#[macro_use]
mod table;

#[cfg(any(feature = "build", feature = "tools"))]
mod allowing;
#[cfg(feature = "build")]
mod building;
mod calculating;
#[cfg(feature = "tools")]
mod checking;
mod commanding;
#[cfg(feature = "tools")]
pub mod count;
#[cfg(feature = "tools")]
mod debugging;
#[cfg(feature = "robot-files")]
mod describing;
#[cfg(feature = "tools")]
mod editing;
#[cfg(feature = "tools")]
mod fixing;
#[cfg(feature = "tools")]
mod formatting;
mod habit;
#[cfg(all(feature = "robot-files", feature = "tools"))]
mod importing;
mod instead;
pub mod list;
#[cfg(feature = "tools")]
mod making;
#[cfg(feature = "tools")]
mod migrating;
mod naming;
mod parsing;
pub mod phrase;
mod reading;
#[cfg(feature = "tools")]
pub mod running;
pub(crate) mod say;
#[cfg(feature = "tools")]
mod simulating;
#[cfg(feature = "tools")]
mod stopping;
mod structuring;
mod suggesting;
#[cfg(feature = "tools")]
mod using;
#[cfg(any(feature = "build", feature = "tools"))]
mod warning;
mod word;

#[cfg(any(feature = "build", feature = "tools"))]
pub use allowing::Allowing;
#[cfg(feature = "build")]
pub use building::Building;
pub use calculating::Calculating;
#[cfg(feature = "tools")]
pub use checking::Checking;
pub use commanding::Commanding;
#[cfg(feature = "tools")]
pub use debugging::Debugging;
#[cfg(feature = "robot-files")]
pub use describing::Describing;
#[cfg(feature = "tools")]
pub use editing::Editing;
#[cfg(feature = "tools")]
pub use fixing::Fixing;
#[cfg(feature = "tools")]
pub use formatting::Formatting;
pub use habit::Habit;
#[cfg(all(feature = "robot-files", feature = "tools"))]
pub use importing::Importing;
pub use instead::Instead;
#[cfg(feature = "tools")]
pub use making::Making;
#[cfg(feature = "tools")]
pub use migrating::Migrating;
pub use naming::Naming;
pub use parsing::Parsing;
pub use reading::Reading;
#[cfg(feature = "tools")]
pub use running::Running;
pub use say::{Decimal, Lang, Letter};
#[cfg(feature = "tools")]
pub use simulating::Simulating;
#[cfg(feature = "tools")]
pub use stopping::Stopping;
pub use structuring::Structuring;
pub use suggesting::Suggesting;
#[cfg(feature = "tools")]
pub use using::Using;
#[cfg(any(feature = "build", feature = "tools"))]
pub use warning::Warning;
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
    #[cfg(feature = "tools")]
    Fixing,
    #[cfg(any(feature = "build", feature = "tools"))]
    Warning,
    #[cfg(any(feature = "build", feature = "tools"))]
    Allowing,
    #[cfg(feature = "robot-files")]
    Describing,
    #[cfg(all(feature = "robot-files", feature = "tools"))]
    Importing,
    #[cfg(feature = "tools")]
    Migrating,
    #[cfg(feature = "tools")]
    Formatting,
    #[cfg(feature = "tools")]
    Editing,
    #[cfg(feature = "tools")]
    Checking,
    #[cfg(feature = "tools")]
    Running,
    #[cfg(feature = "tools")]
    Using,
    #[cfg(feature = "tools")]
    Making,
    #[cfg(feature = "tools")]
    Stopping,
    #[cfg(feature = "tools")]
    Debugging,
    #[cfg(feature = "tools")]
    Simulating,
    #[cfg(feature = "build")]
    Building,
}

impl Message {
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
