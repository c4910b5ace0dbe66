//! Robots from MuJoCo's models. Numbers are worked out by hand; `tests/external/mjcf` compares with MuJoCo.

mod hostile;

use tip_runtime::kinematics::Chain;
use tip_runtime::model::{Leg, Model};
use tip_sim::import::{Foot, Forward, Import, ImportOptions, import, import_with};
use tip_sim::{Robot, mjcf};
use tipc::description::{Description, parse};

fn reported(import: &Import) -> String {
    let lines: Vec<String> = import.report.iter().map(ToString::to_string).collect();
    lines.join("\n")
}

#[track_caller]
fn imported(text: &str) -> (Import, Description) {
    let import = import("test.xml", text).unwrap_or_else(|error| panic!("{error}"));
    let description = parse("test.toml", import.toml.as_bytes());
    let description = description.unwrap_or_else(|loaded| panic!("{:#?}", loaded.diagnostics));
    (import, description)
}

/// A finger on the world, with `inside` in its only body.
fn finger(settings: &str, inside: &str) -> String {
    format!(
        "<mujoco model=\"finger\">{settings}<worldbody><body name=\"base\"><body name=\"finger\" pos=\"0.1 0 0\">\
         {inside}</body></body></worldbody></mujoco>"
    )
}

/// A hinge about z from −90 to 90 deg, and a sphere 0.3 m ahead.
const HINGE: &str = "<joint name=\"a\" range=\"-90 90\"/><geom size=\"0.01\" pos=\"0.3 0 0\"/>";

fn leg<const J: usize>(text: &str) -> Leg<J> {
    let model: Model<1, J> = imported(text).1.model().expect("one leg");
    model.legs[0]
}

#[track_caller]
fn near(ours: &[f64], theirs: &[f64]) {
    assert_eq!(ours.len(), theirs.len());
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-6;
    assert!(
        ours.iter().zip(theirs).all(is_near),
        "{ours:?} is not {theirs:?}"
    );
}

/// The foot at angles in deg: x is to the right, y ahead.
#[track_caller]
fn foot_at<const J: usize>(text: &str, angles: [f64; J], foot: [f64; 3]) {
    near(&Chain::new(&leg::<J>(text), &angles).foot(), &foot);
}

#[test]
fn a_hinge_turns_about_its_axis_and_ends_at_the_last_sphere() {
    let text = finger("", HINGE);
    foot_at(&text, [0.0], [0.0, 400.0, 0.0]);
    // A quarter turn to the left.
    foot_at(&text, [90.0], [-300.0, 100.0, 0.0]);
    let leg = leg::<1>(&text);
    near(
        &[leg.joints[0].limits.min, leg.joints[0].limits.max],
        &[-90.0, 90.0],
    );
    let said = reported(&imported(&text).0);
    assert!(
        said.contains("F1: joint a to link finger=0.3,0,0"),
        "{said}"
    );
}

#[test]
fn angles_are_degrees_unless_the_compiler_says_radian() {
    let text = finger(
        "<compiler angle=\"radian\"/>",
        &HINGE.replace("-90 90", "-1 0.5"),
    );
    let limits = leg::<1>(&text).joints[0].limits;
    near(
        &[limits.min, limits.max],
        &[-1_f64.to_degrees(), 0.5_f64.to_degrees()],
    );
}

#[test]
fn a_range_limits_only_where_it_is_to() {
    let free = |settings: &str, joint: &str| {
        let text = finger(settings, &HINGE.replace("range", &format!("{joint} range")));
        reported(&imported(&text).0).contains("limits of -180 and 180 deg")
    };
    assert!(!free("", ""));
    assert!(free("", "limited=\"false\""));
    assert!(free("<compiler autolimits=\"false\"/>", ""));
    assert!(!free(
        "<compiler autolimits=\"false\"/>",
        "limited=\"true\""
    ));
}

/// Every form of a quarter turn about y, which brings x down: there roll and yaw are one.
#[test]
fn every_orientation_gives_the_same_frame() {
    let right_angle = std::f64::consts::FRAC_PI_2;
    for form in [
        "quat=\"1 0 1 0\"".to_owned(),
        "axisangle=\"0 2 0 90\"".to_owned(),
        "xyaxes=\"0 0 -3 0 1 0.5\"".to_owned(),
        "zaxis=\"2 0 0\"".to_owned(),
        "euler=\"0 90 0\"".to_owned(),
    ] {
        let text = finger("", HINGE).replace("pos=\"0.1 0 0\"", &format!("pos=\"0.1 0 0\" {form}"));
        foot_at(&text, [0.0], [0.0, 100.0, -300.0]);
        // About z of the body, which is ahead.
        foot_at(&text, [90.0], [-300.0, 100.0, 0.0]);
    }
    let text = finger(
        "<compiler angle=\"radian\"/>",
        &HINGE.replace("-90 90", "-1 1"),
    );
    let turned = format!("pos=\"0.1 0 0\" euler=\"0 {right_angle} 0\"");
    foot_at(
        &text.replace("pos=\"0.1 0 0\"", &turned),
        [0.0],
        [0.0, 100.0, -300.0],
    );
}

