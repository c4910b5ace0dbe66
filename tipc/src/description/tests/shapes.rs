//! Shapes, turned and mirrored with their legs, and what is wrong with some.

use super::faults::{faults, only, with, with_joint};
use super::{good, one_leg};
use crate::description::{Form, Shape, WithModel};
use tip_runtime::model::{Model, Part};

/// Returns the only shape of the only link, in a leg with these keys.
fn shape(leg: &str, keys: &str) -> Shape {
    let text = one_leg(&format!(
        "{{ axis = \"x\", link = [0, 0, -60], shape = [{{ {keys} }}] }}"
    ));
    let text = text.replace("base", &format!("{leg} base"));
    let shapes = good(&text).shapes();
    assert!(shapes.body.is_empty() && shapes.of(0, 1).is_empty() && shapes.of(1, 0).is_empty());
    assert!(shapes.of(1, 2).is_empty() && shapes.of(2, 1).is_empty());
    match shapes.of(1, 1) {
        [only] => *only,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn near(axes: [[f64; 3]; 3], expected: [[f64; 3]; 3]) {
    let pairs = axes.as_flattened().iter().zip(expected.as_flattened());
    let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-15, "{axes:?} is not {expected:?}");
}

#[test]
fn a_shape_is_one_of_three_forms_at_the_origin_unless_it_says_otherwise() {
    let block = shape("", "block = [10, 20, 30]");
    assert_eq!(block.form, Form::Block([10.0, 20.0, 30.0]));
    assert_eq!(block.at, [0.0; 3]);
    near(
        block.axes,
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    );
    let cylinder = shape("", "cylinder = [5, 60], at = [1, -2, -30]").form;
    let (radius, length) = (5.0, 60.0);
    assert_eq!(cylinder, Form::Cylinder { radius, length });
    let sphere = shape("", "sphere = 0.5, at = [1, -2, -30]");
    assert_eq!(sphere.form, Form::Sphere { radius: 0.5 });
    assert_eq!(sphere.at, [1.0, -2.0, -30.0]);
}

#[test]
fn turns_go_about_fixed_axes_one_after_the_other() {
    let axes = |turned: &str| shape("", &format!("sphere = 1, turned = {turned}")).axes;
    // About x: y comes to lie along z, z along −y.
    let rolled = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]];
    near(axes("[90, 0, 0]"), rolled);
    // About y: x comes to lie along −z, z along x.
    let pitched = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    near(axes("[0, 90, 0]"), pitched);
    // What was rolled is turned about z: x along y, y along −x.
    let both = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    near(axes("[90, 0, 90]"), both);
    // Rolled, then pitched: y lies along z and thence along x, z along −y, which stays.
    let other = [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    near(axes("[90, 90, 0]"), other);
}

#[test]
fn shapes_are_turned_and_mirrored_with_their_link() {
    let keys = "block = [10, 20, 30], at = [4, 5, 6], turned = [0, 0, 30]";
    let (half, most) = (0.5, 0.75_f64.sqrt());
    let plain = shape("", keys);
    near(
        plain.axes,
        [[most, half, 0.0], [-half, most, 0.0], [0.0, 0.0, 1.0]],
    );
    // A quarter turn: 120 deg in all.
    let turned = shape("turn = 90,", keys);
    assert_eq!((turned.form, turned.at), (plain.form, [-5.0, 4.0, 6.0]));
    near(
        turned.axes,
        [[-half, most, 0.0], [-most, -half, 0.0], [0.0, 0.0, 1.0]],
    );
    // Seen in a mirror it is turned by −30 deg, and its axes stay right-handed.
    let mirrored = shape("mirror = \"x\",", keys);
    assert_eq!((mirrored.form, mirrored.at), (plain.form, [-4.0, 5.0, 6.0]));
    near(
        mirrored.axes,
        [[most, -half, 0.0], [half, most, 0.0], [0.0, 0.0, 1.0]],
    );
    // The turn comes first: 120 deg, and −120 deg in the mirror.
    let both = shape("turn = 90, mirror = \"y\",", keys);
    assert_eq!(both.at, [-5.0, -4.0, 6.0]);
    near(
        both.axes,
        [[-half, -most, 0.0], [most, -half, 0.0], [0.0, 0.0, 1.0]],
    );
}

