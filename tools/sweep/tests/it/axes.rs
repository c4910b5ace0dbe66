//! Axes: their text forms, their names, and what is refused.

use crate::surroundings::HEXAPOD;
use crate::{LIFT, numbers, refused, rows, spec, sweep};
use tip_sweep::{Axis, PlantSpec, RobotSpec, Spec, Sweep, Values, run_chunk};
use tipc::message::Lang;

fn values(text: &str) -> Values {
    text.parse::<Axis>().expect("an axis").values
}

#[test]
fn axes_are_lists_ranges_and_distributions() {
    assert_eq!(values("A=1,2.5,-3"), Values::List(vec![1.0, 2.5, -3.0]));
    let range = |from, to, step| Values::Range { from, to, step };
    assert_eq!(values("A=100..300/20"), range(100.0, 300.0, 20.0));
    assert_eq!(values("A=1..3"), range(1.0, 3.0, 1.0));
    let uniform = Values::Uniform {
        low: 0.4,
        high: 1.0,
    };
    assert_eq!(values("A=uniform(0.4, 1)"), uniform);
    let normal = Values::Normal {
        mean: 20.0,
        deviation: 2.0,
    };
    assert_eq!(values("A = normal(20,2)"), normal);
    let forms = "write NAME=FROM..TO/STEP, NAME=A,B,C, NAME=uniform(LOW,HIGH) or NAME=normal(MEAN,DEVIATION)";
    let error = |text: &str| text.parse::<Axis>().expect_err(text).message();
    for wrong in ["A", "=3", "A=", "A= "] {
        assert_eq!(
            error(wrong).to_string(),
            format!("`{wrong}` is not a quantity with values: {forms}")
        );
    }
    for (wrong, word) in [
        ("A=x", "x"),
        ("A=1,,2", ""),
        ("A=1..x", "x"),
        ("A=1..2/x", "x"),
        ("A=uniform(1)", "uniform(1)"),
        ("A=normal(1,x)", "x"),
    ] {
        assert_eq!(
            error(wrong).to_string(),
            format!("`{word}` in `{wrong}` is not a number: {forms}")
        );
    }
    let japanese = error("A=x").in_lang(Lang::Japanese).to_string();
    assert!(
        japanese.starts_with("`A=x` の `x` は数値ではありません。"),
        "{japanese}"
    );
}

#[test]
fn a_range_ends_with_its_end_where_a_step_meets_it() {
    let listed = |axis: &str| {
        let table = rows(spec(LIFT, &[axis]));
        numbers(&table, "Z")
    };
    // Three steps of 0.1 are 0.30000000000000004.
    assert_eq!(listed("Z=0..0.3/0.1"), [0.0, 0.1, 0.2, 0.3]);
    assert_eq!(listed("Z=0..-0.3/-0.1"), [0.0, -0.1, -0.2, -0.3]);
    assert_eq!(listed("Z=5..5/0.1"), [5.0]);
    // No step meets this end.
    assert_eq!(listed("Z=0..0.35/0.125"), [0.0, 0.125, 0.25]);
}

#[test]
fn a_constant_does_not_vary() {
    let text = |declared: &str| format!("3.2\nSide\n{declared}\nREL_PTP F1 0 0 SIDE\nEND\n");
    let constant = spec(&text("DEFINE SIDE 20"), &["side=5"]);
    let error = Sweep::new(constant).expect_err("a constant").to_string();
    assert_eq!(
        error,
        "cannot vary 'side': DEFINE makes it a constant: declare it with DEF_VAR and assign its value"
    );
    let variable = text("DEF_VAR SIDE\nSIDE = 20");
    Sweep::new(spec(&variable, &["SIDE=5"])).expect("a variable");
}

