//! The facts of a model that hold for the whole robot, with any number of legs.

use super::{Family, Forces, Inverse, Joint, Leg, Model, Range, Slider, Standards, VibrationGain};

/// A model without its legs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModelFacts {
    pub(crate) family: Family,
    pub(crate) inverse: Inverse,
    pub(crate) standards: Standards,
    pub(crate) periods: Range,
    pub(crate) contact: f64,
    pub(crate) lamps: u8,
    pub(crate) forces: Option<Forces>,
    pub(crate) slider: Option<Slider>,
    pub(crate) vibration: Option<VibrationGain>,
}

impl ModelFacts {
    pub(crate) const fn of<const L: usize, const J: usize>(model: &Model<L, J>) -> Self {
        ModelFacts {
            family: model.family,
            inverse: model.inverse,
            standards: model.standards,
            periods: model.periods,
            contact: model.contact,
            lamps: model.lamps,
            forces: model.forces,
            slider: model.slider,
            vibration: model.vibration,
        }
    }

    /// Returns the number of the robot's torque units in 1 N·m.
    pub(crate) fn torque_unit(&self) -> f64 {
        self.forces
            .map_or(1.0, |forces| forces.unit.per_newton_metre())
    }
}

impl<const J: usize> Leg<J> {
    /// Placeholder for arrays that are filled in over a slice, which compiles once for all of their
    /// lengths; `map` of an array does not.
    pub(crate) const BLANK: &'static Self =
        &Leg::at([0.0; 3], [Joint::revolute([0.0, 0.0, 1.0], [0.0; 3]); J]);

    /// Returns the nearest angles to these within the working limits, deg.
    pub(crate) fn within_limits(&self, angles: &[f64; J]) -> [f64; J] {
        let mut within = *angles;
        for (angle, joint) in within.iter_mut().zip(&self.joints) {
            *angle = joint.limits.nearest(*angle);
        }
        within
    }
}

impl Range {
    /// Returns the place in the interval that is nearest to `value`.
    pub(crate) const fn nearest(&self, value: f64) -> f64 {
        value.max(self.min).min(self.max)
    }

    /// Returns the range of a joint at `value`: one that is beyond its limits already may come back, not go on.
    pub(crate) const fn including(&self, value: f64) -> Self {
        Range::new(self.min.min(value), self.max.max(value))
    }
}
