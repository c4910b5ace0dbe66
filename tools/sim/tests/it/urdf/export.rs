//! Exported robots: what a URDF file can say of a robot comes back from it.

use crate::urdf::imported;
use crate::urdf::robots::{ARM, quadruped, urdf as text_of};
use tip_runtime::model::{Body, Joint, Leg, Model, Range};
use tip_sim::urdf::export;
use tip_sim::{Limb, Robot};

/// To a millionth of a mm or deg, as the importer writes it.
const ROUNDED: f64 = 1e-6;

fn near(ours: &[f64], theirs: &[f64], what: &str) {
    assert_eq!(ours.len(), theirs.len(), "{what}");
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= ROUNDED;
    assert!(
        ours.iter().zip(theirs).all(is_near),
        "{what}: {ours:?} is not {theirs:?}"
    );
}

fn numbers(joint: &Joint) -> Vec<f64> {
    let Joint {
        axis,
        link,
        limits,
        mass,
        torque,
        ..
    } = joint;
    [
        axis.as_slice(),
        link,
        &[limits.min, limits.max, *mass, *torque],
    ]
    .concat()
}

fn same_legs(ours: &[Limb], theirs: &[Limb], name: &str) {
    assert_eq!(ours.len(), theirs.len(), "{name}");
    for (leg, (ours, theirs)) in (1..).zip(ours.iter().zip(theirs)) {
        near(
            &ours.base,
            &theirs.base,
            &format!("{name}: base of leg {leg}"),
        );
        assert_eq!(ours.joints.len(), theirs.joints.len(), "{name}");
        for (joint, (ours, theirs)) in (1..).zip(ours.joints.iter().zip(&theirs.joints)) {
            near(
                &numbers(ours),
                &numbers(theirs),
                &format!("{name}: J{leg}{joint}"),
            );
        }
    }
}

fn ends(range: Range) -> [f64; 2] {
    [range.min, range.max]
}

/// Exports a robot, imports it again, and holds the two against each other.
fn returns(robot: &Robot) {
    let name = robot.name();
    let (import, _) = imported(&export(robot));
    let again =
        Robot::from_description(&import.toml).unwrap_or_else(|error| panic!("{name}: {error}"));
    let (ours, theirs) = (robot.description(), again.description());
    same_legs(&ours.legs, &theirs.legs, name);
    assert_eq!(ours.inverse, theirs.inverse, "{name}");
    near(
        &[ours.standards.omega_max],
        &[theirs.standards.omega_max],
        name,
    );
    let box_of = |body: &Body| [ends(body.x), ends(body.y), ends(body.z), [body.mass, 0.0]];
    match (
        ours.body.as_ref().map(box_of),
        theirs.body.as_ref().map(box_of),
    ) {
        (Some(ours), Some(theirs)) => near(ours.as_flattened(), theirs.as_flattened(), name),
        (ours, theirs) => assert_eq!(ours, theirs, "{name}: the body"),
    }
    match (ours.slider, theirs.slider) {
        (Some(ours), Some(theirs)) => {
            near(&ours.initial, &theirs.initial, name);
            let travel = [ours.travel.map(ends), theirs.travel.map(ends)];
            near(travel[0].as_flattened(), travel[1].as_flattened(), name);
        }
        (ours, theirs) => assert_eq!(ours, theirs, "{name}: the slider"),
    }
}

#[test]
fn robots_with_names_return() {
    for name in ["titan8", "generic", "hand"] {
        returns(&Robot::named(name).expect("it is known"));
    }
}

#[test]
fn described_robots_return() {
    for toml in [
        include_str!("../../../../../tipc/tests/robots/hexapod.toml"),
        include_str!("../../../../../tests/language/cases/robots/nine.toml"),
        include_str!("../../../../../tests/language/cases/robots/one.toml"),
        include_str!("../../../../../tests/language/cases/robots/radial.toml"),
    ] {
        returns(&Robot::from_description(toml).expect("it is a robot"));
    }
}

#[test]
fn imported_robots_return() {
    for text in [text_of(ARM), text_of(&quadruped())] {
        let (import, _) = imported(&text);
        returns(&Robot::from_description(&import.toml).expect("it is a robot"));
    }
}

