//! Hiroshima Hand: three fingers of three joints that move in the x–y plane, and a slider.
//!
//! A link hangs straight down from the palm at 0 deg; angles add up along the finger, and positive
//! ones close it towards the centre. F1 opposes F2 and F3, which are apart along z.
//!
//! Link lengths, limits and masses are assumptions: no public figures exist. They are data, to be
//! replaced by those of the robot at hand.
//!
//! ```
//! use tip_runtime::model::hand;
//!
//! let [first, second, third] = &hand::MODEL.legs;
//! assert_eq!((first.base[0], second.base[0], third.base[0]), (-60.0, 60.0, 60.0));
//! # #[cfg(feature = "control")] {
//! use tip_runtime::kinematics::Chain;
//!
//! // Straight down, then turned by 90 deg towards the centre: 70, 50 and 40 mm.
//! let [x, y, _] = Chain::new(first, &[0.0; 3]).foot();
//! assert!((x + 60.0).abs() < 1e-9 && (y + 160.0).abs() < 1e-9);
//! let [x, y, _] = Chain::new(first, &[90.0, 0.0, 0.0]).foot();
//! assert!((x - 100.0).abs() < 1e-9 && y.abs() < 1e-9);
//! # }
//! ```

use super::{
    Family, Forces, Inverse, Joint, Leg, Model, Range, Slider, Standards, TorqueUnit, VibrationGain,
};

const L1: f64 = 70.0;
const L2: f64 = 50.0;
const L3: f64 = 40.0;

/// Distance of F2 and F3 from F1 to the side, mm.
const APART: f64 = 30.0;

/// The robot.
pub const MODEL: Model<3, 3> = Model {
    name: "hand",
    family: Family::Hand,
    legs: [finger(-1.0, 0.0), finger(1.0, -APART), finger(1.0, APART)],
    inverse: Inverse::Planar,
    body: None,
    standards: Standards {
        v_max: 100.0,
        a_max: 400.0,
        omega_max: 90.0,
        omega_dot_max: 360.0,
        just_position: 1.0,
        just_angle: 1.0,
        near_position: 5.0,
        near_angle: 5.0,
        period: 2.0,
    },
    periods: Range::new(1.0, 100.0),
    contact: 0.5,
    lamps: 2,
    forces: Some(Forces {
        unit: TorqueUnit::MillinewtonMetre,
        torque_max: 1000.0,
        angle_stiffness: 20.0,
        position_stiffness: 0.1,
        search_torque: 60.0,
        search_force: 0.5,
        contact_torque: 10.0,
    }),
    slider: Some(Slider {
        initial: [0.0, -130.0, 0.0],
        travel: [
            Range::new(0.0, 0.0),
            Range::new(-200.0, -60.0),
            Range::new(0.0, 0.0),
        ],
    }),
    vibration: Some(VibrationGain {
        angle: 0.5,
        torque: 10.0,
    }),
};

/// Returns a finger on the `side` (−1 left, +1 right) of the palm.
const fn finger(side: f64, z: f64) -> Leg<3> {
    Leg {
        base: [side * 60.0, 0.0, z],
        joints: [
            joint(side, L1, Range::new(-90.0, 90.0), 0.060),
            joint(side, L2, Range::new(-10.0, 110.0), 0.040),
            joint(side, L3, Range::new(-10.0, 110.0), 0.025),
        ],
        initial: [-40.0, 0.0, 80.0],
    }
}

/// Its motor gives half more than the standard TORQUE_MAX, so that FIRMLY means something.
const fn joint(side: f64, length: f64, limits: Range, mass: f64) -> Joint {
    Joint {
        axis: [0.0, 0.0, -side],
        link: [0.0, -length, 0.0],
        limits,
        outer: limits.widened(5.0),
        mass,
        spread: None,
        torque: 1.5,
    }
}
