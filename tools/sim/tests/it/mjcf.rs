//! Robots as models of MuJoCo: names, motors, and where everything is. What MuJoCo itself makes of them, `tests/external/urdf/run` asks.

use roxmltree::{Document, Node};
use tip_runtime::model::{Body, Model, Range, hand, titan8};
use tip_runtime::plant::{Block, DynamicPlant, Floor, Object, Scene, Shape};
use tip_sim::{Robot, mjcf, urdf};

const NAMED: [&str; 8] = [
    "titan8",
    "hand",
    "generic",
    "a1",
    "phantomx",
    "solo12",
    "spotmicro",
    "trifinger",
];

fn named(name: &str) -> Robot {
    Robot::named(name).expect("it is known")
}

fn read(text: &str) -> Document<'_> {
    Document::parse(text).expect("it is XML")
}

fn all<'a>(model: &'a Document<'a>, element: &'a str) -> Vec<Node<'a, 'a>> {
    let nodes = model.descendants();
    nodes.filter(|node| node.has_tag_name(element)).collect()
}

fn one<'a>(model: &'a Document<'a>, element: &'a str, name: &str) -> Node<'a, 'a> {
    let found = all(model, element);
    let found = found
        .iter()
        .find(|node| node.attribute("name") == Some(name));
    *found.unwrap_or_else(|| panic!("no {element} {name}"))
}

fn numbers(node: Node<'_, '_>, attribute: &str) -> Vec<f64> {
    let text = node.attribute(attribute).unwrap_or_default();
    let words = text.split_whitespace();
    words.map(|word| word.parse().expect("a number")).collect()
}

fn near(ours: &[f64], expected: &[f64]) {
    assert_eq!(ours.len(), expected.len(), "{ours:?} is not {expected:?}");
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-12;
    assert!(
        ours.iter().zip(expected).all(is_near),
        "{ours:?} is not {expected:?}"
    );
}

#[test]
fn every_joint_has_a_motor_of_its_name_in_the_order_of_the_trace() {
    for name in NAMED {
        let robot = named(name);
        let (text, description) = (mjcf::export(&robot), robot.description());
        let model = read(&text);
        let legs = 1..=description.legs.len();
        let mut expected: Vec<String> = legs
            .clone()
            .flat_map(|leg| (1..=description.joints).map(move |joint| format!("J{leg}{joint}")))
            .collect();
        if name == "hand" {
            expected.push("floor_y".to_owned());
        }
        for element in ["joint", "position"] {
            let found = all(&model, element);
            let found: Vec<&str> = found
                .iter()
                .filter_map(|node| node.attribute("name"))
                .collect();
            assert_eq!(found, expected, "{name}: {element}");
        }
        let controls = numbers(one(&model, "key", "initial"), "ctrl");
        let degrees: Vec<f64> = controls.iter().map(|angle| angle.to_degrees()).collect();
        let postures = description.legs.iter().flat_map(|leg| leg.initial.clone());
        near(
            &degrees[..description.legs.len() * description.joints],
            &postures.collect::<Vec<_>>(),
        );
        for leg in legs {
            one(&model, "site", &format!("F{leg}"));
            one(&model, "touch", &format!("F{leg}"));
        }
    }
}

#[test]
fn a_walking_robot_begins_where_the_plant_with_mass_has_it() {
    let text = mjcf::export(&named("titan8"));
    let model = read(&text);
    assert_eq!(all(&model, "freejoint").len(), 1);
    let [x, y, z] = DynamicPlant::new(&titan8::MODEL).body().position;
    // Feet have a skin of 1 mm.
    let at = [x / 1000.0, y / 1000.0, z / 1000.0 + 0.001];
    near(&numbers(one(&model, "body", "base_link"), "pos"), &at);
    let places = numbers(one(&model, "key", "initial"), "qpos");
    assert_eq!(places.len(), 7 + 12);
    near(&places[..7], &[at[0], at[1], at[2], 1.0, 0.0, 0.0, 0.0]);
    // F2's hip is 101 mm to the right and 201 mm ahead; its shank ends 200 mm further to the right.
    near(
        &numbers(one(&model, "body", "link21"), "pos"),
        &[0.101, 0.201, 0.0],
    );
    near(&numbers(one(&model, "site", "F2"), "pos"), &[0.2, 0.0, 0.0]);
}