/// Two legs on a body, a joint without length, one without mass; and names that XML would misread.
#[test]
fn a_sled_with_a_slider_in_every_direction_returns() {
    static SLED: Model<2, 2> = Model {
        body: Some(Body {
            x: Range::new(-80.0, 81.0),
            y: Range::new(-150.0, 140.0),
            z: Range::new(-180.0, 40.0),
            mass: 4.0,
            inertial: None,
        }),
        slider: Some(tip_runtime::model::Slider {
            initial: [1.0, 2.0, 3.0],
            travel: [
                Range::new(-5.0, 1.0),
                Range::new(2.0, 7.5),
                Range::new(3.0, 3.0),
            ],
        }),
        ..Model::generic("<sled> & \"co\"", [arm(-1.0), arm(1.0)])
    };
    const fn arm(side: f64) -> Leg<2> {
        let joints = [
            Joint::revolute([0.0, -side, 0.0], [0.0; 3]).mass(0.0),
            Joint::revolute([0.6, 0.0, 0.8], [0.0, 12.5, -180.0]).limits(-90.0, 90.0),
        ];
        Leg::at([side * 80.0, 0.0, 0.0], joints)
    }
    returns(&Robot::of(&SLED));
}

#[test]
fn a_robot_stands_or_hangs_as_its_model_says() {
    let titan = export(&Robot::named("titan8").expect("it is known"));
    assert!(!titan.contains("link=\"world\""), "it walks");
    // 240 × 460 × 250 mm across, along and up; x is forward in URDF.
    assert!(titan.contains("<box size=\"0.46 0.24 0.25\"/>"), "{titan}");
    assert!(titan.contains("<mass value=\"12\"/>"));
    // F1's hip is 201 mm forward and 101 mm to the left.
    assert!(titan.contains("<origin xyz=\"0.201 0.101 0\" rpy=\"0 0 0\"/>"));
    let hand = export(&Robot::named("hand").expect("it is known"));
    assert!(hand.contains("<parent link=\"world\"/><child link=\"base_link\"/>"));
    // From 130 mm below the palm the slider sinks 70 mm more and rises 70 mm.
    assert!(
        hand.contains("<limit lower=\"-0.07\" upper=\"0.07\""),
        "{hand}"
    );
}

/// A rod of 100 g, 120 mm long: m l² / 12 across it, when it is thin.
#[test]
fn masses_lie_in_the_middle_of_the_links() {
    let hexapod = include_str!("../../../../../tipc/tests/robots/hexapod.toml");
    let text = export(&Robot::from_description(hexapod).expect("it is a robot"));
    let shank = text
        .split("<link name=\"link23\">")
        .nth(1)
        .expect("the shank of F2");
    let inertial = shank.split("</inertial>").next().expect("it has mass");
    // It points to the right, which is −y.
    assert!(inertial.contains("<origin xyz=\"0 -0.06 0\""), "{inertial}");
    let across = inertial
        .split("ixx=\"")
        .nth(1)
        .and_then(|rest| rest.split('"').next());
    let across: f64 = across
        .and_then(|number| number.parse().ok())
        .expect("a number");
    // Links of 50, 100 and 120 mm are drawn 9 mm thick.
    let expected = 0.1 * (3.0 * 0.009 * 0.009 + 0.12 * 0.12) / 12.0;
    assert!(
        (across - expected).abs() < 1e-12,
        "{across} is not {expected}"
    );
}

/// A slider that another program wrote: 150 mm to the right and 250 mm to the left of where it stands, and up to 100 mm down.
#[test]
fn prismatic_joints_to_a_link_floor_are_a_slider() {
    let gantry = include_str!("../../../../../tests/external/urdf/robots/gantry.urdf");
    let (import, _) = imported(gantry);
    let robot = Robot::from_description(&import.toml).expect("it is a robot");
    let slider = robot.description().slider.expect("it has one");
    near(&slider.initial, &[0.0, 300.0, -140.0], "initial");
    let travel = [[-250.0, 150.0], [300.0, 300.0], [-240.0, -140.0]];
    near(
        slider.travel.map(ends).as_flattened(),
        travel.as_flattened(),
        "travel",
    );
    let report: Vec<String> = import.report.iter().map(ToString::to_string).collect();
    assert!(report.join("\n").contains("FLOOR"), "{report:?}");
    // Where it is bolted down does not turn the robot frame.
    assert_eq!(robot.description().body, None);
    let (other, _) = imported(&gantry.replace("0 0 0.9\" rpy=\"0 0 0.5", "0 0 0"));
    assert_eq!(import.toml, other.toml);
    returns(&robot);

    let error = tip_sim::import::import("test.urdf", &gantry.replace("\"floor\"", "\"desk\""));
    let error = error.expect_err("it is a leg that slides").to_string();
    assert!(
        error.contains("joint `across` on link `base_link` is prismatic"),
        "{error}"
    );
}