#[test]
fn euler_angles_follow_their_sequence() {
    // First about x, then about the new z or about the fixed one.
    for (sequence, foot) in [("xzy", [0.0, 100.0, 300.0]), ("XZY", [-300.0, 100.0, 0.0])] {
        let text = finger(&format!("<compiler eulerseq=\"{sequence}\"/>"), HINGE);
        let text = text.replace("pos=\"0.1 0 0\"", "pos=\"0.1 0 0\" euler=\"90 90 0\"");
        foot_at(&text, [0.0], foot);
    }
}

#[test]
fn several_joints_of_a_body_turn_one_after_the_other() {
    let inside = "<joint name=\"a\" range=\"-90 90\"/><joint name=\"b\" axis=\"0 1 0\" pos=\"0.1 0 0\" range=\"-90 90\"/>\
                  <geom size=\"0.01\" pos=\"0.3 0 0\"/>";
    let text = finger("", inside);
    foot_at(&text, [0.0, 0.0], [0.0, 400.0, 0.0]);
    // 100 mm to the elbow, then 200 mm down.
    foot_at(&text, [0.0, 90.0], [0.0, 200.0, -200.0]);
    foot_at(&text, [90.0, 90.0], [-100.0, 100.0, -200.0]);
}

#[test]
fn a_reference_is_the_value_in_the_pose_of_the_file() {
    let text = finger("", &HINGE.replace("name=", "ref=\"90\" name="));
    foot_at(&text, [90.0], [0.0, 400.0, 0.0]);
    foot_at(&text, [0.0], [300.0, 100.0, 0.0]);
}

#[test]
fn classes_hand_their_attributes_down() {
    let defaults = "<default><joint range=\"-10 10\"/><default class=\"leg\"><joint axis=\"0 1 0\"/>\
                    <default class=\"knee\"><joint range=\"-20 20\"/></default></default></default>";
    let joint = |class: &str| {
        let inside = format!("<joint name=\"a\" {class}/><geom size=\"0.01\" pos=\"0.3 0 0\"/>");
        let joint = leg::<1>(&finger(defaults, &inside)).joints[0];
        (joint.axis, joint.limits.max)
    };
    assert_eq!(joint(""), ([0.0, 0.0, 1.0], 10.0));
    // y of the file is −x of the robot frame.
    assert_eq!(joint("class=\"leg\""), ([-1.0, 0.0, 0.0], 10.0));
    assert_eq!(joint("class=\"knee\""), ([-1.0, 0.0, 0.0], 20.0));
    let scoped = finger(
        defaults,
        "<joint name=\"a\"/><geom size=\"0.01\" pos=\"0.3 0 0\"/>",
    );
    let scoped = scoped.replace("name=\"finger\"", "name=\"finger\" childclass=\"knee\"");
    assert_eq!(leg::<1>(&scoped).joints[0].limits.max, 20.0);
}

#[test]
fn frames_and_copies_place_what_is_in_them() {
    let text = "<mujoco><worldbody><body name=\"base\"><replicate count=\"3\" euler=\"0 0 90\" sep=\"_\">\
                <frame pos=\"0.1 0 0\"><body name=\"f\"><joint name=\"j\" range=\"-9 9\"/><geom size=\"0.01\" pos=\"0.1 0 0\"/></body>\
                </frame></replicate></body></worldbody></mujoco>";
    let (import, description) = imported(text);
    let model: Model<3, 1> = description.model().expect("three legs");
    let bases = model.legs.map(|leg| leg.base);
    near(
        bases.as_flattened(),
        &[0.0, 100.0, 0.0, -100.0, 0.0, 0.0, 0.0, -100.0, 0.0],
    );
    assert!(reported(&import).contains("F2: joint j_1 to link f_1=0.1,0,0"));
}