#[test]
fn the_body_and_each_link_have_as_many_shapes_as_they_say() {
    let joints = "{ axis = \"x\", link = [0, 0, 9] }, { axis = \"x\", link = [0, 0, 9], shape = [{ sphere = 1 }, { sphere = 2 }] }";
    let body = "[body]\nx = [-1, 1]\ny = [-1, 1]\nz = [-1, 1]\n[[body.shape]]\nsphere = 3\n";
    let shapes = good(&format!("{}{body}", one_leg(joints))).shapes();
    let radii = |shapes: &[Shape]| -> Vec<Form> { shapes.iter().map(|shape| shape.form).collect() };
    let sphere = |radius| Form::Sphere { radius };
    assert_eq!(radii(&shapes.body), [sphere(3.0)]);
    assert_eq!(radii(shapes.of(1, 1)), []);
    assert_eq!(radii(shapes.of(1, 2)), [sphere(1.0), sphere(2.0)]);
}

#[test]
fn a_model_is_the_same_with_shapes_and_without() {
    let plain = one_leg("{ axis = \"x\", link = [0, 0, 9] }");
    let shaped = plain.replace("9]", "9], shape = [{ sphere = 1 }]");
    let model = |text: &str| good(text).model::<1, 1>();
    assert_eq!(model(&plain), model(&shaped));
}

#[test]
fn a_shape_without_form_or_with_several() {
    let help = "a block has `block = [x, y, z]`, a cylinder `cylinder = [radius, length]`, a sphere `sphere = radius`, in mm";
    let shaped = |keys: &str| with_joint(&format!("shape = [{{ sphere = 1 }}, {{ {keys} }}]"));
    only(
        &shaped("at = [1, 2, 3]"),
        &format!("3:67: a shape needs `block`, `cylinder` or `sphere` ({help})"),
    );
    for several in [
        "block = [1, 1, 1], sphere = 1",
        "cylinder = [1, 1], sphere = 1",
        "block = [1, 1, 1], cylinder = [1, 1]",
        "block = [1, 1, 1], cylinder = [1, 1], sphere = 1",
    ] {
        only(
            &shaped(several),
            &format!("3:67: a shape has only one of `block`, `cylinder` and `sphere` ({help})"),
        );
    }
}

#[test]
fn a_shape_with_keys_or_numbers_that_it_cannot_have() {
    let shaped = |keys: &str| with_joint(&format!("shape = [{{ {keys} }}]"));
    for (keys, fault) in [
        (
            "sphere = 1, turnd = [0, 0, 9]",
            "3:65: [[shape]] has no key `turnd` (did you mean `turned`?)",
        ),
        (
            "sphere = 1, mass = 1",
            "3:65: [[shape]] has no key `mass` (`mass` belongs to [[joint]])",
        ),
        (
            "sphere = 0",
            "3:62: it must be above 0 (`sphere` is a number in mm)",
        ),
        (
            "sphere = [1]",
            "3:62: a list cannot stand here (`sphere` is a number in mm)",
        ),
        (
            "block = [1, 2, -3]",
            "3:68: it must be above 0 (`block` is [x, y, z] in mm)",
        ),
        (
            "cylinder = [1, 0]",
            "3:68: it must be above 0 (`cylinder` is [radius, length] in mm)",
        ),
        (
            "cylinder = [1]",
            "3:64: 2 numbers belong here, and there are 1 (`cylinder` is [radius, length] in mm)",
        ),
        (
            "sphere = 1, at = [1, 2]",
            "3:70: 3 numbers belong here, and there are 2 (`at` is [x, y, z] in mm)",
        ),
        (
            "sphere = 1, turned = 9",
            "3:74: a number cannot stand here (`turned` is [roll, pitch, yaw] in deg)",
        ),
    ] {
        only(&shaped(keys), fault);
    }
    only(
        &with_joint("shape = 9"),
        "3:50: a number cannot stand here (`shape` is a list of [[joint.shape]] tables)",
    );
    let body = "[body]\nx = [-1, 1]\ny = [-1, 1]\nz = [-1, 1]\n";
    only(
        &with(&format!("{body}shape = [{{ sphere = -1 }}]")),
        "8:21: it must be above 0 (`sphere` is a number in mm)",
    );
}

