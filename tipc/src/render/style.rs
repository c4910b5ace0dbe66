//! How people want to read.

use crate::message::Lang;

/// The language, the colours and the width of what is shown to people.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Style {
    /// The language of reasons and helps.
    pub lang: Lang,
    /// Whether there are colours, for a terminal.
    pub colour: bool,
    /// The columns that a line may fill, if there is a limit.
    pub width: Option<usize>,
}

impl Style {
    /// This style in a language.
    #[must_use]
    pub fn lang(mut self, lang: Lang) -> Self {
        self.lang = lang;
        self
    }

    /// This style with colours, or without.
    #[must_use]
    pub fn colour(mut self, colour: bool) -> Self {
        self.colour = colour;
        self
    }

    /// This style for lines of so many columns.
    #[must_use]
    pub fn width(mut self, width: Option<usize>) -> Self {
        self.width = width;
        self
    }
}