#[test]
fn the_foot_is_a_site_else_a_sphere_else_the_end_of_a_capsule() {
    const CAPSULE: &str = "<geom type=\"capsule\" size=\"0.01\" fromto=\"0.5 0 0 0.1 0 0\"/>";
    const SPHERE: &str = "<geom size=\"0.01\" pos=\"0.3 0 0\"/>";
    const SITE: &str = "<site name=\"FL_footSite\" pos=\"0.2 0 0\"/>";
    let foot = |parts: &[&str]| {
        let text = finger(
            "",
            &format!("<joint name=\"a\" range=\"-9 9\"/>{}", parts.concat()),
        );
        reported(&imported(&text).0)
            .lines()
            .find(|line| line.starts_with("F1: "))
            .map(str::to_owned)
    };
    let ends = |at: &str| Some(format!("F1: joint a to link finger={at},0,0"));
    assert_eq!(foot(&[SITE, SPHERE, CAPSULE]), ends("0.2"));
    assert_eq!(foot(&[SPHERE, CAPSULE]), ends("0.3"));
    assert_eq!(foot(&[CAPSULE]), ends("0.5"));
    // What touches nothing is no foot, nor is a site of another name.
    let seen = SPHERE.replace("size", "contype=\"0\" conaffinity=\"0\" size");
    assert_eq!(
        foot(&[&SITE.replace("foot", "imu"), &seen, CAPSULE]),
        ends("0.5")
    );
    let none = finger("", "<joint name=\"a\"/>");
    let error = import("test.xml", &none).expect_err("no foot").to_string();
    assert!(error.contains("--foot finger=X,Y,Z"), "{error}");
}

#[test]
fn masses_come_from_geometries_where_a_body_has_none() {
    let mass = |inside: &str, settings: &str| {
        let text = finger(settings, &format!("{HINGE}{inside}"));
        leg::<1>(&text).joints[0].mass
    };
    let ball = 4.0 / 3.0 * std::f64::consts::PI * 0.01_f64.powi(3) * 1000.0;
    near(&[mass("", "")], &[ball]);
    let inertial = "<inertial pos=\"0 0 0\" mass=\"2\" diaginertia=\"0.01 0.01 0.01\"/>";
    near(&[mass(inertial, "")], &[2.0]);
    near(
        &[mass(inertial, "<compiler inertiafromgeom=\"true\"/>")],
        &[ball],
    );
    near(
        &[mass(
            "<geom type=\"box\" size=\"0.05 0.1 0.2\" density=\"500\"/>",
            "",
        )],
        &[ball + 4.0],
    );
    near(&[mass(inertial, "<compiler settotalmass=\"8\"/>")], &[8.0]);
}

#[test]
fn torques_are_what_motors_and_joints_allow() {
    let torque = |joint: &str, actuators: &str| {
        let text = finger("", &HINGE.replace("name=", &format!("{joint} name=")));
        let text = text.replace(
            "</mujoco>",
            &format!("<actuator>{actuators}</actuator></mujoco>"),
        );
        leg::<1>(&text).joints[0].torque
    };
    assert_eq!(
        torque("", "<motor joint=\"a\" ctrlrange=\"-2 2\" gear=\"6\"/>"),
        12.0
    );
    assert_eq!(
        torque(
            "",
            "<motor joint=\"a\" ctrlrange=\"-2 2\" forcerange=\"-1 1\" gear=\"6\"/>"
        ),
        6.0
    );
    // Of a position motor the control is an angle.
    assert_eq!(
        torque(
            "",
            "<position joint=\"a\" ctrlrange=\"-2 2\" forcerange=\"-5 5\"/>"
        ),
        5.0
    );
    assert_eq!(
        torque(
            "actuatorfrcrange=\"-3 3\"",
            "<position joint=\"a\" forcerange=\"-5 5\"/>"
        ),
        3.0
    );
    assert_eq!(torque("actuatorfrcrange=\"-3 3\"", ""), 3.0);
    // None is stated.
    assert_eq!(
        torque("", "<position joint=\"a\" ctrlrange=\"-2 2\"/>"),
        10.0
    );
}

#[test]
fn a_keyframe_is_the_initial_posture() {
    let text = finger("", HINGE);
    let keys = "<keyframe><key name=\"other\" qpos=\"1\"/><key name=\"home\" qpos=\"0.5\"/></keyframe></mujoco>";
    let (import, description) = imported(&text.replace("</mujoco>", keys));
    let model: Model<1, 1> = description.model().expect("one leg");
    near(&model.legs[0].initial, &[0.5_f64.to_degrees()]);
    let said = reported(&import);
    assert!(said.contains("keyframe home") && !said.contains("outside of the limits"));
}

