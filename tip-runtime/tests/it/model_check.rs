//! Models written in Rust, and the errors that are found in them.

use tip_runtime::model::{
    Body, Forces, InertialProperties, Inverse, Joint, Leg, Model, Range, Slider, TorqueUnit,
    VibrationGain, generic, hand, titan8,
};

const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

const LEG: Leg<2> = Leg::at(
    [0.0, 100.0, 0.0],
    [
        Joint::revolute(Z, [50.0, 0.0, 0.0]).limits(-60.0, 60.0),
        Joint::revolute(Y, [100.0, 0.0, 0.0]).mass(0.3).torque(5.0),
    ],
)
.initial([10.0, 30.0]);

const PAIR: Model<2, 2> = Model {
    body: Some(Body {
        x: Range::new(-10.0, 10.0),
        y: Range::new(-10.0, 10.0),
        z: Range::new(-10.0, 10.0),
        mass: 0.0,
        inertial: None,
    }),
    forces: Some(Forces {
        unit: TorqueUnit::NewtonMetre,
        torque_max: 5.0,
        angle_stiffness: 1.0,
        position_stiffness: 1.0,
        search_torque: 0.0,
        search_force: 0.0,
        contact_torque: 0.0,
    }),
    slider: Some(Slider {
        initial: [0.0; 3],
        travel: [Range::new(-1.0, 1.0); 3],
    }),
    ..Model::generic("pair", [LEG, LEG])
};

/// Returns the error of the pair after a change.
fn wrong(change: impl Fn(&mut Model<2, 2>)) -> String {
    let mut model = PAIR;
    change(&mut model);
    match model.check() {
        Ok(()) => "nothing".to_owned(),
        Err(error) => error.to_string(),
    }
}

fn body(model: &mut Model<2, 2>) -> &mut Body {
    model.body.as_mut().expect("it has one")
}

#[test]
fn what_is_left_out_has_a_default() {
    let [first, second] = LEG.joints;
    assert_eq!((first.mass, first.torque), (0.1, 10.0));
    assert_eq!(first.outer, Range::new(-65.0, 65.0));
    assert_eq!(second.limits, Range::new(-180.0, 180.0));
    assert_eq!((second.mass, second.torque), (0.3, 5.0));
    let bolted = Model::generic("bolted", [LEG]);
    assert_eq!(bolted.body, None);
    assert_eq!(bolted.forces, None);
    assert_eq!(bolted.standards, generic::MODEL.standards);
    assert_eq!(bolted.signature().legs, 1);
}

#[test]
fn the_known_robots_and_the_pair_are_sound() {
    assert_eq!(titan8::MODEL.check(), Ok(()));
    assert_eq!(generic::MODEL.check(), Ok(()));
    assert_eq!(hand::MODEL.check(), Ok(()));
    assert_eq!(wrong(|_| {}), "nothing");
}

