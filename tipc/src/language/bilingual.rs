//! Texts of the tables.

/// A text in each language that messages are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bilingual {
    /// In English.
    pub english: &'static str,
    /// In Japanese.
    pub japanese: &'static str,
}

impl Bilingual {
    /// Nothing to say.
    pub const EMPTY: Bilingual = Bilingual::new("", "");

    /// Creates a text in each language.
    pub(super) const fn new(english: &'static str, japanese: &'static str) -> Self {
        Bilingual { english, japanese }
    }
}