/// MuJoCo lets a keyframe be outside of a range: the initial posture is at its end.
#[test]
fn a_keyframe_outside_of_the_limits_ends_there() {
    let text = finger("", &HINGE.replace("-90 90", "-28.6 28.6"));
    for (qpos, angle) in [
        ("0.5", 28.6),
        ("-0.6", -28.6),
        ("0.4", 0.4_f64.to_degrees()),
    ] {
        let keys = format!("<keyframe><key name=\"home\" qpos=\"{qpos}\"/></keyframe></mujoco>");
        let (import, description) = imported(&text.replace("</mujoco>", &keys));
        let model: Model<1, 1> = description.model().expect("one leg");
        near(&model.legs[0].initial, &[angle]);
        let line = "outside of the limits of these joints, and the initial posture is at their ends: a [-28.6, 28.6]";
        let is_outside = reported(&import).contains(line);
        assert_eq!(is_outside, angle.abs() == 28.6, "{qpos}");
    }
}

/// Four legs whose names say that −x is forward.
fn backwards() -> String {
    let leg = |name: &str, x: f64, y: f64| {
        format!(
            "<body name=\"{name}\" pos=\"{x} {y} 0\"><joint name=\"{name}_hip\" range=\"-9 9\"/>\
             <geom size=\"0.01\" pos=\"0 0 -0.2\"/></body>"
        )
    };
    format!(
        "<mujoco><worldbody><body name=\"trunk\"><freejoint/><geom type=\"box\" size=\"0.2 0.1 0.05\"/>{}{}{}{}</body>\
         </worldbody></mujoco>",
        leg("FL", -0.2, -0.1),
        leg("FR", -0.2, 0.1),
        leg("RL", 0.2, -0.1),
        leg("RR", 0.2, 0.1)
    )
}

#[test]
fn names_that_contradict_places_are_doubtful() {
    let text = backwards();
    let said = reported(&imported(&text).0);
    assert!(
        said.contains("`--forward -x` turns the model: RR_hip, RL_hip, FR_hip, FL_hip"),
        "{said}"
    );
    let options = ImportOptions {
        forward: Some(Forward::MinusX),
        ..ImportOptions::default()
    };
    let turned = import_with("test.xml", &text, &options).expect("it is turned");
    let said = reported(&turned);
    assert!(!said.contains("contradict"), "{said}");
    assert!(said.contains("F1: joint FL_hip"), "{said}");
    // Mirrored, no turn helps.
    let mirrored = text
        .replace("\"FL", "\"XX")
        .replace("\"FR", "\"FL")
        .replace("\"XX", "\"FR");
    let said = reported(&imported(&mirrored).0);
    assert!(said.contains("whatever axis is forward"), "{said}");
}

/// Two legs on a free joint are no fingers.
#[test]
fn a_free_body_walks_on_any_number_of_legs() {
    let text = backwards();
    let options = ImportOptions {
        skip: vec!["RL".to_owned(), "RR".to_owned()],
        ..ImportOptions::default()
    };
    let text = text.replace(
        "<geom type=\"box\" size=\"0.2 0.1 0.05\"/>",
        "<geom size=\"0.1\"/>",
    );
    let import = import_with("test.xml", &text, &options).expect("two legs");
    assert!(import.toml.contains("\n[body]\n"), "{}", import.toml);
}

#[test]
fn forward_is_not_up() {
    let options = ImportOptions {
        forward: Some(Forward::Z),
        ..ImportOptions::default()
    };
    let error = import_with("test.xml", &backwards(), &options).expect_err("z is up");
    assert!(error.to_string().contains("`--forward z`"), "{error}");
}

#[test]
fn what_is_left_out_is_weighed() {
    let arm = "<body name=\"arm\" pos=\"0 0 0.1\"><joint name=\"arm_yaw\" range=\"-9 9\"/>\
               <inertial pos=\"0 0 0\" mass=\"1.5\" diaginertia=\"0.1 0.1 0.1\"/>\
               <body name=\"hand\"><inertial pos=\"0 0 0\" mass=\"0.25\" diaginertia=\"0.1 0.1 0.1\"/></body></body>";
    let text = backwards().replace("<freejoint/>", &format!("<freejoint/>{arm}"));
    let options = ImportOptions {
        skip: vec!["arm".to_owned()],
        ..ImportOptions::default()
    };
    let said = reported(&import_with("test.xml", &text, &options).expect("four legs"));
    assert!(
        said.contains("the chains of arm_yaw, which weigh 1.75 kg"),
        "{said}"
    );
}

