//! The robots with a name, as data.

pub mod titan8 {
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

    use crate::model::{Body, Family, Inverse, Joint, Leg, Model, Range, Standards, TOUCHING};

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
            inertial: None,
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
        may_touch: [None; TOUCHING],
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
            inertial: None,
            torque: 40.0,
            radius: None,
        }
    }
}

pub mod hand {
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

    use crate::model::{
        Family, Forces, Inverse, Joint, Leg, Model, Range, Slider, Standards, TOUCHING, TorqueUnit,
        VibrationGain,
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
        may_touch: [None; TOUCHING],
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
            inertial: None,
            torque: 1.5,
            radius: None,
        }
    }
}

pub mod generic {
    //! The generic robot when no description is given: TITAN VIII's geometry under another name.
    //!
    //! ```
    //! use tip_runtime::model::{Family, generic, titan8};
    //!
    //! assert_eq!(generic::MODEL.legs, titan8::MODEL.legs);
    //! assert_eq!(generic::MODEL.family, Family::Generic);
    //! assert!(generic::MODEL.forces.is_some(), "it takes torques as well");
    //! ```

    use crate::model::{Family, Forces, Model, TorqueUnit, titan8};

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
}
