//! The generic robot when no description is given: TITAN VIII's geometry under another name.

use super::{Family, Model, titan8};

/// The robot.
pub const MODEL: Model<4, 3> = Model {
    name: "generic",
    family: Family::Generic,
    lamps: 16,
    ..titan8::MODEL
};
