//! TITAN VIII: four legs of yaw, thigh and knee.
//!
//! Link lengths, limits and masses are assumptions: no public figures exist. They are data, to be
//! replaced by those of the robot at hand.
//!
//! ```
//! use tip_runtime::model::titan8::MODEL;
//!
//! let joints = MODEL.legs.iter().flat_map(|leg| &leg.joints);
//! let legs: f64 = joints.map(|joint| joint.mass).sum();
//! let body = MODEL.body.expect("it walks").mass;
//! assert!((body + legs - 20.0).abs() < 1e-9, "kg");
//!
//! assert!(MODEL.legs[0].joints[2].limits.contains(90.0));
//! assert_eq!(MODEL.check(), Ok(()));
//! ```

use super::{Body, Family, Inverse, Joint, Leg, Model, Range, Standards};

const L1: f64 = 50.0;
const L2: f64 = 240.0;
const L3: f64 = 200.0;

/// The robot.
pub const MODEL: Model<4, 3> = Model {
    name: "titan8",
    family: Family::Titan,
    legs: [
        leg(-1.0, 1.0),
        leg(1.0, 1.0),
        leg(-1.0, -1.0),
        leg(1.0, -1.0),
    ],
    inverse: Inverse::YawPitchPitch,
    body: Some(Body {
        x: Range::new(-120.0, 120.0),
        y: Range::new(-230.0, 230.0),
        z: Range::new(-200.0, 50.0),
        mass: 12.0,
        spread: None,
    }),
    standards: Standards {
        v_max: 300.0,
        a_max: 600.0,
        omega_max: 90.0,
        omega_dot_max: 360.0,
        just_position: 2.0,
        just_angle: 1.0,
        near_position: 10.0,
        near_angle: 5.0,
        period: 20.0,
    },
    periods: Range::new(1.0, 1000.0),
    contact: 0.25,
    lamps: 8,
    forces: None,
    slider: None,
    vibration: None,
};

/// Returns a leg whose hip is on the `side` (−1 left, +1 right) and towards the `end` (−1 rear, +1
/// front).
const fn leg(side: f64, end: f64) -> Leg<3> {
    Leg {
        base: [side * 101.0, end * 201.0, 0.0],
        joints: [
            joint([0.0, 0.0, side], side * L1, 60.0, -60.0, 0.8),
            joint([0.0, -side, 0.0], side * L2, 75.0, -60.0, 0.8),
            Joint {
                outer: Range::new(0.0, 155.0),
                ..joint([0.0, side, 0.0], side * L3, 150.0, 5.0, 0.4)
            },
        ],
        initial: [0.0, 0.0, 90.0],
    }
}

const fn joint(axis: [f64; 3], length: f64, max: f64, min: f64, mass: f64) -> Joint {
    Joint {
        axis,
        link: [length, 0.0, 0.0],
        limits: Range::new(min, max),
        outer: Range::new(min - 5.0, max + 5.0),
        mass,
        spread: None,
        torque: 40.0,
    }
}
