//! Descriptions in Rust: constants with a default for whatever they leave out.

use super::{Inverse, Joint, Leg, Model, Point, Range, Spread, generic};

/// Margin by which the potentiometers measure beyond the working limits, deg.
const OUTER: f64 = 5.0;

impl Joint {
    /// Returns a joint that turns about `axis`, a unit vector in the frame of the link before, and
    /// carries a link that goes from it to the next joint, or to the foot, by `link` (mm) at angle
    /// 0. It turns from −180 to 180 deg; its link has 0.1 kg, its motor 10 N·m.
    #[must_use]
    pub const fn revolute(axis: [f64; 3], link: [f64; 3]) -> Self {
        Joint {
            axis,
            link,
            limits: Range::new(-180.0, 180.0),
            outer: Range::new(-180.0 - OUTER, 180.0 + OUTER),
            mass: 0.1,
            spread: None,
            torque: 10.0,
        }
    }

    /// Sets the working limits, deg; the potentiometers measure 5 deg beyond.
    #[must_use]
    pub const fn limits(self, min: f64, max: f64) -> Self {
        let limits = Range::new(min, max);
        Joint {
            limits,
            outer: limits.widened(OUTER),
            ..self
        }
    }

    /// Sets the mass of the link, kg.
    #[must_use]
    pub const fn mass(self, mass: f64) -> Self {
        Joint { mass, ..self }
    }

    /// Sets the distribution of the mass.
    #[must_use]
    pub const fn spread(self, spread: Spread) -> Self {
        Joint {
            spread: Some(spread),
            ..self
        }
    }

    /// Sets the torque of the motor, N·m.
    #[must_use]
    pub const fn torque(self, torque: f64) -> Self {
        Joint { torque, ..self }
    }
}

impl<const J: usize> Leg<J> {
    /// Returns a leg whose first joint is at `base` (mm, in the robot frame); all its angles are 0
    /// at first.
    #[must_use]
    pub const fn at(base: Point, joints: [Joint; J]) -> Self {
        Leg {
            base,
            joints,
            initial: [0.0; J],
        }
    }

    /// Sets the initial posture, deg.
    #[must_use]
    pub const fn initial(self, initial: [f64; J]) -> Self {
        Leg { initial, ..self }
    }
}

impl<const L: usize, const J: usize> Model<L, J> {
    /// Returns a robot with the commands marked G: bolted down, without torques and slider, its
    /// joint angles found by least squares; everything else is as [`generic::MODEL`] has it.
    #[must_use]
    pub const fn generic(name: &'static str, legs: [Leg<J>; L]) -> Self {
        Model {
            name,
            family: generic::MODEL.family,
            legs,
            inverse: Inverse::LeastSquares,
            body: None,
            standards: generic::MODEL.standards,
            periods: generic::MODEL.periods,
            contact: generic::MODEL.contact,
            lamps: generic::MODEL.lamps,
            forces: None,
            slider: None,
            vibration: None,
        }
    }

    /// Returns the robot with these legs.
    #[must_use]
    pub const fn with_legs<const N: usize>(self, legs: [Leg<J>; N]) -> Model<N, J> {
        Model {
            legs,
            name: self.name,
            family: self.family,
            inverse: self.inverse,
            body: self.body,
            standards: self.standards,
            periods: self.periods,
            contact: self.contact,
            lamps: self.lamps,
            forces: self.forces,
            slider: self.slider,
            vibration: self.vibration,
        }
    }
}