#[test]
fn numbers_of_files_have_the_units_of_their_keys() {
    let units = |spec: Spec| {
        let columns = run_chunk(&spec, 0, 1).expect("it runs");
        let axes = columns.columns.iter().take(1 + spec.vary.len()).skip(1);
        axes.map(|column| column.unit).collect::<Vec<_>>()
    };
    let axes = [
        "scene.floor.friction=1",
        "scene.floor.height=0",
        "scene.block.1.height=5",
        "scene.block.1.x.1=300",
    ];
    let block = "[floor]\nheight = 0\n[[block]]\nx = [300, 400]\ny = [300, 400]\nheight = 5\n";
    let scene = Spec {
        scene: Some(block.to_owned()),
        cycles: Some(1),
        ..spec(LIFT, &axes)
    };
    assert_eq!(units(scene), ["", "mm", "mm", "mm"]);
    let axes = [
        "robot.body.mass=8",
        "robot.joint.2.link.3=-100",
        "robot.joint.2.torque=20",
        "robot.standards.omega_max=90",
        "robot.leg.1.turn=0",
        "robot.initial.1=0",
        "robot.lamps=4",
    ];
    let robot = Spec {
        robot: RobotSpec::Description(HEXAPOD.to_owned()),
        cycles: Some(1),
        ..spec("3.1\nt\nEND\n", &axes)
    };
    let expected = ["kg", "mm", "N·m", "deg/s", "deg", "deg", ""];
    assert_eq!(units(robot), expected);
}

#[test]
fn a_range_includes_both_ends_if_its_step_meets_them() {
    let count = |axis: &str| sweep(LIFT, &[axis]).expect("a sweep").cases();
    assert_eq!(count("Z=10..30/5"), 5);
    assert_eq!(count("Z=10..32/5"), 5);
    assert_eq!(count("Z=30..10/-10"), 3);
    // 0.4 + 6 · 0.1 is below 1 by rounding alone.
    assert_eq!(count("friction=0.4..1.0/0.1"), 7);
    assert_eq!(count("Z=7..7/1"), 1);
}

#[test]
fn empty_axes_are_refused() {
    let empty = "cannot vary 'Z': the range is empty: the step leads away from its end";
    assert_eq!(refused(LIFT, &["Z=10..30/-5"]), empty);
    let upside_down = refused(LIFT, &["Z=uniform(2,1)"]);
    assert_eq!(
        upside_down,
        "cannot vary 'Z': the lower bound is above the upper one"
    );
    assert!(refused(LIFT, &["Z=normal(1,-1)"]).contains("negative"));
    assert!(refused(LIFT, &["Z=0..1e12/1"]).contains("more than 1,000,000 values"));
    assert_eq!(
        refused(LIFT, &["Z=1..1000000/2", "push.x=1..1000000/2"]),
        "these are 250000000000 cases, more than 1000000000; take wider steps, or random values: NAME=uniform(LOW,HIGH)"
    );
}

#[test]
fn values_that_no_quantity_has_are_refused() {
    for (axis, reason) in [
        ("Z=1..3/0", "the step is 0"),
        ("Z=3..1", "the range is empty"),
        ("Z=-1e308..1e308/1e308", "the numbers are too large"),
        ("Z=uniform(-1e308,1e308)", "the numbers are too large"),
        ("Z=normal(1.7e308,1e308)", "the numbers are too large"),
        ("Z=uniform(1,1e999)", "a value is not a finite number"),
        ("push.at=-5", "no time or deviation is below 0"),
    ] {
        let said = refused(LIFT, &[axis]);
        assert!(said.contains(reason), "{said}");
    }
    for axis in ["Z=uniform(-8e307,8e307)", "Z=normal(20,0)", "Z=-5"] {
        assert!(sweep(LIFT, &[axis]).is_ok(), "{axis}");
    }
}

#[test]
fn friction_changes_no_walk_without_mass() {
    let idle = |plant, axes: &[&str]| {
        let spec = Spec {
            plant,
            ..spec(LIFT, axes)
        };
        let sweep = Sweep::new(spec).expect("a sweep");
        sweep.idle_axis().map(str::to_owned)
    };
    let friction = ["Z=10,20", "friction=0.4,0.9"];
    assert_eq!(
        idle(PlantSpec::QuasiStatic, &friction).as_deref(),
        Some("friction")
    );
    assert_eq!(idle(PlantSpec::Dynamic, &friction), None);
    assert_eq!(idle(PlantSpec::QuasiStatic, &["Z=10,20"]), None);
}

