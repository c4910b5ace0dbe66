//! Axes: their text forms, their names, and what is refused.

use crate::{LIFT, refused, spec, sweep};
use tip_sweep::{Axis, Spec, Sweep, Values};

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
    for wrong in [
        "A",
        "=3",
        "A=",
        "A=x",
        "A=1..x",
        "A=1..2/x",
        "A=uniform(1)",
        "A=normal(1,x)",
    ] {
        assert!(wrong.parse::<Axis>().is_err(), "{wrong}");
    }
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
    assert_eq!(refused(LIFT, &["Z=10..30/0"]), empty);
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
fn unknown_quantities_are_refused_with_the_nearest_one() {
    let program = LIFT.replace('Z', "HEIGHT");
    assert!(refused(&program, &["HIEGHT=1,2"]).ends_with("; did you mean HEIGHT?"));
    assert!(refused(&program, &["fricton=1,2"]).ends_with("; did you mean friction?"));
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
    assert!(
        sweep(LIFT, &["scene.floor.slope.1=0,0.1"]).is_err(),
        "a level floor has no slope to vary"
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
    assert!(with(slope, "scene.floor.slope.3=0").is_err());
    assert!(with(slope, "scene.floor.frictio=1").is_err());
    assert!(with(slope, "friction=-1").is_err());
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