#[test]
fn a_motor_is_that_of_the_plant() {
    let text = mjcf::export(&named("titan8"));
    let model = read(&text);
    let motor = one(&model, "position", "J11");
    let joint = one(&model, "joint", "J11");
    // A motor of 40 N·m: 200, 3, 7.5e-4 and 2.5e-3 for each N·m.
    near(&numbers(motor, "kp"), &[8000.0]);
    near(&numbers(motor, "kv"), &[120.0]);
    near(&numbers(motor, "forcerange"), &[-40.0, 40.0]);
    near(&numbers(joint, "armature"), &[0.03]);
    near(&numbers(joint, "damping"), &[0.1]);
    let outer = titan8::MODEL.legs[0].joints[0].outer;
    let range = [outer.min.to_radians(), outer.max.to_radians()];
    near(&numbers(joint, "range"), &range);
    near(&numbers(motor, "ctrlrange"), &range);
}

#[test]
fn floor_and_blocks_are_those_of_the_scene() {
    let scene = Scene {
        floor: Floor {
            height: 10.0,
            slope: [0.0, -0.1],
        },
        friction: 0.9,
        ..Scene::EMPTY
    };
    let block = Block {
        x: [-100.0, 300.0],
        y: [500.0, 1500.0],
        height: 40.0,
    };
    let scene = scene.with_block(block).expect("there is room");
    let robot = named("titan8")
        .with_scene(&scene)
        .expect("it has no objects");
    let text = mjcf::export(&robot);
    let model = read(&text);
    let floor = one(&model, "geom", "floor");
    near(&numbers(floor, "pos"), &[0.0, 0.0, 0.01]);
    near(&numbers(floor, "zaxis"), &[0.0, 0.1, 1.0]);
    near(&numbers(floor, "friction"), &[0.9, 0.0, 0.0]);
    // Down to 100 mm below the floor, which is at 10 − 150 mm under the far side.
    let block = one(&model, "geom", "block1");
    near(&numbers(block, "size"), &[0.2, 0.5, 0.14]);
    near(&numbers(block, "pos"), &[0.1, 1.0, -0.1]);
    // It leans forward with the floor: about x, by −atan 0.1.
    let half = -(0.1_f64).atan() / 2.0;
    let attitude = numbers(one(&model, "body", "base_link"), "quat");
    near(&attitude, &[half.cos(), half.sin(), 0.0, 0.0]);
}

#[test]
fn objects_are_where_the_hand_has_them_and_the_smaller_friction_counts() {
    let disc = Object {
        shape: Shape::Disc { radius: 20.0 },
        mass: 0.2,
        friction: 0.3,
        x: 50.0,
        y: Some(-60.0),
        angle: 30.0,
    };
    let scene = Scene::CYLINDER.with_object(disc).expect("there is room");
    let robot = named("hand").with_scene(&scene).expect("it grasps");
    let text = mjcf::export(&robot);
    let model = read(&text);
    assert!(all(&model, "freejoint").is_empty(), "it is bolted down");
    // The cylinder, 60 mm high, stands on the slider's floor.
    let below = hand::MODEL.slider.expect("it has one").initial[1];
    let y = (below + 30.0) / 1000.0;
    near(&numbers(one(&model, "joint", "O1_y"), "ref"), &[y]);
    near(
        &numbers(one(&model, "geom", "O1"), "size")[..2],
        &[0.1, 0.03],
    );
    // The axes of a turned object are still those of the hand.
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    near(
        &numbers(one(&model, "joint", "O2_x"), "axis"),
        &[cos, -sin, 0.0],
    );
    let places = numbers(one(&model, "key", "initial"), "qpos");
    let turn = 30_f64.to_radians();
    near(&places[10..], &[0.0, y, 0.0, 0.05, -0.06, turn]);
    let frictions: Vec<(&str, &str, f64)> = all(&model, "pair")
        .into_iter()
        .filter_map(|pair| {
            let friction = *numbers(pair, "friction").first()?;
            Some((pair.attribute("geom1")?, pair.attribute("geom2")?, friction))
        })
        .collect();
    let expected = [
        ("floor", "O1", 0.5),
        ("palm", "O1", 0.5),
        ("floor", "O2", 0.3),
        ("palm", "O2", 0.3),
        ("O1", "O2", 0.3),
    ];
    assert_eq!(frictions, expected);
}

