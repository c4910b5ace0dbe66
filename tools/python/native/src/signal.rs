//! Numbers of a run, by name: what programs for learning observe.

use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use tip_runtime::plant::Motion;
use tip_sim::Run;

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
    pub(crate) fn find(name: &str, run: &Run) -> PyResult<Self> {
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
    pub(crate) fn read(self, run: &Run) -> f64 {
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
