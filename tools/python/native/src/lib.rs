//! The compiled part of the Python package `tip_motion`: chunks of a sweep, runs and batches of runs.
//!
//! Numbers cross the border as bytes, which `numpy.frombuffer` reads. Whatever simulates releases the interpreter lock.
#![forbid(unsafe_code)]

mod batch;
mod run;

use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyList};
use std::fmt::Display;
use std::sync::{Mutex, PoisonError};
use tip_sweep::{Cell, Kind, Ranking, RobotSpec, Saved, Spec, Sweep};
use tipc::message::Lang;
use tipc::render;

/// The sweep of the last specification: a worker runs many chunks of one.
static LAST: Mutex<Option<(String, Sweep)>> = Mutex::new(None);

/// Returns the sweep of a specification.
fn sweep_of(json: &str) -> PyResult<Sweep> {
    let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, sweep)) = last.as_ref().filter(|(known, _)| known == json) {
        return Ok(sweep.clone());
    }
    let spec: Spec = serde_json::from_str(json).map_err(value_error)?;
    let sweep = Sweep::new(spec).map_err(value_error)?;
    *last = Some((json.to_owned(), sweep.clone()));
    Ok(sweep)
}

fn value_error(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// Returns the number of cases of a specification, after checking it.
#[pyfunction]
fn cases(py: Python<'_>, spec: &str) -> PyResult<u64> {
    py.detach(|| Ok(sweep_of(spec)?.cases()))
}

/// Returns the names of the axes and their values in a case.
#[pyfunction]
fn case_values(spec: &str, case: u64) -> PyResult<Vec<(String, f64)>> {
    let sweep = sweep_of(spec)?;
    let case = within(&sweep, case)?;
    Ok(sweep.axes().map(str::to_owned).zip(case.values).collect())
}

/// Returns a case, or an index error.
fn within(sweep: &Sweep, case: u64) -> PyResult<tip_sweep::Case> {
    sweep
        .case(case)
        .map_err(|error| match case < sweep.cases() {
            true => value_error(error),
            false => PyIndexError::new_err(error.to_string()),
        })
}

/// A column: its name, unit and meaning, its type as NumPy names it, and its values.
type Column<'py> = (
    String,
    &'static str,
    String,
    &'static str,
    Bound<'py, PyAny>,
);

/// Runs some cases, and returns their columns.
#[pyfunction]
fn run_chunk<'py>(
    py: Python<'py>,
    spec: &str,
    first: u64,
    count: u64,
) -> PyResult<Vec<Column<'py>>> {
    let (sweep, rows) = py.detach(|| {
        let sweep = sweep_of(spec)?;
        let end = first.saturating_add(count);
        if end > sweep.cases() {
            within(&sweep, end - 1)?;
        }
        let rows = sweep.run(first, count).map_err(value_error)?;
        Ok::<_, PyErr>((sweep, rows))
    })?;
    let columns = sweep.columns().iter().enumerate().map(|(index, column)| {
        let cells = rows.iter().map(|row| &row.cells()[index]);
        let (kind, values) = match column.kind {
            Kind::Number => ("<f8", bytes(py, cells.map(to_bytes))),
            Kind::Count => ("<u8", bytes(py, cells.map(to_bytes))),
            Kind::Text => (
                "str",
                PyList::new(py, cells.map(Cell::to_string).collect::<Vec<_>>())?.into_any(),
            ),
        };
        let meaning = column.meaning.text(Lang::English).to_owned();
        Ok((column.name.clone(), column.unit, meaning, kind, values))
    });
    columns.collect()
}

/// Returns the bytes of a number.
fn to_bytes(cell: &Cell) -> [u8; 8] {
    match cell {
        Cell::Number(number) => number.to_le_bytes(),
        Cell::Count(count) => count.to_le_bytes(),
        Cell::Text(_) => [0; 8],
    }
}

/// Returns the contents of the file next to a table.
#[pyfunction]
fn saved(spec: &str) -> PyResult<String> {
    Ok(Saved::of(&sweep_of(spec)?, Ranking::default()).text())
}

/// Returns true if the simulation of the robot has torques.
#[pyfunction]
fn has_forces(spec: &str) -> PyResult<bool> {
    Ok(sweep_of(spec)?.has_forces())
}

fn bytes<'py>(py: Python<'py>, values: impl Iterator<Item = [u8; 8]>) -> Bound<'py, PyAny> {
    let bytes: Vec<u8> = values.flatten().collect();
    PyBytes::new(py, &bytes).into_any()
}

/// Checks a program for the robot of a specification, and returns its diagnostics, one JSON object each.
#[pyfunction]
fn check(name: &str, text: &[u8], robot: &str, japanese: bool) -> PyResult<Vec<String>> {
    let robot: RobotSpec = serde_json::from_str(robot).map_err(value_error)?;
    let robot = robot.robot().map_err(value_error)?;
    let mut loaded = tip_lint::load(name, text, &robot.options());
    robot.warn(&mut loaded);
    let lang = match japanese {
        true => Lang::Japanese,
        false => Lang::English,
    };
    let facts = robot.options().robot;
    let all = loaded.diagnostics.iter();
    Ok(all
        .map(|one| render::json(&loaded.source, one, Some(facts), lang))
        .collect())
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(cases, module)?)?;
    module.add_function(wrap_pyfunction!(case_values, module)?)?;
    module.add_function(wrap_pyfunction!(run_chunk, module)?)?;
    module.add_function(wrap_pyfunction!(saved, module)?)?;
    module.add_function(wrap_pyfunction!(has_forces, module)?)?;
    module.add_function(wrap_pyfunction!(check, module)?)?;
    module.add_class::<run::Run>()?;
    module.add_class::<run::Snapshot>()?;
    module.add_class::<batch::Batch>()
}
