//! A run that Python drives cycle by cycle, and its numbers by name.

use crate::{sweep_of, value_error, within};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tip_runtime::plant::Motion;
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Event, Limit, Timed};
use tip_sweep::Spec;

/// The run of a case.
#[pyclass(module = "tip_motion._native")]
pub(crate) struct Run {
    run: Mutex<tip_sim::Run>,
    spec: Spec,
}

/// A mark to which a run can be restored.
#[pyclass(module = "tip_motion._native")]
pub(crate) struct Snapshot {
    mark: Mutex<tip_sim::Snapshot>,
    spec: Spec,
}

impl Run {
    fn run(&self) -> MutexGuard<'_, tip_sim::Run> {
        self.run.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns true if the run may go on: neither its longest time nor its largest number of cycles is used up.
    fn has_time(&self, run: &tip_sim::Run) -> bool {
        let cycles = self.spec.cycles.unwrap_or(u64::MAX);
        run.time() < self.spec.until * 1000.0 && run.cycles() < cycles
    }
}

#[pymethods]
impl Run {
    #[new]
    fn new(spec: &str, case: u64, trace: bool) -> PyResult<Self> {
        let sweep = sweep_of(spec)?;
        let case = within(&sweep, case)?;
        let run = sweep.start(&case).map_err(value_error)?;
        Ok(Run {
            run: Mutex::new(match trace {
                true => run.with_trace(false),
                false => run,
            }),
            spec: sweep.spec().clone(),
        })
    }

    /// Runs up to `count` cycles, until the program ends or its longest time or largest number of cycles is used up. Returns true if
    /// the program goes on: another call would run another cycle.
    fn step(&self, py: Python<'_>, count: u64) -> bool {
        py.detach(|| {
            let mut run = self.run();
            for _ in 0..count {
                if !self.has_time(&run) {
                    return false;
                }
                let last = run.cycles() + 1;
                match run.to_end(Limit::cycles(last)) {
                    Ending::Limit => {}
                    _ => return false,
                }
            }
            matches!(run.ending(), None | Some(Ending::Limit)) && self.has_time(&run)
        })
    }

    /// Assigns a variable before the next step.
    fn set(&self, name: &str, value: f64) -> PyResult<()> {
        self.run().set(name, value).map_err(value_error)
    }

    /// Adds events in the form of `tip run --events`; one without a cycle happens before the next step.
    fn event(&self, text: &str) -> PyResult<()> {
        let mut run = self.run();
        let events: Vec<Timed> = match text.parse::<Event>() {
            Ok(event) => vec![event.at(run.cycles())],
            Err(_) => text
                .parse::<tip_sim::Events>()
                .map_err(value_error)?
                .into_iter()
                .collect(),
        };
        for event in events {
            run.add(event).map_err(value_error)?;
        }
        Ok(())
    }

    /// Reads a number of the run by its name.
    fn read(&self, name: &str) -> PyResult<f64> {
        let run = self.run();
        Ok(Signal::find(name, &run)?.read(&run))
    }

    fn snapshot(&self) -> Snapshot {
        Snapshot {
            mark: Mutex::new(self.run().snapshot()),
            spec: self.spec.clone(),
        }
    }