#[test]
fn a_robot_that_is_bolted_down_has_no_floor() {
    let text = mjcf::export(&named("trifinger"));
    let model = read(&text);
    assert!(all(&model, "freejoint").is_empty());
    assert!(!text.contains("name=\"floor\""), "{text}");
}

#[test]
fn a_link_that_weighs_nothing_leaves_its_inertia_to_the_bounds() {
    let arm = |mass: &str| {
        let text = format!(
            "name = \"arm\"\n[[leg]]\nbase = [0, 0, 0]\njoint = [{{ axis = \"z\", link = [100, 0, 0], mass = {mass} }}]\n"
        );
        mjcf::export(&Robot::from_description(&text).expect("a robot"))
    };
    let (light, heavy) = (arm("0"), arm("0.5"));
    let inertial = |text: &str, attribute: &str| {
        let model = read(text);
        let node = all(&model, "inertial")[0];
        node.attribute(attribute).map(str::to_owned)
    };
    assert_eq!(inertial(&light, "diaginertia").as_deref(), Some("0 0 0"));
    assert_eq!(inertial(&light, "fullinertia"), None);
    assert_eq!(inertial(&heavy, "diaginertia"), None);
    assert!(inertial(&heavy, "fullinertia").is_some());
}

/// Readers refuse sizes of nothing.
#[test]
fn no_size_is_nothing() {
    let flat = Body {
        x: Range::new(7.0, 7.0),
        z: Range::new(0.0, 0.0),
        ..titan8::MODEL.body.expect("it walks")
    };
    let model: &Model<4, 3> = Box::leak(Box::new(Model {
        body: Some(flat),
        ..titan8::MODEL
    }));
    // Links that are nearly nothing, of which no rod is made.
    let short = "name = \"short\"\nleg = [{ base = [0, 0, 0] }]\njoint = [
        { axis = \"x\", link = [0, 0, 1e-9] }, { axis = \"y\", link = [0, 1e-4, 0] }, { axis = \"x\", link = [0, 0, -50] }]";
    let short = Robot::from_description(short).expect("a description");
    for robot in [Robot::of(model), short] {
        let [mjcf, urdf] = [mjcf::export(&robot), urdf::export(&robot)];
        for text in [&mjcf, &urdf] {
            let model = read(text);
            let geometries = model
                .descendants()
                .filter(|node| node.attribute("type") != Some("plane"));
            for node in geometries {
                for attribute in ["size", "radius", "length"] {
                    // In m, of which MuJoCo takes 1e-15 for nothing.
                    let sizes = numbers(node, attribute);
                    assert!(sizes.iter().all(|size| *size >= 1e-10), "{node:?}");
                }
                if let [x, y, z, to @ ..] = &*numbers(node, "fromto") {
                    // MuJoCo takes 1e-6 m for nothing here.
                    let apart = to
                        .iter()
                        .zip([x, y, z])
                        .any(|(to, from)| (to - from).abs() > 1e-6);
                    assert!(apart, "{node:?}");
                }
            }
        }
    }
}

/// MuJoCo refuses a principal moment below 1e-14 kg·m², one above the sum of the other two, and a mass below 1e-15 kg. All tensors
/// here lie along the axes.
#[test]
fn every_inertia_is_that_of_a_body_with_some_thickness() {
    let arm = |joint: &str, body: &str| {
        let text = format!(
            "name = \"arm\"\nleg = [{{ base = [0, 0, 0] }}]\njoint = [{{ axis = \"x\", link = [0, 0, -50], {joint} }}]\n{body}"
        );
        Robot::from_description(&text).expect("a description")
    };
    let plain = "[body]\nx = [-50, 50]\ny = [-50, 50]\nz = [-10, 10]\n";
    let dust = "[body]\nx = [0, 0.000001]\ny = [0, 0.000001]\nz = [0, 0.000001]\n";
    let sheet = "[body]\nx = [0, 0.000001]\ny = [-50, 51]\nz = [-33, 50]\nmass = 0.7\n";
    for (joint, body) in [
        ("mass = 0.5, inertia = [0, 0, 0, 0, 0, 0]", plain),
        ("mass = 0.5, inertia = [0.01, 0.01, 0, 0, 0, 0]", plain),
        ("mass = 0.5, inertia = [0.1, 0.3, 0.2, 0, 0, 0]", plain),
        ("mass = 1e-20", plain),
        ("mass = 1", dust),
        ("mass = 1", sheet),
    ] {
        let robot = arm(joint, body);
        let [mjcf, urdf] = [mjcf::export(&robot), urdf::export(&robot)];
        let [mjcf, urdf] = [read(&mjcf), read(&urdf)];
        let of_mjcf = all(&mjcf, "inertial").into_iter().map(|node| {
            let tensor = [numbers(node, "diaginertia"), numbers(node, "fullinertia")].concat();
            (tensor, true)
        });
        let of_urdf = all(&urdf, "inertia").into_iter().map(|node| {
            let tensor = ["ixx", "iyy", "izz"].map(|name| numbers(node, name)[0]);
            (tensor.to_vec(), false)
        });
        for (tensor, is_mjcf) in of_mjcf.chain(of_urdf) {
            let [x, y, z] = tensor[..3] else {
                panic!("{tensor:?}")
            };
            let half = (x + y + z) / 2.0;
            for moment in [x, y, z] {
                // Both are far above rounding.
                assert!(moment >= 1e-13, "{tensor:?} of {joint}, {body}, {is_mjcf}");
                assert!(half - moment >= 1e-13, "{tensor:?} of {joint}, {body}");
                assert!(half - moment >= 1e-13 * half, "{tensor:?} of {joint}");
            }
        }
        for mass in all(&urdf, "mass") {
            assert!(numbers(mass, "value")[0] >= 1e-12, "{joint}");
        }
    }
    // What has a thickness is exported as it is described.
    let arm = arm("mass = 0.5, inertia = [0.01, 0.02, 0.015, 0, 0, 0]", plain);
    let (text, link) = (mjcf::export(&arm), [0.01, 0.02, 0.015, 0.0, 0.0, 0.0]);
    let model = read(&text);
    let inertia = one(&model, "body", "link11").first_element_child();
    let inertia = inertia.and_then(|hinge| hinge.next_sibling_element());
    assert_eq!(numbers(inertia.expect("it weighs"), "fullinertia"), link);
}

/// Capsules push legs apart as in the plant with mass: 5 % of links of 50, 240 and 200 mm, and no pairs of one leg or of two hips.
#[test]
fn links_of_two_legs_push_each_other_as_in_the_plant() {
    let text = mjcf::export(&named("titan8"));
    let model = read(&text);
    for (joint, radius) in [(1, 0.0025), (2, 0.012), (3, 0.01)] {
        for leg in 1..=4 {
            let capsule = one(&model, "geom", &format!("link{leg}{joint}_capsule"));
            near(&numbers(capsule, "size"), &[radius]);
            assert_eq!(capsule.attribute("contype"), None, "its class has it");
        }
    }
    let excluded: Vec<(&str, &str)> = all(&model, "exclude")
        .into_iter()
        .filter_map(|pair| Some((pair.attribute("body1")?, pair.attribute("body2")?)))
        .collect();
    let links = |leg: u8| (1..=3).map(move |joint| format!("link{leg}{joint}"));
    for one in (1..=4).flat_map(links) {
        for other in (1..=4).flat_map(links).take_while(|other| *other != one) {
            let same_leg = one.as_bytes()[4] == other.as_bytes()[4];
            let hips = one.ends_with('1') && other.ends_with('1');
            let is_excluded = excluded.contains(&(&other, &one));
            assert_eq!(is_excluded, same_leg || hips, "{other} {one}");
        }
    }
    // 4 legs of 3 pairs, and 6 pairs of hips.
    assert_eq!(excluded.len(), 18);
    // A robot that is bolted down touches nothing.
    let text = mjcf::export(&named("trifinger"));
    let model = read(&text);
    let capsule = one(&model, "geom", "link12_capsule");
    let bits = ["contype", "conaffinity"].map(|bits| capsule.attribute(bits));
    assert_eq!((bits, all(&model, "exclude").len()), ([Some("0"); 2], 0));
}