#[test]
fn a_wheel_is_no_foot() {
    let wheel = "<joint name=\"knee\" range=\"-9 9\"/><body name=\"wheel\" pos=\"0.3 0 0\"><joint name=\"wheel_joint\"/>\
                 <inertial pos=\"0 0 0\" mass=\"0.5\" diaginertia=\"0.1 0.1 0.1\"/><geom size=\"0.1\"/></body>";
    let text = finger("", wheel);
    let error = import("test.xml", &text).expect_err("a wheel").to_string();
    assert!(error.contains("`--foot finger=X,Y,Z`"), "{error}");
    let with = |link: &str, at: [f64; 3]| {
        let foot = Foot {
            link: link.to_owned(),
            at,
        };
        let options = ImportOptions {
            feet: vec![foot],
            ..ImportOptions::default()
        };
        reported(&import_with("test.xml", &text, &options).expect("a leg"))
    };
    assert!(with("finger", [0.3, 0.0, 0.0]).contains("weighs 0.5 kg: joints wheel_joint"));
    assert!(with("wheel", [0.0; 3]).contains("the hub of a wheel"));
}

#[test]
fn what_moves_nothing_is_ignored_and_listed() {
    let text = finger(
        "<future x=\"1\"/>",
        &format!("{HINGE}<gadget/><camera name=\"eye\"/>"),
    );
    let text = text.replace(
        "<worldbody>",
        "<worldbody><body name=\"ball\"><freejoint/><geom size=\"1\"/></body>",
    );
    let said = reported(&imported(&text).0);
    assert!(
        said.contains("not to move the robot: future, gadget"),
        "{said}"
    );
    assert!(said.contains("that carry no joint: ball"), "{said}");
}

/// Returns a description without its comments, which name the joints of another file.
fn keys(toml: &str) -> Vec<String> {
    let lines = toml
        .lines()
        .map(|line| line.split(" # ").next().unwrap_or_default());
    lines
        .filter(|line| !line.starts_with('#'))
        .map(str::to_owned)
        .collect()
}

#[test]
fn exported_robots_return() {
    let mut robots: Vec<Robot> = ["titan8", "generic", "hand"]
        .map(|name| Robot::named(name).expect("it is known"))
        .to_vec();
    for toml in [
        include_str!("../../../../tipc/robots/a1.toml"),
        include_str!("../../../../tipc/robots/trifinger.toml"),
        include_str!("../../../../tipc/tests/robots/hexapod.toml"),
        include_str!("../../../../tests/language/cases/robots/nine.toml"),
    ] {
        robots.push(Robot::from_description(toml).expect("it is a robot"));
    }
    for robot in robots {
        let name = robot.name();
        let (first, _) = imported(&mjcf::export(&robot));
        let again = Robot::from_description(&first.toml).expect("it is a robot");
        let (ours, theirs) = (robot.description(), again.description());
        assert_eq!(ours.inverse, theirs.inverse, "{name}");
        assert_eq!(ours.legs.len(), theirs.legs.len(), "{name}");
        for (ours, theirs) in ours.legs.iter().zip(&theirs.legs) {
            near(&ours.base, &theirs.base);
            near(&ours.initial, &theirs.initial);
            for (ours, theirs) in ours.joints.iter().zip(&theirs.joints) {
                near(&ours.axis, &theirs.axis);
                near(&ours.link, &theirs.link);
                near(&[ours.mass, ours.torque], &[theirs.mass, theirs.torque]);
                near(
                    &[ours.limits.min, ours.limits.max],
                    &[theirs.limits.min, theirs.limits.max],
                );
            }
        }
        let weight = |robot: &Robot| robot.description().body.map(|body| body.mass);
        assert_eq!(weight(&robot), weight(&again), "{name}");
        let box_of = |robot: &Robot| {
            robot
                .description()
                .body
                .map(|body| [body.x, body.y, body.z])
        };
        for (ours, theirs) in box_of(&robot)
            .iter()
            .flatten()
            .zip(box_of(&again).iter().flatten())
        {
            near(&[ours.min, ours.max], &[theirs.min, theirs.max]);
        }
        near(&[ours.standards.omega_max], &[theirs.standards.omega_max]);
        let travel = |robot: &Robot| robot.description().slider.map(|slider| slider.travel);
        for (ours, theirs) in travel(&robot)
            .iter()
            .flatten()
            .zip(travel(&again).iter().flatten())
        {
            near(&[ours.min, ours.max], &[theirs.min, theirs.max]);
        }
        // Once more, nothing changes any more.
        let (second, _) = imported(&mjcf::export(&again));
        assert_eq!(keys(&first.toml), keys(&second.toml), "{name}");
    }
}
