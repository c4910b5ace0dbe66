//! Quantities of robots and scenes: a case is as if their files had the number.

use crate::{numbers, rows, spec, texts};
use tip_sim::{Robot, import, mjcf, urdf};
use tip_sweep::{Cell, PlantSpec, RobotSpec, Row, Spec, Sweep, Table};
use tipc::message::Lang;

pub(crate) const HEXAPOD: &str = include_str!("../../../../examples/six-legs/hexapod.toml");
pub(crate) const TRIPOD: &str = include_str!("../../../../examples/six-legs/motions/tripod.prg");
const SCENE: &str = include_str!("../../../../examples/grasp/scene.toml");
const GRASP: &str = include_str!("../../../../examples/grasp/motions/grasp.prg");

fn has(table: &Table, name: &str) -> bool {
    table.columns.iter().any(|column| column.name == name)
}

/// The cells as in a line of a table.
fn lines(cells: &[Cell]) -> String {
    cells.iter().map(|cell| format!("{cell},")).collect()
}

fn hashes(table: &Table) -> Vec<&str> {
    texts(table, "hash")
}

#[test]
fn a_number_of_a_description_varies() {
    let on = |text: &str, axes: &[&str]| Spec {
        robot: RobotSpec::Description(text.to_owned()),
        plant: PlantSpec::Dynamic,
        until: 0.4,
        ..spec(TRIPOD, axes)
    };
    let both = rows(on(HEXAPOD, &["robot.body.mass=8,16"]));
    let edited = HEXAPOD.replace("\nmass = 8", "\nmass = 16");
    assert_ne!(edited, HEXAPOD);
    let one = [rows(on(HEXAPOD, &[])), rows(on(&edited, &[]))];
    for (row, one) in one.iter().enumerate() {
        assert_eq!(hashes(&both)[row], hashes(one)[0]);
        let energy = numbers(&both, "energy")[row];
        assert_eq!(energy, numbers(one, "energy")[0]);
    }
    let torques = numbers(&both, "peak_torque");
    assert!(
        torques[1] > torques[0],
        "the heavier body needs more: {torques:?}"
    );
    let refused = Sweep::new(on(HEXAPOD, &["robot.body.mass=8,-1"])).expect_err("no mass");
    assert_eq!(
        refused.to_string(),
        "cannot vary 'robot.body.mass': the robot does not allow a value: it must be above 0 (`mass = -1.0`)"
    );
    let japanese = refused.text(Lang::Japanese);
    assert!(
        japanese.starts_with("'robot.body.mass' を変えられません: ")
            && !japanese.contains("must be"),
        "{japanese}"
    );
}

/// An imported robot is that of the description that `tip robot import` writes, and its numbers vary under the keys of that.
#[test]
fn a_robot_may_be_a_urdf_file() {
    let robot = Robot::from_description(HEXAPOD).expect("a robot");
    let exported = urdf::export(&robot);
    let toml = import::import("robot.urdf", &exported)
        .expect("it is a robot")
        .toml;
    let with = |robot: RobotSpec| {
        let program = "3.1\nt\nREL_PTP F1 0 0 10\nWAIT_INPOS F1\nEND\n";
        rows(Spec {
            robot,
            plant: PlantSpec::Dynamic,
            until: 0.4,
            ..spec(program, &["robot.body.mass=8,16"])
        })
    };
    let imported = with(RobotSpec::Urdf(exported));
    let described = with(RobotSpec::Description(toml));
    // Each row but for its check, which is over the specification.
    for (imported, described) in imported.rows.iter().zip(&described.rows) {
        let (_, cells) = imported.cells().split_last().expect("cells");
        assert!(described.line().starts_with(&lines(cells)), "{cells:?}");
    }
    assert_ne!(hashes(&imported)[0], hashes(&imported)[1]);
    // Its root element tells MJCF from URDF.
    let walker = RobotSpec::Urdf(mjcf::export(&robot)).robot();
    assert_eq!(walker.expect("it is a robot").description().legs.len(), 6);
    let broken = Spec {
        robot: RobotSpec::Urdf("<robot/>".to_owned()),
        ..spec(crate::LIFT, &[])
    };
    let refused = Sweep::new(broken).expect_err("it has no legs");
    let reason = import::import("robot.urdf", "<robot/>").expect_err("it has no legs");
    assert_eq!(refused.to_string(), reason.to_string());
}

