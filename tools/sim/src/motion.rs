//! The motion of a robot of any size, as values.

use serde::Serialize;
use std::fmt;
use tip_runtime::model::Point;
use tip_runtime::plant::{self, Clearance, Fingertip, Gap, Motion, ObjectState};

/// The real state of legs or fingers after a cycle, without the errors of sensors.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Limbs {
    /// Angle of each joint, leg by leg, deg.
    pub angles: Vec<Vec<f64>>,
    /// Load of each foot, or push of each fingertip, N. Empty if the robot is bolted down.
    pub loads: Vec<f64>,
    /// Force of the ground on each foot, friction included, in the world, N. Empty where only loads are
    /// known; those of a hand are in [`Grasp`].
    pub forces: Vec<[f64; 3]>,
    /// Slip of each foot since its touchdown, mm. Empty unless a built-in plant simulates a walking robot.
    pub slips: Vec<f64>,
    /// Torque of each motor, leg by leg, in the robot's torque unit, in N·m if it has none.
    pub torques: Vec<Vec<f64>>,
}

impl<const L: usize, const J: usize> From<plant::Limbs<L, J>> for Limbs {
    fn from(limbs: plant::Limbs<L, J>) -> Self {
        gather(
            &limbs.angles,
            &limbs.torques,
            limbs.loads.as_ref().map_or(&[], |loads| loads),
            limbs.forces.as_ref().map_or(&[], |forces| forces),
            limbs.slips.as_ref().map_or(&[], |slips| slips),
        )
    }
}

/// The effect of a hand on the things around it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grasp {
    /// The ends of its fingers.
    pub fingertips: Vec<Fingertip>,
    /// The objects, in the order of the scene.
    pub objects: Vec<ObjectState>,
    /// Place of the slider that carries the floor, mm.
    pub slider: Point,
}

impl<const L: usize> From<plant::Grasp<L>> for Grasp {
    fn from(grasp: plant::Grasp<L>) -> Self {
        Grasp {
            fingertips: grasp.fingertips.to_vec(),
            objects: grasp.objects.into_iter().flatten().collect(),
            slider: grasp.slider,
        }
    }
}

/// The robot fell: its body came down, or its support was lost.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fall {
    /// The control cycle, from 0.
    pub cycle: u64,
    /// Time at which that cycle began, ms.
    pub time: f64,
    /// The step that ran in it.
    pub step: u32,
    /// Distance of the centre of mass from the edge of the support polygon, mm; negative outside.
    pub margin: f64,
    /// True if its body was upright then: a robot without mass would fall.
    pub is_upright: bool,
}

/// The kind of a fall, defined once for terminal, page and logs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FallKind {
    /// The body came down.
    Fell,
    /// A robot without mass, whose body stays upright, would fall.
    WouldFall,
    /// A robot with mass lost its support, and its body was upright then.
    LostSupport,
}

impl FallKind {
    /// Returns the kind of a fall of a robot in motion.
    pub const fn of(motion: &Motion, is_upright: bool) -> Self {
        match (is_upright, motion.unmodelled.is_none()) {
            (false, _) => FallKind::Fell,
            (true, false) => FallKind::WouldFall,
            (true, true) => FallKind::LostSupport,
        }
    }
}

impl fmt::Display for FallKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            FallKind::Fell => "the robot fell",
            FallKind::WouldFall => "the robot would fall: its feet do not hold its centre of mass",
            FallKind::LostSupport => "the robot lost its support",
        })
    }
}

/// Two parts of a robot near each other, and the step that ran then.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Approach {
    /// The parts, and the distance between them.
    pub gap: Gap,
    /// The control cycle, from 0.
    pub cycle: u64,
    /// Time at which that cycle began, ms.
    pub time: f64,
    /// The step that ran in it.
    pub step: u32,
}

/// The falls and collisions of a run so far, with the steps that ran then.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Incidents {
    /// The first fall.
    pub(crate) fall: Option<Fall>,
    /// The distances of parts.
    pub(crate) clearance: Option<Clearance>,
    /// The smallest distance of two parts.
    pub(crate) nearest: Option<Approach>,
    /// The first collision of two parts.
    pub(crate) collision: Option<Approach>,
}

// Out of line, or it would be copied for each number of legs.
#[inline(never)]
fn gather<const J: usize>(
    angles: &[[f64; J]],
    torques: &[[f64; J]],
    loads: &[f64],
    forces: &[[f64; 3]],
    slips: &[f64],
) -> Limbs {
    Limbs {
        angles: rows(angles.as_flattened(), J),
        loads: loads.to_vec(),
        forces: forces.to_vec(),
        slips: slips.to_vec(),
        torques: rows(torques.as_flattened(), J),
    }
}

fn rows(all: &[f64], joints: usize) -> Vec<Vec<f64>> {
    all.chunks_exact(joints).map(<[f64]>::to_vec).collect()
}
