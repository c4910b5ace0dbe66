//! Many runs that go on together, for learning.

use crate::run::Signal;
use crate::{sweep_of, value_error, within};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tip_sim::Run;
use tip_sweep::Sweep;

/// Runs of cases of one specification.
#[pyclass(module = "tip_motion._native")]
pub(crate) struct Batch {
    state: Mutex<State>,
    /// Variables that actions set.
    actions: Vec<String>,
    observations: Vec<Signal>,
    /// Control cycles of a step.
    cycles: u64,
}

struct State {
    sweep: Sweep,
    runs: Vec<Run>,
}

impl Batch {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[pymethods]
impl Batch {
    #[new]
    fn new(
        spec: &str,
        count: u64,
        actions: Vec<String>,
        observations: Vec<String>,
        cycles: u64,
    ) -> PyResult<Self> {
        let sweep = sweep_of(spec)?;
        let mut runs = Vec::new();
        for number in 0..count {
            let case = within(&sweep, number % sweep.cases())?;
            runs.push(sweep.start(&case).map_err(value_error)?);
        }
        let Some(first) = runs.first() else {
            return Err(PyValueError::new_err("a batch needs an environment"));
        };
        for action in &actions {
            let accepted = first.program().accepts(action, 0.0);
            accepted.map_err(|error| PyValueError::new_err(format!("{action}: {error}")))?;
        }
        let observations = observations.iter().map(|name| Signal::find(name, first));
        Ok(Batch {
            observations: observations.collect::<PyResult<_>>()?,
            state: Mutex::new(State { sweep, runs }),
            actions,
            cycles,
        })
    }

    /// Starts the run of a case in the place of another one.
    fn reset(&self, index: usize, case: u64) -> PyResult<()> {
        let mut state = self.state();
        let case = within(&state.sweep, case % state.sweep.cases())?;
        let run = state.sweep.start(&case).map_err(value_error)?;
        match state.runs.get_mut(index) {
            Some(old) => *old = run,
            None => return Err(PyValueError::new_err("there is no such environment")),
        }
        Ok(())
    }

    /// Sets the actions (float64, one row for each run) and runs the cycles of a step. Returns one byte for each run: 1 if it has
    /// ended, 2 if it has come to the longest time.
    fn step<'py>(&self, py: Python<'py>, actions: &[u8]) -> PyResult<Bound<'py, PyBytes>> {
        let ends = py.detach(|| {
            let mut state = self.state();
            let State { sweep, runs } = &mut *state;
            let values: Vec<f64> = actions
                .as_chunks()
                .0
                .iter()
                .map(|bytes| f64::from_le_bytes(*bytes))
                .collect();
            if values.len() != runs.len() * self.actions.len() {
                return Err(PyValueError::new_err("the actions have another shape"));
            }
            let limit = sweep.spec().until * 1000.0;
            let mut ends = Vec::new();
            for (index, run) in runs.iter_mut().enumerate() {
                let values = &values[index * self.actions.len()..];
                for (name, value) in self.actions.iter().zip(values) {
                    run.set(name, *value).map_err(value_error)?;
                }
                let last = run.cycles() + self.cycles;
                let ending = run.to_end(tip_sim::Limit::cycles(last));
                ends.push(match ending {
                    tip_runtime::record::Ending::Limit if run.time() < limit => 0,
                    tip_runtime::record::Ending::Limit => 2,
                    _ => 1,
                });
            }
            Ok(ends)
        })?;
        Ok(PyBytes::new(py, &ends))
    }

    /// Returns the observations: float64, one row for each run.
    fn observe<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        let bytes: Vec<u8> = py.detach(|| {
            let state = self.state();
            let numbers = state
                .runs
                .iter()
                .flat_map(|run| self.observations.iter().map(move |signal| signal.read(run)));
            numbers.flat_map(f64::to_le_bytes).collect()
        });
        PyBytes::new(py, &bytes)
    }
}