#[test]
fn legs_and_joints_are_named() {
    let ordered = "must be finite, the lower end not above the upper one";
    assert_eq!(
        wrong(|m| m.legs[1].joints[0].limits = Range::new(60.0, -60.0)),
        format!("J21: limits {ordered}")
    );
    assert_eq!(
        wrong(|m| m.legs[0].joints[1].outer = Range::new(f64::NAN, 200.0)),
        format!("J12: outer {ordered}")
    );
    assert_eq!(
        wrong(|m| m.legs[0].joints[1].outer = Range::new(-100.0, 200.0)),
        "J12: outer must contain the limits"
    );
    for axis in [[0.0; 3], [0.0, 0.0, 2.0], [0.0, 0.6, 0.7]] {
        assert_eq!(
            wrong(|m| m.legs[1].joints[1].axis = axis),
            "J22: axis must have length 1"
        );
    }
    assert_eq!(
        wrong(|m| m.legs[1].joints[1].axis[0] = f64::INFINITY),
        "J22: axis must be finite numbers"
    );
    assert_eq!(
        wrong(|m| m.legs[0].joints[0].link[2] = f64::NAN),
        "J11: link must be finite numbers"
    );
    assert_eq!(
        wrong(|m| m.legs[0].joints[0].mass = -0.1),
        "J11: mass must be a finite number, not below 0"
    );
    let a_body = "must be finite, with the inertia of some rigid body";
    for inertia in [
        [1.0, 1.0, 2.1, 0.0, 0.0, 0.0],
        [1.0, 1.0, 1.0, 0.9, 0.9, 0.0],
        [-1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
        [1.0, 1.0, f64::NAN, 0.0, 0.0, 0.0],
    ] {
        let inertial = Some(InertialProperties {
            centre: [0.0; 3],
            inertia,
        });
        assert_eq!(
            wrong(|m| m.legs[0].joints[1].inertial = inertial),
            format!("J12: inertial {a_body}")
        );
    }
    for inertia in [[1.0, 1.0, 2.0, 0.0, 0.0, 0.0], [0.0; 6]] {
        let inertial = Some(InertialProperties {
            centre: [1.0, -2.0, 3.0],
            inertia,
        });
        assert_eq!(
            wrong(|m| m.legs[0].joints[1].inertial = inertial),
            "nothing"
        );
    }
    assert_eq!(
        wrong(|m| m.legs[0].joints[0].torque = 0.0),
        "J11: torque must be a finite number above 0"
    );
    assert_eq!(
        wrong(|m| m.legs[1].initial[0] = 61.0),
        "J21: initial must lie within the limits"
    );
    assert_eq!(
        wrong(|m| m.legs[1].base[0] = f64::NAN),
        "F2: base must be finite numbers"
    );
    assert_eq!(
        wrong(|m| m.legs[1].joints = LEG.joints.map(|joint| Joint {
            link: [0.0; 3],
            ..joint
        })),
        "F2: links must have a length, at least one of them"
    );
}

#[test]
fn the_inverse_kinematics_must_fit_the_legs() {
    assert_eq!(
        wrong(|m| m.inverse = Inverse::Planar),
        "F1: joints must have vertical axes only"
    );
    assert!(wrong(|m| m.inverse = Inverse::YawPitchPitch).starts_with("F1: joints must be a"));
    let fits = |change: fn(&mut Leg<3>)| {
        let mut leg = titan8::MODEL.legs[2];
        change(&mut leg);
        Inverse::YawPitchPitch.fits(&leg.joints)
    };
    assert!(fits(|_| {}));
    assert!(!fits(|leg| leg.joints[0].link[2] = 5.0));
    assert!(!fits(|leg| leg.joints[1].link[1] = 5.0));
    assert!(!fits(|leg| leg.joints[2].link[0] *= -1.0));
    assert!(!fits(|leg| leg.joints[2].axis = Z));
    assert!(!fits(|leg| leg.joints[2].limits = Range::new(-150.0, -5.0)));
    assert!(!fits(|leg| leg.joints[0].axis = Y));
}

#[test]
fn the_rest_of_a_robot_is_checked_as_well() {
    assert_eq!(wrong(|m| m.name = ""), "robot: name must not be empty");
    assert_eq!(
        wrong(|m| body(m).z = Range::new(1.0, -1.0)),
        "body: z must be finite, the lower end not above the upper one"
    );
    assert_eq!(
        wrong(|m| body(m).mass = f64::NAN),
        "body: mass must be a finite number, not below 0"
    );
    let massless = |m: &mut Model<2, 2>| {
        let joints = m.legs.iter_mut().flat_map(|leg| &mut leg.joints);
        joints.for_each(|joint| joint.mass = 0.0);
    };
    assert_eq!(
        wrong(massless),
        "body: mass or that of a link must be above 0"
    );
    assert_eq!(
        wrong(|m| m.standards.a_max = 0.0),
        "standards: a_max must be a finite number above 0"
    );
    assert_eq!(
        wrong(|m| m.standards.period = 0.5),
        "standards: period must lie within the robot's periods"
    );
    assert_eq!(
        wrong(|m| m.periods.min = 0.0),
        "robot: periods must be above 0"
    );
    assert_eq!(
        wrong(|m| m.forces.as_mut().expect("some").torque_max = -1.0),
        "forces: torque_max must be a finite number, not below 0"
    );
    assert_eq!(
        wrong(|m| m.slider.as_mut().expect("some").initial[1] = 2.0),
        "slider: initial must lie within the travel"
    );
    let endless = VibrationGain {
        angle: 0.5,
        torque: f64::INFINITY,
    };
    assert_eq!(
        wrong(|m| m.vibration = Some(endless)),
        "vibration: torque must be a finite number, not below 0"
    );
    let none: Model<0, 2> = Model::generic("none", []);
    let wanted = "robot: legs must be 1 to 9";
    assert_eq!(
        none.check().map_err(|error| error.to_string()),
        Err(wanted.to_owned())
    );
    let many = Model::generic("many", [Leg::at([0.0; 3], [LEG.joints[0]; 10])]);
    let wanted = "robot: joints must be 1 to 9";
    assert_eq!(
        many.check().map_err(|error| error.to_string()),
        Err(wanted.to_owned())
    );
}