#[test]
fn a_number_of_an_object_varies_and_torques_of_the_hand_are_in_newton_metres() {
    let with = |scene: &str, axes: &[&str]| Spec {
        robot: RobotSpec::Name("hand".to_owned()),
        scene: Some(scene.to_owned()),
        until: 6.0,
        ..spec(GRASP, axes)
    };
    let both = rows(with(SCENE, &["scene.object.1.mass=0.2,0.3"]));
    let edited = SCENE.replace("mass = 0.2", "mass = 0.3");
    assert_ne!(edited, SCENE);
    assert_eq!(hashes(&both)[0], hashes(&rows(with(SCENE, &[])))[0]);
    assert_eq!(hashes(&both)[1], hashes(&rows(with(&edited, &[])))[0]);
    assert_ne!(
        hashes(&both)[0],
        hashes(&both)[1],
        "the object has been grasped"
    );
    // The program commands 200 mN·m; the motors give no more than a few times that.
    for torque in numbers(&both, "peak_torque") {
        assert!((0.2..2.0).contains(&torque), "{torque} N·m");
    }
    assert!(has(&both, "object1_highest"));
}

/// A body that lies on a floor that rises by 0.15 in 1 is tilted by atan 0.15 = 8.53 deg, and a little more where the floor gives way.
#[test]
fn the_tilt_is_that_of_the_body() {
    let lying = Spec {
        scene: Some("[floor]\nslope = [0, 0.15]\n".to_owned()),
        ..spec("3.1\nt\nSLEEP 100\nEND\n", &[])
    };
    let tilt = numbers(&rows(lying), "tilt")[0];
    assert!((tilt - 8.5308).abs() < 0.01, "{tilt} deg");
}

#[test]
fn scenes_and_plants_have_names() {
    let on = |plant| Spec {
        plant,
        until: 0.1,
        ..spec(crate::LIFT, &[])
    };
    let has_mass = |plant| has(&rows(on(plant)), "energy");
    assert!(has_mass(PlantSpec::Dynamic));
    assert!(!has_mass(PlantSpec::QuasiStatic) && !has_mass(PlantSpec::Scene));
    let grasp = Spec {
        robot: RobotSpec::Name("hand".to_owned()),
        scene: Some("cylinder".to_owned()),
        until: 0.1,
        ..spec(GRASP, &[])
    };
    assert!(has(&rows(grasp), "object1_x"));
}

/// A push at the centre of mass topples a body about its feet if the floor holds them: if friction is above half the stance over the
/// height, 0.39 m / 0.26 m. A slippery floor lets the robot slide.
#[test]
fn a_pushed_robot_falls_where_the_floor_holds_its_feet_and_slides_elsewhere() {
    let stands = "3.1\nt\nSTAND_UP 60\nWAIT_INPOS ALL\nSLEEP 4000\nEND\n";
    let pushed = Spec {
        plant: PlantSpec::Dynamic,
        until: 5.0,
        ..spec(stands, &["friction=0.3,3", "push.x=600", "push.at=3"])
    };
    let both = rows(pushed);
    let fallen: Vec<bool> = both.rows.iter().map(Row::has_fallen).collect();
    assert_eq!(fallen, [false, true]);
    assert!(numbers(&both, "slip")[0] > 1000.0);
    let first = numbers(&both, "first_fall")[1];
    assert!((3.0..3.5).contains(&first), "{first} s");
    let tilt = numbers(&both, "tilt");
    assert!(tilt[0] < 1.0 && tilt[1] > 60.0, "{tilt:?}");
}