    /// Restores a mark of a run of the same program on the same robot.
    fn restore(&self, mark: &Snapshot) -> PyResult<()> {
        let (own, other) = (&self.spec, &mark.spec);
        let differs = [
            ("program", own.program.text != other.program.text),
            ("robot", own.robot != other.robot),
            ("scene", own.scene != other.scene),
            ("plant", own.plant != other.plant),
        ];
        if let Some((what, _)) = differs.iter().find(|(_, differs)| *differs) {
            let error = format!("the snapshot is of a run with another {what}");
            return Err(PyValueError::new_err(error));
        }
        let mark = mark.mark.lock().unwrap_or_else(PoisonError::into_inner);
        self.run().restore(&mark);
        Ok(())
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

/// A number of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Signal {
    /// Place of the body: mm.
    Position(usize),
    Roll,
    Pitch,
    Yaw,
    /// Travel to the right, forward and up, mm.
    Travel(usize),
    /// Turn to the left, deg.
    Turn,
    Falls,
    Slip,
    Margin,
    /// Time on the robot, s.
    Time,
    /// Measured angle of a joint, deg.
    Angle(usize),
    /// Load of a foot or fingertip, N.
    Load(usize),
    /// A scalar of the program.
    Variable(usize),
}

const NAMES: [(&str, Signal); 13] = [
    ("x", Signal::Position(0)),
    ("y", Signal::Position(1)),
    ("z", Signal::Position(2)),
    ("roll", Signal::Roll),
    ("pitch", Signal::Pitch),
    ("yaw", Signal::Yaw),
    ("right", Signal::Travel(0)),
    ("forward", Signal::Travel(1)),
    ("up", Signal::Travel(2)),
    ("turn", Signal::Turn),
    ("falls", Signal::Falls),
    ("slip", Signal::Slip),
    ("margin", Signal::Margin),
];

impl Signal {
    /// Finds a signal of a run: a name above, `time`, `J11`, `load1`, or a variable of the program.
    pub(crate) fn find(name: &str, run: &tip_sim::Run) -> PyResult<Self> {
        if let Some((_, signal)) = NAMES.iter().find(|(known, _)| *known == name) {
            return Ok(*signal);
        }
        if name == "time" {
            return Ok(Signal::Time);
        }
        let number = |text: Option<&str>| text.and_then(|text| text.parse::<usize>().ok());
        let limbs = run.limbs();
        if let Some(joint) = number(name.strip_prefix('J'))
            && let Some(limbs) = &limbs
            && let Some(leg) = (joint / 10)
                .checked_sub(1)
                .filter(|leg| *leg < limbs.angles.len())
            && let Some(of_leg) = (joint % 10)
                .checked_sub(1)
                .filter(|of_leg| *of_leg < limbs.angles[leg].len())
        {
            let before: usize = limbs.angles[..leg].iter().map(Vec::len).sum();
            return Ok(Signal::Angle(before + of_leg));
        }
        if let Some(foot) = number(name.strip_prefix("load")).and_then(|foot| foot.checked_sub(1))
            && limbs.as_ref().is_some_and(|limbs| foot < limbs.loads.len())
        {
            return Ok(Signal::Load(foot));
        }
        let scalars = (0..).map_while(|scalar| run.program().scalar(scalar));
        let wanted = name.to_ascii_uppercase();
        match scalars
            .map(|(name, _)| name)
            .position(|name| name == wanted)
        {
            Some(scalar) => Ok(Signal::Variable(scalar)),
            None => Err(PyKeyError::new_err(format!(
                "'{name}' is neither a variable of the program nor one of x, y, z, roll, pitch, yaw, right, forward, up, turn, falls, slip, margin, time, J11…, load1…"
            ))),
        }
    }

    /// Reads the signal; NaN if the robot lacks it or the variable is unassigned.
    pub(crate) fn read(self, run: &tip_sim::Run) -> f64 {
        let of_motion = |number: fn(Motion) -> f64| run.motion().map_or(f64::NAN, number);
        match self {
            Signal::Position(axis) => run.pose().map_or(f64::NAN, |pose| pose.position[axis]),
            Signal::Roll => run.pose().map_or(f64::NAN, |pose| pose.roll),
            Signal::Pitch => run.pose().map_or(f64::NAN, |pose| pose.pitch),
            Signal::Yaw => run.pose().map_or(f64::NAN, |pose| pose.yaw),
            Signal::Travel(axis) => run
                .travel()
                .map_or(f64::NAN, |travel| [travel.x, travel.y, travel.z][axis]),
            Signal::Turn => run.travel().map_or(f64::NAN, |travel| travel.turn),
            Signal::Falls => of_motion(|motion| f64::from(motion.falls)),
            Signal::Slip => of_motion(|motion| motion.slip),
            Signal::Margin => of_motion(|motion| motion.margin),
            Signal::Time => run.time() / 1000.0,
            Signal::Angle(joint) => run.angles().get(joint).copied().unwrap_or(f64::NAN),
            Signal::Load(foot) => run
                .limbs()
                .and_then(|limbs| limbs.loads.get(foot).copied())
                .unwrap_or(f64::NAN),
            Signal::Variable(scalar) => run
                .program()
                .scalar(scalar)
                .and_then(|(_, value)| value)
                .unwrap_or(f64::NAN),
        }
    }
}
