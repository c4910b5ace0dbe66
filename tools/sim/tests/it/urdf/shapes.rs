//! Collision shapes, worked out by hand.

use crate::urdf::{imported, reported};
use tip_sim::urdf::export;
use tip_sim::{Robot, mjcf};
use tipc::description::{Form, Shape, Shapes};

const PLAIN: &str = "0 0 0";
/// A quarter turn: rad.
const QUARTER: &str = "1.5707963267948966";

/// A collision element.
fn collision(xyz: &str, rpy: &str, form: &str) -> String {
    format!(
        "<collision><origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><geometry><{form}/></geometry></collision>"
    )
}

/// A robot of three legs `a`, `b`, `c`, each with a link `aLink` on a joint 0.1 m ahead of the base, turned by `rpy`, and a link
/// `aFoot` 0.3 m farther on along the link's x. The links of `a` and the base hold these elements.
fn robot(rpy: &str, base: &str, link: &str, foot: &str) -> String {
    let mut text = format!("<robot name=\"shaped\"><link name=\"base\">{base}</link>");
    for leg in ["a", "b", "c"] {
        let [link, foot] = [link, foot].map(|inside| if leg == "a" { inside } else { "" });
        text += &format!(
            r#"<link name="{leg}Link">{link}</link><link name="{leg}Foot">{foot}</link>
<joint name="{leg}" type="revolute"><parent link="base"/><child link="{leg}Link"/><origin xyz="0.1 0 0" rpy="{rpy}"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="{leg}End" type="fixed"><parent link="{leg}Link"/><child link="{leg}Foot"/><origin xyz="0.3 0 0" rpy="0 0 {QUARTER}"/></joint>"#
        );
    }
    text + "</robot>"
}

fn shapes(text: &str) -> Shapes {
    imported(text).1.shapes()
}

#[track_caller]
fn same(ours: &[Shape], expected: &[Shape]) {
    let numbers = |shape: &Shape| -> Vec<f64> {
        let sizes = match shape.form {
            Form::Block(sides) => vec![3.0, sides[0], sides[1], sides[2]],
            Form::Cylinder { radius, length } => vec![2.0, radius, length],
            Form::Sphere { radius } => vec![1.0, radius],
        };
        [&sizes, &shape.at[..], shape.axes.as_flattened()].concat()
    };
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-8;
    let is_same = |(ours, expected): (&Shape, &Shape)| {
        let (ours, expected) = (numbers(ours), numbers(expected));
        ours.len() == expected.len() && ours.iter().zip(&expected).all(is_near)
    };
    assert!(
        ours.len() == expected.len() && ours.iter().zip(expected).all(is_same),
        "{ours:?} is not {expected:?}"
    );
}

const UPRIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn shape(form: Form, at: [f64; 3], axes: [[f64; 3]; 3]) -> Shape {
    Shape { form, at, axes }
}

#[test]
fn shapes_are_seen_from_their_joint_in_the_robot_frame() {
    // Ahead is y, left is −x: 40 mm ahead is 40 mm along y.
    let link = collision("0.02 0.05 -0.1", PLAIN, "box size=\"0.04 0.06 0.08\"")
        + &collision(PLAIN, PLAIN, "cylinder radius=\"0.01\" length=\"0.2\"")
        + &collision("0 -0.03 0", PLAIN, "sphere radius=\"0.015\"");
    let found = shapes(&robot(PLAIN, "", &link, ""));
    let cylinder = Form::Cylinder {
        radius: 10.0,
        length: 200.0,
    };
    same(
        found.of(1, 1),
        &[
            shape(
                Form::Block([60.0, 40.0, 80.0]),
                [-50.0, 20.0, -100.0],
                UPRIGHT,
            ),
            shape(cylinder, [0.0; 3], UPRIGHT),
            shape(Form::Sphere { radius: 15.0 }, [30.0, 0.0, 0.0], UPRIGHT),
        ],
    );
    assert!(found.of(2, 1).is_empty() && found.body.is_empty());
}

