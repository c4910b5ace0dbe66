//! Results of a sweep, column by column.

use std::fmt::{self, Write as _};

/// Results of some cases, one row per case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns(pub Vec<Column>);

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// Its values.
    pub data: Data,
}

/// Values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Data {
    /// Numbers; NaN where there is none.
    Number(Vec<f64>),
    /// Counts.
    Count(Vec<u64>),
    /// Words.
    Text(Vec<String>),
}

/// A value of a row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Number(f64),
    Count(u64),
    Text(String),
}

impl Columns {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.0.first().map_or(0, |column| match &column.data {
            Data::Number(values) => values.len(),
            Data::Count(values) => values.len(),
            Data::Text(values) => values.len(),
        })
    }

    /// Returns true if there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Finds a column by its name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.0.iter().find(|column| column.name == name)
    }

    /// Adds a value at the end of the row; the first row makes the columns.
    pub(crate) fn push(&mut self, index: usize, name: &str, unit: &'static str, cell: Cell) {
        if index == self.0.len() {
            let data = match &cell {
                Cell::Number(_) => Data::Number(Vec::new()),
                Cell::Count(_) => Data::Count(Vec::new()),
                Cell::Text(_) => Data::Text(Vec::new()),
            };
            self.0.push(Column {
                name: name.to_owned(),
                unit,
                data,
            });
        }
        match (&mut self.0[index].data, cell) {
            (Data::Number(values), Cell::Number(value)) => values.push(value),
            (Data::Count(values), Cell::Count(value)) => values.push(value),
            (Data::Text(values), Cell::Text(value)) => values.push(value),
            _ => unreachable!("a column has one type"),
        }
    }

    /// Appends the rows of the cases that follow.
    pub fn append(&mut self, more: Columns) {
        if self.0.is_empty() {
            *self = more;
            return;
        }
        for (column, more) in self.0.iter_mut().zip(more.0) {
            match (&mut column.data, more.data) {
                (Data::Number(values), Data::Number(more)) => values.extend(more),
                (Data::Count(values), Data::Count(more)) => values.extend(more),
                (Data::Text(values), Data::Text(more)) => values.extend(more),
                _ => unreachable!("chunks of one sweep have the same columns"),
            }
        }
    }

    /// Returns the header of a CSV file: names, with units in brackets.
    pub fn csv_header(&self) -> String {
        let names = self.0.iter().map(|column| match column.unit {
            "" => field(&column.name),
            unit => field(&format!("{} [{unit}]", column.name)),
        });
        names.collect::<Vec<_>>().join(",") + "\n"
    }

    /// Returns the rows of a CSV file. Numbers are written so that they read back to the same bits; missing ones are empty.
    pub fn csv_rows(&self) -> String {
        let mut text = String::new();
        for row in 0..self.len() {
            for (index, column) in self.0.iter().enumerate() {
                if index > 0 {
                    text.push(',');
                }
                // Writing to a string cannot fail.
                let _ = match &column.data {
                    Data::Number(values) if values[row].is_nan() => Ok(()),
                    Data::Number(values) => write!(text, "{}", values[row]),
                    Data::Count(values) => write!(text, "{}", values[row]),
                    Data::Text(values) => write!(text, "{}", field(&values[row])),
                };
            }
            text.push('\n');
        }
        text
    }
}

impl fmt::Display for Columns {
    /// Writes a CSV file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.csv_header())?;
        f.write_str(&self.csv_rows())
    }
}

/// Quotes a field if it needs quotes.
fn field(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}