/// Returns the radius of each link of the first leg, and the pairs that may touch.
struct Collisions;

impl WithModel for Collisions {
    type Output = (Vec<Option<f64>>, Vec<[Part; 2]>);

    fn with<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Self::Output {
        let joints = model.legs.first().into_iter().flat_map(|leg| leg.joints);
        let pairs = model.may_touch.iter().flatten().copied();
        (joints.map(|joint| joint.radius).collect(), pairs.collect())
    }
}

#[test]
fn the_radius_of_a_link_is_stated_or_that_of_a_shape_along_it() {
    let radii = |keys: &str| {
        let joint = format!("{{ axis = \"x\", link = [0, 0, -60]{keys} }}");
        good(&one_leg(&joint)).with_model(Collisions).0
    };
    assert_eq!(radii(""), [None]);
    assert_eq!(radii(", radius = 7.5"), [Some(7.5)]);
    let along = ", shape = [{ cylinder = [5, 60], at = [0, 0, -30] }]";
    assert_eq!(radii(along), [Some(5.0)]);
    assert_eq!(radii(&format!("{along}, radius = 7.5")), [Some(7.5)]);
    // Half of the smaller side of a block.
    let block = ", shape = [{ block = [10, 16, 60], at = [0, 0, -30] }]";
    assert_eq!(radii(block), [Some(5.0)]);
    only(
        &with_joint("radius = -1"),
        "3:51: it must be above 0 (`radius` is a number in mm)",
    );
}

#[test]
fn pairs_that_may_touch_are_parts_of_the_robot() {
    let legs = "name = \"two\"\nleg = [{ base = [0, 0, 0] }, { base = [9, 0, 0] }]\njoint = [{ axis = \"x\", link = [0, 0, 9] }]\n";
    let body = "[body]\nx = [-1, 1]\ny = [-1, 1]\nz = [-1, 1]\n";
    let text = |pairs: &str, more: &str| format!("{legs}may_touch = {pairs}\n{more}");
    let pairs = text("[[\"link11\", \"link21\"], [\"body\", \"link21\"]]", body);
    let [one, two] = [Part::Link(1, 1), Part::Link(2, 1)];
    let expected = vec![[one, two], [Part::Body, two]];
    assert_eq!(good(&pairs).with_model(Collisions).1, expected);
    for (pairs, more, expected) in [
        // A part that the robot lacks, and one that only a walking robot has.
        ("[[\"link11\", \"link12\"]]", body, "cannot be this"),
        ("[[\"link11\", \"body\"]]", "", "cannot be this"),
        ("[[\"link11\"]]", body, "two parts belong here"),
        // No part touches itself.
        (
            "[[\"body\", \"link21\"], [\"link11\", \"link11\"]]",
            body,
            "link11 stands here twice: a pair is two different parts",
        ),
        ("[[\"body\", \"body\"]]", body, "body stands here twice"),
        ("[\"link11\"]", body, "cannot stand here"),
        ("[[\"link11\", 2]]", body, "cannot stand here"),
    ] {
        let found = faults(&text(pairs, more));
        let [one] = &found[..] else {
            panic!("{pairs}: {found:?}");
        };
        assert!(one.starts_with("4:") && one.contains(expected), "{one}");
    }
    let many = format!("[{}]", "[\"link11\", \"link21\"], ".repeat(33));
    let found = faults(&text(&many, body));
    let [one] = &found[..] else {
        panic!("{found:?}");
    };
    assert!(one.contains("no robot has more than 32 pairs"), "{one}");
}