#[test]
fn frames_that_are_turned_turn_their_shapes() {
    // The frame of the joint is turned to the left: its x is left, which is −x, its y is back, which is −y.
    let turned = format!("0 0 {QUARTER}");
    // A cylinder that is pitched lies along that x.
    let pitched = format!("0 {QUARTER} 0");
    let rod = |xyz: &str| collision(xyz, &pitched, "cylinder radius=\"0.01\" length=\"0.2\"");
    let found = shapes(&robot(&turned, "", &rod("0.1 0.02 0.03"), ""));
    let [only] = found.of(1, 1) else {
        panic!("{found:?}");
    };
    let expected = shape(only.form, [-100.0, -20.0, 30.0], only.axes);
    same(&[*only], &[expected]);
    // Which axes a cylinder has across is nothing that one can see.
    let [x, y, z] = only.axes[2];
    assert!(
        (x.abs() - 1.0).abs() < 1e-9 && y.abs() < 1e-9 && z.abs() < 1e-9,
        "{only:?}"
    );
    // A block on the foot, which is turned once more: its x is back, its y is right. The foot is 300 mm to the left.
    let block = collision("0.01 0.02 0", PLAIN, "box size=\"0.04 0.06 0.08\"");
    let found = shapes(&robot(&turned, "", "", &block));
    let half_a_turn = [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
    let sides = Form::Block([60.0, 40.0, 80.0]);
    same(
        found.of(1, 1),
        &[shape(sides, [-280.0, -10.0, 0.0], half_a_turn)],
    );
}

#[test]
fn a_capsule_is_a_cylinder_between_two_spheres() {
    let capsule = collision("0 0 0.5", PLAIN, "capsule radius=\"0.02\" length=\"0.1\"");
    let cylinder = Form::Cylinder {
        radius: 20.0,
        length: 100.0,
    };
    let sphere = Form::Sphere { radius: 20.0 };
    let expected = [
        shape(cylinder, [0.0, 0.0, 500.0], UPRIGHT),
        shape(sphere, [0.0, 0.0, 550.0], UPRIGHT),
        shape(sphere, [0.0, 0.0, 450.0], UPRIGHT),
    ];
    same(shapes(&robot(PLAIN, "", &capsule, "")).of(1, 1), &expected);
}

#[test]
fn what_no_description_can_hold_is_dropped_and_told() {
    let sphere = collision(PLAIN, PLAIN, "sphere radius=\"0.01\"");
    let mesh = collision(PLAIN, PLAIN, "mesh filename=\"a.stl\"");
    let mixed = format!("{mesh}{sphere}{mesh}");
    let (import, robot_of) = imported(&robot(PLAIN, &mesh, &mixed, &sphere));
    assert_eq!(robot_of.shapes().of(1, 1).len(), 2);
    let said = reported(&import);
    let line = "dropped: collision shapes that are meshes: base, aLink";
    assert!(said.lines().any(|it| it == line), "{said}");
    for nothing in [
        "sphere radius=\"0\"",
        "box size=\"1 1 -1\"",
        "cylinder radius=\"nan\" length=\"1\"",
        "capsule radius=\"1\" length=\"1001\"",
    ] {
        let nothing = collision(PLAIN, PLAIN, nothing);
        let (import, _) = imported(&robot(PLAIN, "", &format!("{sphere}{nothing}"), ""));
        let said = reported(&import);
        let line = "dropped: collision shapes that have a size of 0 or less, or are farther away than 1 km: aLink";
        assert!(said.lines().any(|it| it == line), "{said}");
        assert!(!said.contains("meshes"), "{said}");
    }
    let sound = reported(&imported(&robot(PLAIN, "", &sphere, "")).0);
    assert!(!sound.contains("collision"), "{sound}");
}

#[test]
fn a_body_is_the_box_around_the_shapes_of_its_base() {
    let block = collision("0.1 0 0.2", PLAIN, "box size=\"0.4 0.2 0.1\"");
    // It lies across: from 100 to the left to 100 to the right.
    let across = format!("{QUARTER} 0 0");
    let rod = collision(
        "-0.2 0 0",
        &across,
        "cylinder radius=\"0.05\" length=\"0.2\"",
    );
    let ball = collision("0 0 0.25", PLAIN, "sphere radius=\"0.03\"");
    let (import, description) = imported(&robot(PLAIN, &format!("{block}{rod}{ball}"), "", ""));
    let body = description.model::<3, 1>().and_then(|model| model.body);
    let body = body.expect("it walks");
    let ends = [body.x, body.y, body.z].map(|range| [range.min, range.max]);
    // Ahead: the block from −100 to 300 mm, the rod from −250 on. Up: the rod from −50, the ball to 280.
    let expected = [[-100.0, 100.0], [-250.0, 300.0], [-50.0, 280.0]];
    for (ours, expected) in ends.as_flattened().iter().zip(expected.as_flattened()) {
        assert!((ours - expected).abs() < 1e-6, "{body:?}");
    }
    assert_eq!(description.shapes().body.len(), 3);
    let said = reported(&import);
    assert!(
        said.contains("the box around the collision shapes of its base"),
        "{said}"
    );
    // Spheres and cylinders are wheels and sensors.
    let said = reported(&imported(&robot(PLAIN, &format!("{rod}{ball}"), "", "")).0);
    assert!(said.contains("a box around the first joints"), "{said}");
    // A box that is called body says more.
    let named = robot(PLAIN, &block, "", "").replacen(
        "<link name=\"aLink\">",
        "<link name=\"body\"><visual><geometry><box size=\"1 1 1\"/></geometry></visual></link>\
             <joint name=\"d\" type=\"fixed\"><parent link=\"base\"/><child link=\"body\"/></joint><link name=\"aLink\">",
        1,
    );
    let said = reported(&imported(&named).0);
    assert!(said.contains("its body is the box of link body"), "{said}");
}

#[test]
fn a_robot_that_is_bolted_down_has_no_shapes_of_its_base() {
    let block = collision(PLAIN, PLAIN, "box size=\"0.4 0.2 0.1\"");
    let mesh = collision(PLAIN, PLAIN, "mesh filename=\"a.stl\"");
    let world = "<robot name=\"shaped\"><link name=\"world\"/>\
        <joint name=\"w\" type=\"fixed\"><parent link=\"world\"/><child link=\"base\"/></joint>";
    let bolted = |base: &str| {
        let text = robot(PLAIN, base, "", "");
        reported(&imported(&text.replace("<robot name=\"shaped\">", world)).0)
    };
    let line = "dropped: the collision shapes of the base, which is bolted down";
    let said = bolted(&format!("{block}{mesh}"));
    assert!(said.lines().any(|it| it == line), "{said}");
    assert!(!said.contains("meshes"), "{said}");
    assert!(!bolted("").contains("collision"));
}

#[test]
fn a_base_that_floats_in_the_world_is_free() {
    let text = robot(
        PLAIN,
        &collision(PLAIN, PLAIN, "box size=\"0.4 0.2 0.1\""),
        "",
        "",
    );
    let world = "<robot name=\"shaped\"><link name=\"world\"/>\
        <joint name=\"w\" type=\"floating\"><parent link=\"world\"/><child link=\"base\"/></joint>";
    let floating = imported(&text.replace("<robot name=\"shaped\">", world));
    let free = imported(&text);
    assert_eq!(floating.0.toml, free.0.toml);
}

/// Two legs drawn once, one of them turned and mirrored, and a body: each kind of shape turned in some way.
const DESCRIBED: &str = r#"name = "shaped"
joint = [
    { axis = "z", link = [50, 0, 0], shape = [{ block = [50, 20, 10], at = [25, 1, 2], turned = [10, 20, 30] }] },
    { axis = "y", link = [0, 0, -90], shape = [{ cylinder = [8, 90], at = [0, 3, -45], turned = [0, 90, 45] }, { sphere = 12, at = [0, 0, -90] }] },
]
leg = [
    { base = [80, 0, 0] },
    { base = [-80, 30, 0], turn = 25, mirror = "x" },
    { base = [0, -60, 5], turn = -90, mirror = "yz" },
]
[body]
x = [-90, 90]
y = [-60, 60]
z = [-20, 30]
shape = [{ block = [100, 80, 40], turned = [0, 0, 45] }, { cylinder = [20, 60], at = [0, 70, 0], turned = [90, 0, 0] }]
"#;

#[test]
fn described_shapes_return_and_the_body_keeps_its_extents() {
    let robot = Robot::from_description(DESCRIBED).expect("it is a robot");
    let (import, description) = imported(&export(&robot));
    let (ours, theirs) = (robot.shapes(), description.shapes());
    same(&theirs.body, &ours.body);
    for (leg, joint) in [(1, 1), (1, 2), (2, 1), (2, 2), (3, 1), (3, 2)] {
        assert!(!ours.of(leg, joint).is_empty());
        same(theirs.of(leg, joint), ours.of(leg, joint));
    }
    let body = Robot::described(&description).description().body;
    assert_eq!(
        body.map(|body| [body.x, body.y, body.z]),
        robot
            .description()
            .body
            .map(|body| [body.x, body.y, body.z])
    );
    // And once more, to the letter.
    let again = imported(&export(&Robot::described(&description))).0;
    assert_eq!(again.toml, import.toml);
}

#[test]
fn links_with_shapes_are_drawn_by_nothing_else() {
    let robot = Robot::from_description(DESCRIBED).expect("it is a robot");
    let text = export(&robot);
    let link = text.split("<link name=\"link12\">").nth(1);
    let link = link.and_then(|rest| rest.split("</link>").next());
    let link = link.expect("the second link of F1");
    assert_eq!(link.matches("<visual>").count(), 2, "{link}");
    assert_eq!(link.matches("<collision>").count(), 2, "{link}");
    assert!(link.contains("<sphere radius=\"0.012\"/>"), "{link}");
    let body = text.split("<link name=\"body\">").nth(1);
    let body = body.and_then(|rest| rest.split("</link>").next());
    let body = body.expect("the body");
    // Its box to look at, and its shapes to collide with.
    assert!(
        body.contains("<box size=\"0.12 0.18 0.05\"/></geometry><material"),
        "{body}"
    );
    assert_eq!(body.matches("<collision>").count(), 2, "{body}");
}

#[test]
fn in_mujoco_shapes_are_drawn_and_feet_touch_as_before() {
    let shaped = mjcf::export(&Robot::from_description(DESCRIBED).expect("it is a robot"));
    // Without its shapes.
    let plain: Vec<&str> = DESCRIBED
        .lines()
        .filter(|line| !line.starts_with("shape"))
        .collect();
    let plain = plain.join("\n");
    let plain = plain
        .split(", shape = ")
        .map(|part| part.split_once("}] ").map_or(part, |(_, rest)| rest));
    let plain = plain.collect::<String>();
    let plain = mjcf::export(&Robot::from_description(&plain).expect("it is a robot"));
    let others = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| {
            !["drawn", "tip_shape"]
                .iter()
                .any(|class| line.contains(&format!("class=\"{class}\"")))
        });
        lines.map(|line| line.replace(" group=\"3\"", "")).collect()
    };
    assert_eq!(others(&shaped), others(&plain));
    let drawn: Vec<&str> = shaped
        .lines()
        .filter(|line| line.contains("class=\"tip_shape\""))
        .collect();
    assert_eq!(
        drawn.len(),
        3 * 3 + 2 + 1,
        "with the line of the class itself"
    );
    // Half of its sides, in m; along its x and y.
    let sphere = "<geom class=\"tip_shape\" type=\"sphere\" size=\"0.012\" pos=\"0 0 -0.09\" xyaxes=\"1 0 0 0 1 0\"/>";
    assert!(drawn.iter().any(|line| line.trim() == sphere), "{drawn:?}");
    assert!(
        drawn.iter().any(|line| line.contains(
            "type=\"cylinder\" size=\"0.02 0.03\" pos=\"0 0.07 0\" xyaxes=\"1 0 0 0 0 1\""
        )),
        "{drawn:?}"
    );
    assert!(
        drawn
            .iter()
            .any(|line| line.contains("type=\"box\" size=\"0.05 0.04 0.02\"")),
        "{drawn:?}"
    );
}
