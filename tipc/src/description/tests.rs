//! Descriptions, good and bad. Expected values are worked out by hand.

mod faults;
mod shapes;

use super::{Description, WithModel, parse};
use crate::robot::Robot;
use tip_runtime::model::{InertialProperties, Inverse, Model, Range, TorqueUnit, generic, titan8};

/// TITAN VIII's joints as a description draws them: a leg on the right.
const TITAN_JOINTS: &str = r#"
joint = [
    { axis = "z", link = [50, 0, 0], limits = [-60, 60], mass = 0.8, torque = 40 },
    { axis = "-y", link = [240, 0, 0], limits = [-60, 75], mass = 0.8, torque = 40 },
    { axis = "y", link = [200, 0, 0], limits = [5, 150], outer = [0, 155], mass = 0.4, torque = 40 },
]
"#;

/// Returns a robot with one leg at the origin.
fn one_leg(joints: &str) -> String {
    format!("name = \"test\"\nleg = [{{ base = [0, 0, 0] }}]\njoint = [{joints}]\n")
}

fn good(text: &str) -> Description {
    parse("robot.toml", text.as_bytes())
        .unwrap_or_else(|loaded| panic!("{:#?}", loaded.diagnostics))
}

#[test]
fn titan_is_described_by_one_leg_and_four_places() {
    let legs = "initial = [0, 0, 90]
        leg = [
            { base = [-101, 201, 0], mirror = \"x\" },
            { base = [101, 201, 0] },
            { base = [-101, -201, 0], mirror = \"x\" },
            { base = [101, -201, 0] },
        ]
        lamps = 8
        [body]
        x = [-120, 120]
        y = [-230, 230]
        z = [-200, 50]
        mass = 12";
    let description = good(&format!("name = \"titan\"\n{TITAN_JOINTS}{legs}"));
    let model: Model<4, 3> = description.model().unwrap();
    let expected = Model {
        name: "titan",
        family: generic::MODEL.family,
        ..titan8::MODEL
    };
    assert_eq!(model, expected);
}

#[test]
fn everything_but_geometry_has_a_default() {
    let description = good(&one_leg("{ axis = \"x\", link = [0, 0, -10] }"));
    let model: Model<1, 1> = description.model().unwrap();
    let [leg] = model.legs;
    let [joint] = leg.joints;
    assert_eq!(joint.limits, Range::new(-180.0, 180.0));
    assert_eq!(joint.outer, Range::new(-185.0, 185.0));
    assert_eq!((joint.mass, joint.torque), (0.1, 10.0));
    assert_eq!(leg.initial, [0.0]);
    assert_eq!(model.standards, generic::MODEL.standards);
    assert_eq!(model.periods, generic::MODEL.periods);
    assert_eq!((model.lamps, model.contact), (16, generic::MODEL.contact));
    assert_eq!((model.body, model.forces, model.slider), (None, None, None));
}

#[test]
fn the_initial_posture_is_the_middle_of_the_limits_unless_given() {
    let joints = "{ axis = \"x\", link = [0, 0, 9], limits = [10, 30] }";
    let model: Model<1, 1> = good(&one_leg(joints)).model().unwrap();
    assert_eq!(model.legs[0].initial, [20.0]);
    let common = format!("initial = [15]\n{}", one_leg(joints));
    assert_eq!(
        good(&common).model::<1, 1>().unwrap().legs[0].initial,
        [15.0]
    );
    let own = common.replace("base", "initial = [16], base");
    assert_eq!(good(&own).model::<1, 1>().unwrap().legs[0].initial, [16.0]);
}

#[test]
fn an_axis_is_a_letter_or_any_direction() {
    for (axis, expected) in [
        ("\"x\"", [1.0, 0.0, 0.0]),
        ("\"-z\"", [0.0, 0.0, -1.0]),
        ("[0, -7, 0]", [0.0, -1.0, 0.0]),
        ("[3, 0, 4]", [0.6, 0.0, 0.8]),
    ] {
        let text = one_leg(&format!("{{ axis = {axis}, link = [0, 0, 9] }}"));
        let model: Model<1, 1> = good(&text).model().unwrap();
        assert_eq!(model.legs[0].joints[0].axis, expected, "{axis}");
    }
}

#[test]
fn a_turn_goes_counterclockwise_and_is_exact_at_quarters() {
    let turned = |turn: f64| {
        let text = one_leg("{ axis = [0, -1, 0], link = [10, 0, 3] }");
        let text = text.replace("base", &format!("turn = {turn}, base"));
        let model: Model<1, 1> = good(&text).model().unwrap();
        let joint = model.legs[0].joints[0];
        (joint.axis, joint.link)
    };
    assert_eq!(turned(90.0), ([1.0, 0.0, 0.0], [0.0, 10.0, 3.0]));
    assert_eq!(turned(180.0), ([0.0, 1.0, 0.0], [-10.0, 0.0, 3.0]));
    assert_eq!(turned(-90.0), ([-1.0, 0.0, 0.0], [0.0, -10.0, 3.0]));
    assert_eq!(turned(450.0), turned(90.0));
    let ([ax, ay, _], [x, y, _]) = turned(30.0);
    let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
    assert!(near(ax, 0.5) && near(ay, -(0.75_f64.sqrt())), "{ax} {ay}");
    assert!(near(x, 10.0 * 0.75_f64.sqrt()) && near(y, 5.0), "{x} {y}");
}

#[test]
fn mirrors_follow_the_turn() {
    let text = one_leg("{ axis = \"y\", link = [10, 0, 3] }");
    let text = text.replace("base", "turn = 90, mirror = \"yz\", base");
    let model: Model<1, 1> = good(&text).model().unwrap();
    // Turned: axis −x, link (0, 10, 3). Two mirrors are half a turn about x, which leaves the axis.
    assert_eq!(model.legs[0].joints[0].axis, [-1.0, 0.0, 0.0]);
    assert_eq!(model.legs[0].joints[0].link, [0.0, -10.0, -3.0]);
}

/// Returns the mass distribution of the only link, in a leg with these keys.
fn inertial(leg: &str, keys: &str) -> InertialProperties {
    let text = one_leg(&format!(
        "{{ axis = \"x\", link = [0, 0, -60], mass = 2, {keys} }}"
    ));
    let text = text.replace("base", &format!("{leg} base"));
    let model: Model<1, 1> = good(&text).model().unwrap();
    model.legs[0].joints[0].inertial.unwrap()
}

#[test]
fn a_centre_and_an_inertia_are_turned_and_mirrored_with_their_link() {
    let both = "centre = [1, 2, -30], inertia = [0.01, 0.02, 0.025, 0.001, 0.002, 0.003]";
    let plain = inertial("", both);
    assert_eq!(plain.centre, [1.0, 2.0, -30.0]);
    assert_eq!(plain.inertia, [0.01, 0.02, 0.025, 0.001, 0.002, 0.003]);
    // A quarter turn: what was along x is along y, what was along y along −x.
    let turned = inertial("turn = 90,", both);
    assert_eq!(turned.centre, [-2.0, 1.0, -30.0]);
    assert_eq!(turned.inertia, [0.02, 0.01, 0.025, -0.001, -0.003, 0.002]);
    let mirrored = inertial("mirror = \"x\",", both);
    assert_eq!(mirrored.centre, [-1.0, 2.0, -30.0]);
    assert_eq!(mirrored.inertia, [0.01, 0.02, 0.025, -0.001, -0.002, 0.003]);
}

#[test]
fn what_a_centre_or_an_inertia_leaves_out_is_that_of_a_rod_or_a_box() {
    // 2 kg of 60 mm: 2 · 0.06² / 12.
    let rod = inertial("", "centre = [0, 0, -10]");
    assert_eq!(rod.centre, [0.0, 0.0, -10.0]);
    assert!((rod.inertia[0] - 0.0006).abs() < 1e-15 && rod.inertia[2] == 0.0);
    let middle = inertial("", "inertia = [1e-3, 1e-3, 1e-3, 0, 0, 0]");
    assert_eq!(middle.centre, [0.0, 0.0, -30.0]);
    let text = format!(
        "{}[body]\nx = [-30, 30]\ny = [-60, 60]\nz = [0, 0.000001]\nmass = 1\ncentre = [5, 0, 1]",
        one_leg("{ axis = \"x\", link = [0, 0, -60] }")
    );
    let model: Model<1, 1> = good(&text).model().unwrap();
    let body = model.body.unwrap().inertial.unwrap();
    // 1 kg of 60 mm by 120 mm.
    assert_eq!(body.centre, [5.0, 0.0, 1.0]);
    for (ours, wanted) in body
        .inertia
        .iter()
        .zip([0.0012, 0.0003, 0.0015, 0.0, 0.0, 0.0])
    {
        assert!((ours - wanted).abs() < 1e-15, "{body:?}");
    }
}

#[test]
fn a_leg_may_have_joints_of_its_own() {
    let text = "name = \"odd pair\"
        [[joint]]
        axis = \"z\"
        link = [10, 0, 0]
        [[leg]]
        base = [1, 0, 0]
        [[leg]]
        base = [2, 0, 0]
        [[leg.joint]]
        axis = \"x\"
        link = [20, 0, 0]";
    let model: Model<2, 1> = good(text).model().unwrap();
    let links = model.legs.map(|leg| leg.joints[0].link[0]);
    assert_eq!(links, [10.0, 20.0]);
}

#[test]
fn the_inverse_is_the_closed_form_if_that_fits() {
    let leg = format!("name = \"leg\"\n{TITAN_JOINTS}leg = [{{ base = [0, 0, 0] }}]");
    let inverse = |text: &str| good(text).inverse;
    assert_eq!(inverse(&leg), Inverse::YawPitchPitch);
    // The knee flexes upwards.
    let upwards = leg.replace("[5, 150], outer = [0, 155]", "[-150, -5]");
    assert_eq!(inverse(&upwards), Inverse::RollPitchPitch);
    // The shank hangs down at 0.
    let hanging = leg.replace("[200, 0, 0]", "[0, 0, -200]");
    assert_eq!(inverse(&hanging), Inverse::RollPitchPitch);
    // No axis is at right angles to two parallel ones.
    let twisted = leg.replace("axis = \"y\"", "axis = \"x\"");
    assert_ne!(leg, twisted);
    assert_eq!(inverse(&twisted), Inverse::LeastSquares);
    let flat = leg.replace("\"y\"", "\"z\"").replace("\"-y\"", "\"-z\"");
    assert_eq!(inverse(&flat), Inverse::Planar);
    let asked = format!("inverse = \"least-squares\"\n{leg}");
    assert_eq!(inverse(&asked), Inverse::LeastSquares);
}

#[test]
fn torques_come_in_the_unit_of_the_file() {
    let forces = |table: &str| {
        let joints = "{ axis = \"x\", link = [0, 0, 9], torque = 3 }";
        good(&format!("{}[forces]\n{table}", one_leg(joints)))
            .forces
            .unwrap()
    };
    let plain = forces("");
    assert_eq!(
        (plain.unit, plain.torque_max),
        (TorqueUnit::NewtonMetre, 3.0)
    );
    assert_eq!(
        (plain.angle_stiffness, plain.position_stiffness),
        (2.0, 1.0)
    );
    let small = forces("unit = \"mN·m\"\nposition_stiffness = 0.5");
    assert_eq!(
        (small.unit, small.torque_max),
        (TorqueUnit::MillinewtonMetre, 3000.0)
    );
    assert_eq!(
        (small.angle_stiffness, small.position_stiffness),
        (2000.0, 0.5)
    );
}

#[test]
fn a_slider_stays_where_it_has_no_travel() {
    let text = one_leg("{ axis = \"z\", link = [9, 0, 0] }");
    let slider = good(&format!(
        "{text}[slider]\ninitial = [0, -90, 5]\ny = [-100, -50]"
    ))
    .slider;
    let travel = slider.unwrap().travel;
    assert_eq!(travel[0], Range::new(0.0, 0.0));
    assert_eq!(travel[1], Range::new(-100.0, -50.0));
    assert_eq!(travel[2], Range::new(5.0, 5.0));
}

#[test]
fn a_model_has_the_size_of_its_description() {
    struct Size;
    impl WithModel for Size {
        type Output = (usize, usize);
        fn with<const L: usize, const J: usize>(self, _: &Model<L, J>) -> (usize, usize) {
            (L, J)
        }
    }
    for legs in 1..=9 {
        for joints in 1..=9 {
            let leg = "{ base = [0, 0, 0] },".repeat(legs);
            let joint = "{ axis = \"x\", link = [0, 0, 1] },".repeat(joints);
            let text = format!("name = \"n\"\nleg = [{leg}]\njoint = [{joint}]");
            let description = good(&text);
            assert_eq!(description.with_model(Size), (legs, joints));
            let Robot::Described(facts) = description.robot() else {
                panic!("it is described");
            };
            let signature = (
                usize::from(facts.signature.legs),
                usize::from(facts.signature.joints),
            );
            assert_eq!(signature, (legs, joints));
        }
    }
    let two = good(&one_leg("{ axis = \"x\", link = [0, 0, 1] }"));
    assert!(two.model::<1, 2>().is_none() && two.model::<2, 1>().is_none());
}
