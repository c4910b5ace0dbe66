//! Sweeps: axes, cases and results.

mod axes;
mod cases;
mod compiled;
mod goals;
mod results;
mod surroundings;

use tip_sweep::{Axis, Cell, Spec, Sweep, SweepError, Table};

/// A specification of a program for TITAN VIII with these axes.
fn spec(text: &str, axes: &[&str]) -> Spec {
    let json = serde_json::json!({ "program": { "name": "p.prg", "text": text } });
    let spec: Spec = serde_json::from_value(json).expect("a specification");
    let axes = axes.iter().map(|axis| axis.parse::<Axis>());
    Spec {
        vary: axes.collect::<Result<_, _>>().expect("axes"),
        ..spec
    }
}

fn sweep(text: &str, axes: &[&str]) -> Result<Sweep, SweepError> {
    Sweep::new(spec(text, axes))
}

/// The rows of all cases.
fn rows(spec: Spec) -> Table {
    let sweep = Sweep::new(spec).expect("a sweep");
    let rows = sweep.run(0, sweep.cases()).expect("it runs");
    let columns = sweep.columns().clone();
    Table { columns, rows }
}

/// The cells of a column.
fn cells<'a>(table: &'a Table, name: &str) -> Vec<&'a Cell> {
    let mut columns = table.columns.iter();
    let column = columns.position(|column| column.name == name);
    let column = column.unwrap_or_else(|| panic!("there is no column {name}"));
    table.rows.iter().map(|row| &row.cells()[column]).collect()
}

fn numbers(table: &Table, name: &str) -> Vec<f64> {
    let number = |cell: &&Cell| match cell {
        Cell::Number(number) => *number,
        other => panic!("{name} has {other:?}"),
    };
    cells(table, name).iter().map(number).collect()
}

fn texts<'a>(table: &'a Table, name: &str) -> Vec<&'a str> {
    let text = |cell: &'a Cell| match cell {
        Cell::Text(text) => text.as_str(),
        other => panic!("{name} has {other:?}"),
    };
    cells(table, name).into_iter().map(text).collect()
}

/// The reason why a sweep is refused.
fn refused(text: &str, axes: &[&str]) -> String {
    let refused = sweep(text, axes).expect_err("it is wrong");
    refused.to_string()
}

/// A program that lifts a foot by a number of millimetres.
const LIFT: &str = "3.1\nLifts a foot\nDEF_VAR Z\nZ = 20\nREL_PTP F1 0 0 Z\nWAIT_INPOS F1\nEND\n";
