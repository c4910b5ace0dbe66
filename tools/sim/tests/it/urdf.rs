//! Robots from URDF files. Forward kinematics of the results are compared with the URDF's own frames, put together
//! here from the numbers in the file, one homogeneous transform after the other.

mod broken;
mod encodings;
mod export;
mod frames;
mod options;
mod placeholders;
mod refusals;
mod robots;
mod shapes;
mod stand;
mod weights;
mod xacro;

use frames::place;
use robots::{ARM, Joint, PLAIN, TIP, fixed, quadruped, revolute, urdf};
use tip_runtime::kinematics::Chain;
use tip_runtime::model::{Leg, Model};
use tip_sim::import::{Import, import};
use tipc::description::{Description, parse};

/// The report, a line each.
fn reported(import: &Import) -> String {
    let lines: Vec<String> = import.report.iter().map(ToString::to_string).collect();
    lines.join("\n")
}

fn imported(text: &str) -> (Import, Description) {
    let import = import("test.urdf", text).unwrap_or_else(|error| panic!("{error}"));
    let description = parse("test.toml", import.toml.as_bytes());
    let description = description.unwrap_or_else(|loaded| panic!("{:#?}", loaded.diagnostics));
    (import, description)
}

/// Holds foot and joints of a leg against the URDF at some angles (deg).
fn agree<const J: usize>(
    leg: &Leg<J>,
    joints: &[Joint],
    names: [&str; J],
    links: [&str; J],
    end: &str,
    angles: [f64; J],
) {
    let turned: Vec<(&str, f64)> = names.into_iter().zip(angles.map(f64::to_radians)).collect();
    let chain = Chain::new(leg, &angles);
    let places = links.map(|link| place(joints, link, &turned));
    let ours: Vec<[f64; 3]> = chain.joints().collect();
    for (ours, theirs) in ours
        .iter()
        .zip(places)
        .chain([(&chain.foot(), place(joints, end, &turned))])
    {
        let apart = (0..3)
            .map(|i| (ours[i] - theirs[i]).abs())
            .fold(0.0, f64::max);
        assert!(apart < 1e-4, "{angles:?}: {ours:?} is not {theirs:?}");
    }
}

#[test]
fn an_arm_of_turned_frames_moves_as_its_urdf_does() {
    let (import, description) = imported(&urdf(ARM));
    let model: Model<1, 3> = description.model().expect("one leg of three joints");
    let names = ["shoulder", "elbow", "wrist"];
    for angles in [
        [0.0, 0.0, 0.0],
        [30.0, 0.0, 0.0],
        [0.0, -40.0, 0.0],
        [0.0, 0.0, 70.0],
        [-85.0, 114.0, -33.0],
        [12.5, 61.0, -84.0],
    ] {
        agree(
            &model.legs[0],
            ARM,
            names,
            ["upper", "lower", "hand"],
            "tool",
            angles,
        );
    }
    let [shoulder, elbow, wrist] = model.legs[0].joints;
    // The upper arm took in its flange, the hand its tool; the mount belongs to the base.
    assert_eq!(
        [shoulder.mass, elbow.mass, wrist.mass],
        [2.0 + 3.0, 4.0, 5.0 + 6.0]
    );
    assert!((shoulder.limits.min - -1.5_f64.to_degrees()).abs() < 1e-6);
    assert!((shoulder.limits.max - 2.0_f64.to_degrees()).abs() < 1e-6);
    assert_eq!((shoulder.torque, model.body), (7.0, None));
    assert!((model.standards.omega_max - 3.0_f64.to_degrees()).abs() < 1e-6);
    let said = reported(&import);
    assert!(said.contains("F1: joint shoulder to link tool"), "{said}");
    assert!(
        said.contains("link upper took in the links fixed to it: flange"),
        "{said}"
    );
    assert!(said.contains("bolted down"), "{said}");
}

#[test]
fn a_quadruped_stands_on_four_legs() {
    let joints = quadruped();
    let (import, description) = imported(&urdf(&joints));
    let model: Model<4, 3> = description.model().expect("four legs of three joints");
    // Front left is forward and to the left: y is forward, x to the right.
    assert_eq!(
        model.legs.map(|leg| leg.base),
        [
            [-100.0, 200.0, 0.0],
            [100.0, 200.0, 0.0],
            [-100.0, -200.0, 0.0],
            [100.0, -200.0, 0.0]
        ]
    );
    let body = model.body.expect("it walks");
    assert_eq!(
        (body.x.min, body.x.max, body.y.max, body.z.max),
        (-100.0, 100.0, 200.0, 50.0)
    );
    for (number, leg) in (1..).zip(&model.legs) {
        let name = |letter: &str| format!("{letter}{number}");
        let (h, t, k, c, f, s, e) = (
            name("h"),
            name("t"),
            name("k"),
            name("c"),
            name("f"),
            name("s"),
            name("e"),
        );
        for angles in [[0.0; 3], [20.0, -30.0, 60.0]] {
            agree(leg, &joints, [&h, &t, &k], [&c, &f, &s], &e, angles);
        }
    }
    let said = reported(&import);
    assert!(said.contains("F4: joint h4 to link e4"), "{said}");
    assert!(
        said.contains("body is a box around the first joints"),
        "{said}"
    );
}

#[test]
fn what_urdf_does_not_say_is_assumed_and_told() {
    let text = urdf(&[
        revolute("a", "base", "one", PLAIN),
        fixed("one", "foot", TIP),
    ])
    .replace("type=\"revolute\"", "type=\"continuous\"")
    .replace("effort=\"7\" velocity=\"3\"", "effort=\"0\" velocity=\"0\"")
    .replace("test arm", "a/b: \"generic\"");
    let text = text.replace("\"generic\"\"", "&quot;generic&quot;\"");
    let (import, description) = imported(&text);
    assert_eq!(description.name(), "a b   generic");
    let model: Model<1, 1> = description.model().expect("one joint");
    assert_eq!(
        (
            model.legs[0].joints[0].limits.max,
            model.legs[0].joints[0].torque
        ),
        (180.0, 10.0)
    );
    let said = reported(&import);
    for line in [
        "dropped: what continuous joints say of `lower` and `upper`, since they turn without end; their limits are -180 and 180 deg: a",
        "assumed: motors of 10 N·m, since the file gives no effort above 0 and up to 100000 N·m: a",
    ] {
        assert!(said.lines().any(|it| it == line), "{said}");
    }
}
