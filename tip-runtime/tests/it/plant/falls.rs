//! Falls and slips of wrong gaits.

use crate::plant::rig::{Rig, close, stance};

/// Shifts the body so that a foot can be lifted: moves all feet the other way.
fn shift(rig: &mut Rig, x: f64, y: f64) {
    rig.change(|feet| {
        for foot in feet {
            foot[0] -= x;
            foot[1] -= y;
        }
    });
}

#[test]
fn a_foot_may_be_lifted_once_the_body_has_been_shifted_away_from_it() {
    let mut rig = Rig::standing();
    shift(&mut rig, 40.0, -40.0);
    rig.change(|feet| feet[0][2] += 50.0);
    assert_eq!(rig.plant.falls(), 0);
    assert!(rig.plant.margin() > 20.0);
    let feet = rig.plant.feet();
    assert!(!feet[0].touches() && feet[1..].iter().all(|foot| foot.touches()));
    assert!(close(feet[0].position[2], 50.0, 3.0));
    assert!(close(rig.plant.body().position[2], 250.0, 1.5));
}

#[test]
fn a_foot_lifted_under_the_centre_of_mass_is_a_fall() {
    let mut rig = Rig::standing();
    shift(&mut rig, -40.0, 40.0);
    assert_eq!(rig.plant.falls(), 0);
    rig.change(|feet| feet[0][2] += 50.0);
    assert_eq!(rig.plant.falls(), 1);
    assert!(rig.plant.margin() < 0.0);
}

#[test]
fn two_adjacent_feet_lifted_are_a_fall() {
    for pair in [[0, 1], [0, 2], [1, 3], [2, 3]] {
        let mut rig = Rig::standing();
        assert_eq!(rig.plant.falls(), 0);
        rig.change(|feet| pair.iter().for_each(|leg| feet[*leg][2] += 50.0));
        assert_eq!(rig.plant.falls(), 1, "{pair:?}");
        let fall = rig.plant.first_fall().expect("a fall");
        assert!(fall.margin < -100.0 && fall.cycle > 0);
    }
}

#[test]
fn a_fall_is_counted_when_it_begins_and_again_after_standing_up() {
    let mut rig = Rig::standing();
    for _ in 0..2 {
        rig.change(|feet| {
            feet[0][2] += 50.0;
            feet[1][2] += 50.0;
        });
        rig.move_to(stance(-250.0));
    }
    assert_eq!(rig.plant.falls(), 2);
}

#[test]
fn lying_down_is_no_fall() {
    let mut rig = Rig::standing();
    rig.move_to(stance(-200.0));
    rig.change(|feet| {
        feet[0][2] += 80.0;
        feet[1][2] += 80.0;
    });
    assert_eq!(rig.plant.falls(), 0);
    assert!(rig.plant.belly_load() > 0.0);
}

#[test]
fn a_reversed_sweep_of_one_foot_slips() {
    let mut rig = Rig::standing();
    rig.change(|feet| {
        for foot in feet.iter_mut() {
            foot[1] -= 50.0;
        }
        feet[2][1] += 100.0;
    });
    assert!(rig.plant.worst_slip() > 20.0, "{}", rig.plant.worst_slip());
    assert!(rig.plant.body().position[1] < 45.0);
    let slips = rig.plant.feet().map(|foot| foot.slip);
    assert!(slips.iter().all(|slip| slips[2] >= *slip), "{slips:?}");
}

#[test]
fn a_foot_in_the_air_slips_nowhere() {
    let mut rig = Rig::standing();
    shift(&mut rig, 40.0, -40.0);
    rig.change(|feet| feet[0][2] += 50.0);
    rig.change(|feet| feet[0][1] += 100.0);
    rig.change(|feet| feet[0][2] -= 50.0);
    assert!(rig.plant.feet()[0].touches());
    assert!(rig.plant.worst_slip() <= 1.0, "{}", rig.plant.worst_slip());
}

#[test]
fn a_foot_that_carries_little_slips_and_leaves_the_body_where_it_is() {
    let mut rig = Rig::standing();
    shift(&mut rig, 40.0, -40.0);
    // Almost lifted: the other three hold the body.
    rig.change(|feet| feet[0][2] += 0.6);
    let (before, load) = (rig.plant.body(), rig.loads()[0]);
    assert!(load > 0.0 && load < 10.0, "{load}");
    rig.change(|feet| feet[0][1] += 20.0);
    assert!(close(rig.plant.body().position[1], before.position[1], 1.0));
    assert!(rig.plant.feet()[0].slip > 18.0);
}
