//! The generic robot when no description is given: TITAN VIII's geometry under another name.
//!
//! ```
//! use tip_runtime::model::{Family, generic, titan8};
//!
//! assert_eq!(generic::MODEL.legs, titan8::MODEL.legs);
//! assert_eq!(generic::MODEL.family, Family::Generic);
//! assert!(generic::MODEL.forces.is_some(), "it takes torques as well");
//! ```

use super::{Family, Forces, Model, TorqueUnit, titan8};

/// The robot.
pub const MODEL: Model<4, 3> = Model {
    name: "generic",
    family: Family::Generic,
    lamps: 16,
    forces: Some(Forces {
        unit: TorqueUnit::NewtonMetre,
        torque_max: 40.0,
        angle_stiffness: 2.0,
        position_stiffness: 1.0,
        search_torque: 5.0,
        search_force: 20.0,
        contact_torque: 1.0,
    }),
    ..titan8::MODEL
};
