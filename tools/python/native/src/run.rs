//! A run that Python drives cycle by cycle.

use crate::signal::Signal;
use crate::{sweep_of, within};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Event, Limit, Timed};

/// The run of a case.
#[pyclass(module = "tip_motion._native")]
pub(crate) struct Run(Mutex<tip_sim::Run>);

/// A mark to which a run can be restored.
#[pyclass(module = "tip_motion._native")]
pub(crate) struct Snapshot(Mutex<tip_sim::Snapshot>);

impl Run {
    fn run(&self) -> MutexGuard<'_, tip_sim::Run> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn refused(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

#[pymethods]
impl Run {
    #[new]
    fn new(spec: &str, case: u64, trace: bool) -> PyResult<Self> {
        let sweep = sweep_of(spec)?;
        let case = within(&sweep, case)?;
        let run = sweep.start(&case).map_err(refused)?;
        Ok(Run(Mutex::new(match trace {
            true => run.with_trace(false),
            false => run,
        })))
    }

    /// Runs up to `count` cycles, until the program ends or the time on the robot is `until` s. Returns true if the program goes on.
    fn step(&self, py: Python<'_>, count: u64, until: f64) -> bool {
        py.detach(|| {
            let mut run = self.run();
            for _ in 0..count {
                if run.time() >= until * 1000.0 {
                    break;
                }
                let last = run.cycles() + 1;
                match run.to_end(Limit::cycles(last)) {
                    Ending::Limit => {}
                    _ => return false,
                }
            }
            true
        })
    }

    /// Assigns a variable before the next step.
    fn set(&self, name: &str, value: f64) -> PyResult<()> {
        self.run().set(name, value).map_err(refused)
    }

    /// Adds events in the form of `tip run --events`; one without a cycle happens before the next step.
    fn event(&self, text: &str) -> PyResult<()> {
        let mut run = self.run();
        let events: Vec<Timed> = match text.parse::<Event>() {
            Ok(event) => vec![event.at(run.cycles())],
            Err(_) => text
                .parse::<tip_sim::Events>()
                .map_err(refused)?
                .into_iter()
                .collect(),
        };
        for event in events {
            run.add(event).map_err(refused)?;
        }
        Ok(())
    }

    /// Reads a number of the run by its name.
    fn read(&self, name: &str) -> PyResult<f64> {
        let run = self.run();
        Ok(Signal::find(name, &run)?.read(&run))
    }

    fn snapshot(&self) -> Snapshot {
        Snapshot(Mutex::new(self.run().snapshot()))
    }

    fn restore(&self, mark: &Snapshot) {
        let mark = mark.0.lock().unwrap_or_else(PoisonError::into_inner);
        self.run().restore(&mark);
    }

    /// Returns the measured joint angles, and the number of joints of a leg.
    fn joints<'py>(&self, py: Python<'py>) -> (Bound<'py, PyBytes>, usize) {
        let run = self.run();
        let bytes: Vec<u8> = run
            .angles()
            .iter()
            .flat_map(|angle| angle.to_le_bytes())
            .collect();
        let legs = run.limbs().map_or(1, |limbs| limbs.angles.len().max(1));
        (PyBytes::new(py, &bytes), run.angles().len() / legs)
    }

    /// Returns x, y and z of the body, mm, and its roll, pitch and yaw, deg.
    fn pose(&self) -> Option<[f64; 6]> {
        let pose = self.run().pose()?;
        let [x, y, z] = pose.position;
        Some([x, y, z, pose.roll, pose.pitch, pose.yaw])
    }

    fn trace(&self) -> String {
        self.run().trace()
    }

    #[getter]
    fn cycles(&self) -> u64 {
        self.run().cycles()
    }

    /// The line of the step that is next, or that stopped the robot.
    #[getter]
    fn line(&self) -> u32 {
        let run = self.run();
        let step = run
            .emergency()
            .map_or(run.program().at(), |emergency| emergency.step);
        run.program().line(step)
    }

    /// The end of the run as in tables; `None` while it goes on.
    #[getter]
    fn end(&self) -> Option<String> {
        match self.run().ending()? {
            Ending::Program(End::End) => Some("END".to_owned()),
            Ending::Program(End::Exit) => Some("EXIT".to_owned()),
            Ending::Emergency(emergency) => Some(emergency.fault.to_string()),
            _ => None,
        }
    }
}
