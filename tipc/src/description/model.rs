//! Results of a description: facts for checking programs, and a model of the runtime.

use super::section::{Found, Section};
use super::{Description, Leg, Shapes};
use crate::message::Describing;
use crate::robot::{Facts, Robot};
use tip_runtime::model::{self, Family, Inverse, Model};
use tip_runtime::program::Signature;

/// An action on the model of a robot with any number of legs and joints.
pub trait WithModel {
    /// The result.
    type Output;

    /// Performs the action with a robot of `L` legs with `J` joints each.
    fn with<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Self::Output;
}

/// Chooses the size of a model at runtime: one arm for each number of legs and joints.
macro_rules! any_size {
    ($description:expr, $with:expr; $($legs:literal)*) => {
        any_size!(@legs $description, $with; $($legs)*; [1 2 3 4 5 6 7 8 9])
    };
    (@legs $description:expr, $with:expr; $($legs:literal)*; $joints:tt) => {
        match $description.legs.len() {
            $( $legs => any_size!(@joints $description, $with; $legs; $joints), )*
            _ => None,
        }
    };
    (@joints $description:expr, $with:expr; $legs:literal; [$($joints:literal)*]) => {
        match $description.joints() {
            $( $joints => $description.model::<$legs, $joints>().map(|model| $with.with(&model)), )*
            _ => None,
        }
    };
}

impl Description {
    /// Returns the robot's name.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the number of joints on each leg.
    pub(super) fn joints(&self) -> usize {
        self.legs.first().map_or(0, |leg| leg.joints.len())
    }

    /// Returns the robot that programs are checked for.
    pub fn robot(&self) -> Robot {
        Robot::Described(self.facts())
    }

    /// Returns all that checking needs of it.
    pub fn facts(&self) -> Facts {
        Facts {
            signature: Signature {
                robot: self.name,
                family: Family::Generic,
                legs: self.legs.len() as u8,
                joints: self.joints() as u8,
            },
            period: self.standards.period,
            periods: self.periods,
            lamps: self.lamps,
            has_forces: self.forces.is_some(),
            has_slider: self.slider.is_some(),
            limits: self.limits,
        }
    }

    /// Returns the robot as the runtime knows it; `None` unless it has `L` legs with `J` joints each.
    pub fn model<const L: usize, const J: usize>(&self) -> Option<Model<L, J>> {
        let one = self.with_one_leg::<J>()?;
        let mut model = one.with_legs([one.legs[0]; L]);
        self.put(&mut model.legs)?;
        Some(model)
    }

    /// Returns the model as if the robot had only its first leg: code that does not depend on the number of legs is
    /// compiled once.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn with_one_leg<const J: usize>(&self) -> Option<Model<1, J>> {
        Some(Model {
            inverse: self.inverse,
            body: self.body,
            standards: self.standards,
            periods: self.periods,
            contact: self.contact,
            lamps: self.lamps,
            forces: self.forces,
            slider: self.slider,
            may_touch: self.may_touch,
            ..Model::generic(self.name, [self.legs.first()?.sized()?])
        })
    }

    /// Fills in the legs of a model, if it has as many.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn put<const J: usize>(&self, legs: &mut [model::Leg<J>]) -> Option<()> {
        if legs.len() != self.legs.len() {
            return None;
        }
        for (leg, described) in legs.iter_mut().zip(&self.legs) {
            *leg = described.sized()?;
        }
        Some(())
    }

    /// Returns the shapes of its links and its body; no model holds them.
    pub fn shapes(&self) -> Shapes {
        Shapes {
            body: self.shapes.clone(),
            legs: self.legs.iter().map(|leg| leg.shapes.clone()).collect(),
        }
    }

    /// Does something with the model, which has 1 to 9 legs of 1 to 9 joints.
    ///
    /// # Panics
    /// Never: a description has legs and joints of these numbers.
    pub fn with_model<W: WithModel>(&self, with: W) -> W::Output {
        any_size!(self, with; 1 2 3 4 5 6 7 8 9).expect("1 to 9 legs of 1 to 9 joints")
    }
}

impl Leg {
    fn sized<const J: usize>(&self) -> Option<model::Leg<J>> {
        Some(model::Leg {
            base: self.base,
            joints: self.joints.as_slice().try_into().ok()?,
            initial: self.initial.as_slice().try_into().ok()?,
        })
    }
}

/// Returns the inverse kinematics: `chosen`, if every leg is such a chain, else the first one that fits all legs.
pub(super) fn inverse(
    robot: Section<'_>,
    chosen: Option<Inverse>,
    legs: &[Leg],
    found: &mut Found,
) -> Option<Inverse> {
    let misfit = |inverse: Inverse| legs.iter().position(|leg| !inverse.fits(&leg.joints));
    let Some(inverse) = chosen else {
        let all = [
            Inverse::YawPitchPitch,
            Inverse::RollPitchPitch,
            Inverse::Planar,
            Inverse::LeastSquares,
        ];
        return all.into_iter().find(|inverse| misfit(*inverse).is_none());
    };
    let Some(leg) = misfit(inverse) else {
        return Some(inverse);
    };
    let reason = Describing::JointsOfLeg {
        leg: leg + 1,
        wanted: inverse.wanted(),
    };
    robot.refuse("inverse", robot.location_of("inverse"), reason, found)
}
