//! The file next to a table, `NAME.sweep.json`: the specification of its sweep, and a list of its columns.

use crate::columns::Column;
use crate::goal::Ranking;
use crate::spec::Spec;
use crate::sweep::Sweep;
use serde::{Deserialize, Serialize};

/// The contents of the file next to a table.
#[derive(Debug, Deserialize, Serialize)]
pub struct Saved {
    /// Version of the package that has written the table.
    tip: String,
    /// Columns of the table, for its readers. They follow from the specification and are not read back.
    #[serde(skip_deserializing)]
    columns: Vec<Column>,
    /// The specification.
    pub spec: Spec,
    /// The goals by which the runs are ranked; no row depends on them.
    #[serde(default)]
    pub ranking: Ranking,
}

impl Saved {
    /// Returns the contents for a sweep whose runs are ranked so.
    pub fn of(sweep: &Sweep, ranking: Ranking) -> Self {
        Saved {
            tip: env!("CARGO_PKG_VERSION").to_owned(),
            columns: sweep.columns().to_vec(),
            spec: sweep.spec().clone(),
            ranking,
        }
    }

    /// Reads the contents.
    ///
    /// # Errors
    /// The text is not JSON of this form.
    pub fn read(text: &[u8]) -> Result<Self, serde_json::Error> {
        serde_json::from_slice(text)
    }

    /// Writes the contents as JSON.
    pub fn text(&self) -> String {
        // It has string keys and no values that JSON lacks.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Returns true if this version writes the same rows for the other specification.
    pub fn is_of(&self, sweep: &Sweep) -> bool {
        self.tip == env!("CARGO_PKG_VERSION") && self.spec == *sweep.spec()
    }
}