#[test]
fn unknown_quantities_are_refused_with_the_nearest_one() {
    let program = LIFT.replace('Z', "HEIGHT");
    assert!(refused(&program, &["HIEGHT=1,2"]).ends_with("; did you mean HEIGHT?"));
    assert!(refused(&program, &["fricton=1,2"]).ends_with("; did you mean friction?"));
    for (name, near) in [
        ("floor.friction", "friction"),
        ("floor.slope.1", "scene.floor.slope.1"),
        ("body.mass", "robot.body.mass"),
    ] {
        let said = refused(&program, &[&format!("{name}=1,2")]);
        assert!(said.ends_with(&format!("; did you mean {near}?")), "{said}");
        assert!(
            said.contains("friction, scene.KEY, robot.KEY, push.x"),
            "{said}"
        );
    }
    assert!(!refused(&program, &["W=1"]).contains("did you mean"));
    assert!(refused(&program, &["sensor.VR99=1"]).contains("'VR99' is not an input"));
    assert!(
        sweep(&program, &["height=10,20"]).is_ok(),
        "variables have no case"
    );
    assert_eq!(
        refused(LIFT, &["Z=1,2", "z=3"]),
        "cannot vary 'z': it is varied twice"
    );
}

#[test]
fn keys_of_files_are_checked_before_the_first_run() {
    // A list that the file leaves out, or that no file has, has its default.
    let default = sweep(LIFT, &["scene.floor.slope.1=0,0.1"]);
    assert_eq!(default.map(|sweep| sweep.cases()), Ok(2));
    let block = sweep(LIFT, &["scene.block.1.height=5"]).expect_err("there is no block");
    assert!(
        block
            .to_string()
            .ends_with("there is no element 1; elements count from 1"),
        "{block}"
    );
    let with = |scene: &str, axis: &str| {
        let scene = Some(scene.to_owned());
        Sweep::new(Spec {
            scene,
            ..spec(LIFT, &[axis])
        })
        .map(|sweep| sweep.cases())
    };
    let slope = "[floor]\nslope = [0, 0]\n";
    assert_eq!(with(slope, "scene.floor.slope.2=0,0.1"), Ok(2));
    assert_eq!(
        with("[floor]\nheight = 5\n", "scene.floor.slope.2=0,0.1"),
        Ok(2)
    );
    let third = with(slope, "scene.floor.slope.3=0").expect_err("it has two");
    assert_eq!(
        third.to_string(),
        "case 0 (scene.floor.slope.3=0): cannot vary 'scene.floor.slope.3': there is no element 3; elements count from 1"
    );
    assert!(with(slope, "scene.floor.frictio=1").is_err());
    assert!(with(slope, "friction=-1").is_err());
    let cylinder = Sweep::new(Spec {
        robot: RobotSpec::Name("hand".to_owned()),
        scene: Some("cylinder".to_owned()),
        ..spec("3.1\nt\nEND\n", &["scene.object.1.mass=1"])
    });
    let cylinder = cylinder.expect_err("it is a name").to_string();
    assert!(cylinder.contains("cylinder has no file"), "{cylinder}");
    let titan = refused(LIFT, &["robot.body.mass=20"]);
    assert!(titan.contains("titan8 has no description"), "{titan}");
}

#[test]
fn a_program_with_errors_is_refused_with_its_errors() {
    let errors = refused("3.1\nt\nPTPP F1 1 2 3\nEND\n", &[]);
    assert!(
        errors.contains("p.prg") && errors.contains("PTPP"),
        "{errors}"
    );
    let computed = LIFT.replace("Z = 20", "Z = 10 + 10");
    assert_eq!(
        refused(&computed, &["Z=1"]),
        "cannot vary 'Z': line 4 computes it before its first use; vary what it is computed from"
    );
    let unused = LIFT.replace("DEF_VAR Z", "DEF_VAR Z W");
    assert_eq!(
        refused(&unused, &["W=1"]),
        "cannot vary 'W': the program does not use it"
    );
}
