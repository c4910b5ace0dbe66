//! Many runs that go on together, for learning.

use crate::run::Signal;
use crate::{sweep_of, value_error, within};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::num::NonZero;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use tip_runtime::record::Ending;
use tip_sim::{Limit, Run};
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

/// Smallest number of runs that are worth a thread.
const LEAST_RUNS: usize = 4;

impl Batch {
    /// Sets the actions of some runs, and runs the cycles of a step.
    fn step_runs(&self, runs: &mut [Run], values: &[f64], limit: f64, ends: &mut [u8]) {
        let values = values.chunks(self.actions.len());
        for ((run, end), values) in runs.iter_mut().zip(ends).zip(values) {
            for (name, value) in self.actions.iter().zip(values) {
                // The values were accepted.
                let _ = run.set(name, *value);
            }
            let last = run.cycles() + self.cycles;
            *end = match run.to_end(Limit::cycles(last)) {
                Ending::Limit if run.time() < limit => 0,
                Ending::Limit => 2,
                _ => 1,
            };
        }
    }

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
        if actions.is_empty() {
            return Err(PyValueError::new_err("a batch needs an action"));
        }
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
            let (values, _) = actions.as_chunks();
            let values: Vec<f64> = values
                .iter()
                .map(|bytes| f64::from_le_bytes(*bytes))
                .collect();
            let of_run = self.actions.len();
            if values.len() != runs.len() * of_run {
                return Err(PyValueError::new_err("the actions have another shape"));
            }
            // Nothing runs if a value is refused.
            for (index, value) in values.iter().enumerate() {
                let (run, name) = (index / of_run, &self.actions[index % of_run]);
                let refused =
                    |error| PyValueError::new_err(format!("actions[{run}]: {name}: {error}"));
                runs[run].program().accepts(name, *value).map_err(refused)?;
            }
            let limit = sweep.spec().until * 1000.0;
            let mut ends = vec![0; runs.len()];
            let cores = thread::available_parallelism().map_or(1, NonZero::get);
            let share = runs.len().div_ceil(cores).max(LEAST_RUNS);
            thread::scope(|scope| {
                let shares = runs.chunks_mut(share).zip(ends.chunks_mut(share));
                let mut shares = shares.zip(values.chunks((share * of_run).max(1)));
                // This thread has the first share.
                let own = shares.next();
                for ((runs, ends), values) in shares {
                    scope.spawn(move || self.step_runs(runs, values, limit, ends));
                }
                if let Some(((runs, ends), values)) = own {
                    self.step_runs(runs, values, limit, ends);
                }
            });
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
