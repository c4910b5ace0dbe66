//! Centres of mass and inertias, worked out by hand.

use crate::urdf::{imported, reported};
use tip_runtime::model::{InertialProperties, Leg, Model};

/// A link `rod` on the joint `a`, 0.1 m in front of the base, with a foot 0.3 m farther on.
fn rod(inertial: &str, foot: &str) -> String {
    format!(
        r#"<robot name="rod"><link name="base"/>
<link name="rod"><inertial>{inertial}</inertial></link>
<link name="foot">{foot}</link>
<joint name="a" type="revolute"><parent link="base"/><child link="rod"/><origin xyz="0.1 0 0"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="b" type="fixed"><parent link="rod"/><child link="foot"/><origin xyz="0.3 0 0"/></joint>
</robot>"#
    )
}

const INERTIA: &str =
    r#"<inertia ixx="0.001" iyy="0.002" izz="0.0025" ixy="0.0001" ixz="-0.0002" iyz="0.0003"/>"#;

#[track_caller]
fn near(ours: InertialProperties, centre: [f64; 3], inertia: [f64; 6]) {
    let centres = ours.centre.iter().zip(centre);
    let inertias = ours.inertia.iter().zip(inertia);
    assert!(
        centres.into_iter().all(|(a, b)| (a - b).abs() < 1e-6)
            && inertias.into_iter().all(|(a, b)| (a - b).abs() < 1e-12),
        "{ours:?}"
    );
}

fn leg(text: &str) -> Leg<1> {
    let model: Model<1, 1> = imported(text).1.model().expect("one joint");
    model.legs[0]
}

fn spread_of(text: &str) -> InertialProperties {
    leg(text).joints[0].inertial.expect("it is known")
}

#[test]
fn a_centre_and_an_inertia_are_seen_from_the_joint_in_the_robot_frame() {
    // Ahead is y, left is −x: x' = −y, y' = x.
    let inertial = format!("<origin xyz=\"0.02 0.05 -0.1\"/><mass value=\"2\"/>{INERTIA}");
    near(
        spread_of(&rod(&inertial, "")),
        [-50.0, 20.0, -100.0],
        [0.002, 0.001, 0.0025, -0.0001, -0.0003, -0.0002],
    );
    // A quarter turn about z before that: what was along x is along y.
    let turned = inertial.replace("-0.1\"", "-0.1\" rpy=\"0 0 1.5707963267948966\"");
    near(
        spread_of(&rod(&turned, "")),
        [-50.0, 20.0, -100.0],
        [0.001, 0.002, 0.0025, 0.0001, 0.0002, -0.0003],
    );
}

#[test]
fn links_that_move_as_one_are_added_up() {
    let small =
        r#"<mass value="1"/><inertia ixx="1e-6" iyy="1e-6" izz="1e-6" ixy="0" ixz="0" iyz="0"/>"#;
    let both = rod(small, &format!("<inertial>{small}</inertial>"));
    // 1 kg at the joint and 1 kg 300 mm ahead of it: 2 kg · (0.15 m)² about x and z.
    near(
        spread_of(&both),
        [0.0, 150.0, 0.0],
        [0.045 + 2e-6, 2e-6, 0.045 + 2e-6, 0.0, 0.0, 0.0],
    );
    // What weighs nothing adds nothing, whatever it says.
    let nothing = small.replace("\"1\"", "\"0\"");
    let one = rod(small, &format!("<inertial>{nothing}</inertial>"));
    near(spread_of(&one), [0.0; 3], [1e-6, 1e-6, 1e-6, 0.0, 0.0, 0.0]);
}

#[test]
fn inertias_that_only_fill_places_are_doubted_and_left_out() {
    let robot = |elements: [f64; 3]| {
        let [xx, yy, zz] = elements;
        let inertia = format!(
            "<mass value=\"2\"/><inertia ixx=\"{xx}\" iyy=\"{yy}\" izz=\"{zz}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>"
        );
        rod(&inertia, "")
    };
    // 400 mm from end to end: 2 kg · (0.4 m)².
    for sound in [[0.31, 0.31, 0.31], [0.1, 0.1, 0.2]] {
        let said = reported(&imported(&robot(sound)).0);
        assert!(!said.contains("rigid body"), "{said}");
        assert!(leg(&robot(sound)).joints[0].inertial.is_some());
    }
    for doubtful in [[0.33, 0.33, 0.33], [0.1, 0.1, 0.201]] {
        let said = reported(&imported(&robot(doubtful)).0);
        let line = "that of no rigid body, or of one larger than the robot; they count as point masses, and where they are most of the mass that moves as one, its inertia is that of a uniform rod or box: rod";
        assert!(said.contains(line), "{said}");
        let joint = leg(&robot(doubtful)).joints[0];
        assert_eq!(joint.mass, 2.0);
        // The centre is kept; the tensor is that of a uniform rod along y.
        let inertial = joint.inertial.expect("its centre is known");
        assert_eq!(inertial.centre, [0.0; 3]);
        assert!(
            (inertial.inertia[0] - 2.0 * 0.09 / 12.0).abs() < 1e-3,
            "{inertial:?}"
        );
    }
}

/// Of a light fixed link without a tensor of its own only the tensor is lost: 2 kg with theirs, and a
/// point of 0.1 kg, 0.3 m ahead.
#[test]
fn a_small_doubtful_link_is_a_point_mass() {
    let main = format!("<origin xyz=\"0.02 0 -0.1\"/><mass value=\"2\"/>{INERTIA}");
    for doubtful in ["0", "900", "-1"] {
        let foot = format!(
            "<inertial><mass value=\"0.1\"/><inertia ixx=\"{doubtful}\" iyy=\"{doubtful}\" izz=\"{doubtful}\" \
             ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>"
        );
        let (x, z) = (0.28, 0.1);
        // Two points apart by x ahead and z up, with their reduced mass.
        let reduced = 2.0 * 0.1 / 2.1;
        near(
            spread_of(&rod(&main, &foot)),
            [0.0, (2.0 * 20.0 + 0.1 * 300.0) / 2.1, -2.0 * 100.0 / 2.1],
            [
                0.002 + reduced * (x * x + z * z),
                0.001 + reduced * z * z,
                0.0025 + reduced * x * x,
                -0.0001,
                -0.0003,
                -0.0002 - reduced * x * z,
            ],
        );
    }
}

#[test]
fn the_body_has_what_stays_with_the_base() {
    let text = rod(&format!("<mass value=\"2\"/>{INERTIA}"), "").replace(
        "<link name=\"base\"/>",
        &format!(
            "<link name=\"base\"/><link name=\"body\"><visual><geometry><box size=\"1 1 1\"/></geometry></visual>\
             <inertial><origin xyz=\"0.01 0 0\"/><mass value=\"4\"/>{INERTIA}</inertial></link>\
             <joint name=\"c\" type=\"fixed\"><parent link=\"base\"/><child link=\"body\"/></joint>"
        ),
    );
    let model: Model<1, 1> = imported(&text).1.model().expect("one joint");
    let body = model.body.expect("its body is a box");
    assert_eq!(body.mass, 4.0);
    near(
        body.inertial.expect("it is known"),
        [0.0, 10.0, 0.0],
        [0.002, 0.001, 0.0025, -0.0001, -0.0003, -0.0002],
    );
}
