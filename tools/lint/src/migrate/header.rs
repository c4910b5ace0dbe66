//! Line 1: which version the program was written for, and what that says about its style.

use super::Migrator;
use super::commands::is_statement_word;
use super::lines;
use crate::message::Migrating;
use tipc::parse::header::{version_number, version_word};

/// The version that a migration leads to.
const CURRENT: f64 = 3.1;
/// The first version with declared variables, and with several statements on a line.
const DECLARED: f64 = 3.0;
/// The first version with a title in line 2.
const TITLED: f64 = 1.1;
/// A version that older programs name, although the language never came so far.
const ODD: f64 = 4.0;

/// Style of a program's version.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    /// Variables typed by their names, one statement a line: before 3.0.
    Typed,
    /// Variables declared: 3.0.
    Declared,
}

impl Style {
    /// Returns true if variables like `VAR01` need no declaration.
    pub(super) fn typed(self) -> bool {
        self == Style::Typed
    }

    /// Returns true if `;` is an ordinary character of texts.
    pub(super) fn single(self) -> bool {
        self.typed()
    }
}

/// Title in line 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Title {
    /// The title.
    Present,
    /// A statement already.
    Missing,
}

impl Title {
    /// Returns the first line that holds statements.
    pub(super) fn first_line(self) -> u32 {
        match self {
            Title::Present => 3,
            Title::Missing => 2,
        }
    }
}

/// Contents of line 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) style: Style,
    pub(super) title: Title,
}

impl Migrator<'_> {
    /// Brings line 1 to version 3.1; `None` if nothing else is to be done.
    pub(super) fn header(&mut self) -> Option<Header> {
        let location = version_word(self.source);
        let word = self.slice(location).to_owned();
        let Some(version) = version_number(&word) else {
            self.question(location, Migrating::WhichVersion);
            return None;
        };
        if version == CURRENT {
            return None;
        }
        let known = (1.0..CURRENT).contains(&version) || version == ODD;
        if !known {
            self.question(location, Migrating::UnknownVersion { version: word });
            return None;
        }
        self.edits.replace(location, "3.1");
        self.change(location, Migrating::Version { version: word });
        let style = self.style(version);
        Some(Header {
            style,
            title: self.title(version),
        })
    }

    /// Returns a program that says 4.0 shows by its declarations what it is.
    fn style(&self, version: f64) -> Style {
        let declares = || {
            let pieces = lines::read(self.source, 3, false);
            let mut statements = pieces.iter().filter_map(lines::Piece::statement);
            statements.any(|statement| statement.keyword.starts_with("DEF_"))
        };
        let declared = if version == ODD {
            declares()
        } else {
            version >= DECLARED
        };
        if declared {
            Style::Declared
        } else {
            Style::Typed
        }
    }

    /// Returns the title. Version 1.0 had none: its line 2 is a statement if it looks like one.
    fn title(&self, version: f64) -> Title {
        if version >= TITLED {
            return Title::Present;
        }
        let pieces = lines::read(self.source, 2, true);
        let first = pieces.first().filter(|piece| piece.line() == 2);
        let is_statement = first.is_some_and(|piece| match piece {
            lines::Piece::Label { .. } => true,
            lines::Piece::Statement(statement) => {
                statement.is_equation() || is_statement_word(&statement.keyword)
            }
        });
        if is_statement {
            Title::Missing
        } else {
            Title::Present
        }
    }
}
