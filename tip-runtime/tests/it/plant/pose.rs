//! The pose of the body: rest, rise, tilt and travel.

use crate::plant::rig::{CENTIMETRE, Rig, WEIGHT, angles, close, high_bellied, stance};
use tip_runtime::model::titan8;
use tip_runtime::plant::{Floor, Scene, SimulatedPlant};

#[test]
fn at_the_start_belly_and_feet_share_the_weight() {
    let rig = Rig::new();
    let body = rig.plant.body();
    assert!(close(body.position[2], 200.0, 0.5), "{body:?}");
    assert!(close(body.roll, 0.0, 1e-9) && close(body.pitch, 0.0, 1e-9));
    let feet: f64 = rig.loads().iter().sum();
    assert!(feet > 10.0 && rig.plant.belly_load() > 10.0);
    assert!(close(feet + rig.plant.belly_load(), WEIGHT, 1e-6));
}

// clauses: 7.44
#[test]
fn feet_that_push_down_lift_the_body_and_feet_in_the_air_leave_it_on_its_belly() {
    let mut rig = Rig::standing();
    assert!(close(rig.plant.body().position[2], 250.0, 1.0));
    assert_eq!(rig.plant.belly_load(), 0.0);
    assert!(close(rig.loads().iter().sum(), WEIGHT, 1e-6));
    rig.move_to(stance(-150.0));
    assert!(close(rig.plant.body().position[2], 200.0, 1.0));
    assert_eq!(rig.loads(), [0.0; 4]);
    let belly = rig.plant.belly_load();
    assert!(close(belly, WEIGHT, 1e-6), "{belly} {:?}", rig.plant.body());
    assert_eq!(rig.plant.falls(), 0);
}

#[test]
fn a_symmetrical_stance_shares_the_weight_equally() {
    let rig = Rig::standing();
    for load in rig.loads() {
        assert!(close(load, WEIGHT / 4.0, 1e-6), "{load}");
    }
}

#[test]
fn the_body_travels_what_its_feet_sweep() {
    let mut rig = Rig::standing();
    let [x, y, z] = rig.plant.body().position;
    rig.change(|feet| feet.iter_mut().for_each(|foot| foot[1] -= 100.0));
    let body = rig.plant.body();
    // The legs give a little under the weight that moves to the front.
    assert!(close(body.position[1] - y, 100.0, 0.3), "{body:?}");
    assert!(close(body.position[0], x, 0.1) && close(body.position[2], z, 0.1));
    rig.change(|feet| feet.iter_mut().for_each(|foot| foot[0] += 30.0));
    let body = rig.plant.body();
    assert!(close(body.position[0] - x, -30.0, 0.1), "{body:?}");
    assert!(rig.plant.worst_slip() <= 1.0);
}

#[test]
fn the_body_turns_against_its_feet() {
    let mut rig = Rig::standing();
    let (sin, cos) = (libm::sin(-0.1), libm::cos(-0.1));
    rig.change(|feet| {
        for foot in feet {
            let [x, y, _] = *foot;
            (foot[0], foot[1]) = (cos * x - sin * y, sin * x + cos * y);
        }
    });
    let body = rig.plant.body();
    assert!(close(body.yaw, 0.1_f64.to_degrees(), 0.01), "{body:?}");
    assert!(close(body.position[0], 0.0, 0.1) && close(body.position[1], 0.0, 0.1));
    // Feet on a chord of the circle squeeze in between.
    assert!(rig.plant.worst_slip() <= 1.0);
}

#[test]
fn the_body_leans_towards_lower_legs() {
    let mut rig = Rig::standing();
    rig.change(|feet| {
        feet[0][2] = -260.0;
        feet[1][2] = -260.0;
    });
    let body = rig.plant.body();
    // 10 mm over 402 mm between front and rear.
    let pitch = libm::atan2(10.0, 402.0).to_degrees();
    assert!(close(body.pitch, pitch, 0.05), "{body:?}");
    assert!(close(body.roll, 0.0, 1e-6));
    assert_eq!(rig.plant.falls(), 0);
}

fn on(floor: Floor) -> Scene {
    Scene {
        floor,
        ..Scene::EMPTY
    }
}

#[test]
fn a_higher_floor_lifts_everything() {
    let floor = Floor {
        height: 30.0,
        ..Floor::LEVEL
    };
    let rig = Rig::on(SimulatedPlant::new(&titan8::MODEL).with_scene(&on(floor)));
    assert!(close(rig.plant.body().position[2], 230.0, 0.5));
    assert!(close(rig.plant.feet()[0].position[2], 30.0, 0.5));
}

#[test]
fn on_a_slope_the_body_stands_parallel_and_its_lower_feet_carry_more() {
    let floor = Floor {
        height: 0.0,
        slope: [0.0, 0.1],
    };
    let mut rig = Rig::on(SimulatedPlant::new(&titan8::MODEL).with_scene(&on(floor)));
    rig.move_to(stance(-250.0));
    let body = rig.plant.body();
    let up = libm::atan2(0.1, 1.0);
    assert!(close(body.pitch, up.to_degrees(), 0.2), "{body:?}");
    let loads = rig.loads();
    // Forces along the floor's normal.
    assert!(close(loads.iter().sum(), WEIGHT * libm::cos(up), 1e-6));
    // Moments about the middle: (rear − front) · 201 mm = W sin · height of the centre of mass.
    let [x, y, z] = rig.plant.centre_of_mass();
    let above = (z - 0.1 * y) * libm::cos(up);
    assert!(close(x, 0.0, 1e-6));
    let difference = loads[2] + loads[3] - loads[0] - loads[1];
    let expected = WEIGHT * libm::sin(up) * above / 201.0;
    assert!(
        close(difference, expected, 0.02 * expected),
        "{difference} {expected}"
    );
    rig.change(|feet| feet.iter_mut().for_each(|foot| foot[1] -= CENTIMETRE));
    let climbed = rig.plant.body();
    assert!(close(
        climbed.position[2] - body.position[2],
        CENTIMETRE * libm::sin(up),
        0.05
    ));
}

#[test]
fn motors_carry_the_weight_through_the_jacobian() {
    let model = high_bellied();
    let mut rig = Rig::on(SimulatedPlant::new(&model));
    let feet = rig.feet;
    for _ in 0..5 {
        rig.tell(&feet);
    }
    assert!(close(angles(&feet)[0][2], 90.0, 1e-9));
    let load = WEIGHT / 4.0;
    // Thigh level, shank upright below the knee: 240 mm of lever for the floor and the shank, 120
    // for the thigh's own weight.
    let thigh = (load * 240.0 - 9.80665 * (0.8 * 120.0 + 0.4 * 240.0)) / 1000.0;
    for [yaw, second, knee] in rig.plant.torques() {
        assert!(close(yaw, 0.0, 1e-6), "{yaw}");
        assert!(close(second, -thigh, 1e-2), "{second} {thigh}");
        assert!(close(knee, 0.0, 1e-2), "{knee}");
    }
}

#[test]
fn on_a_slope_to_the_side_the_lower_feet_carry_more_wherever_the_body_heads() {
    let floor = Floor {
        height: 0.0,
        slope: [0.1, 0.0],
    };
    let mut rig = Rig::on(SimulatedPlant::new(&titan8::MODEL).with_scene(&on(floor)));
    rig.move_to(stance(-250.0));
    let up = libm::atan2(0.1, 1.0);
    let [x, _, z] = rig.plant.centre_of_mass();
    let above = (z - 0.1 * x) * libm::cos(up);
    let expected = WEIGHT * libm::sin(up) * above / 391.0;
    let loads = rig.loads();
    let difference = loads[0] + loads[2] - loads[1] - loads[3];
    assert!(
        close(difference, expected, 0.02 * expected),
        "{difference} {expected}"
    );

    let level = rig.loads();
    let turn = |rig: &mut Rig, angle: f64| {
        let (sin, cos) = (libm::sin(-angle), libm::cos(-angle));
        rig.change(|feet| {
            for foot in feet {
                let [x, y, _] = *foot;
                (foot[0], foot[1]) = (cos * x - sin * y, sin * x + cos * y);
            }
        });
    };
    turn(&mut rig, 0.5);
    // The feet stay where they are in the world, by symmetry the centre of mass too: so do the
    // loads, except for the little that the legs' own height shifts.
    for (turned, level) in rig.loads().iter().zip(level) {
        assert!(close(*turned, level, 0.2), "{turned} {level}");
    }
}

#[test]
fn a_robot_at_rest_does_not_move_by_a_bit() {
    let mut rig = Rig::standing();
    let feet = rig.feet;
    for _ in 0..50 {
        rig.tell(&feet);
    }
    let (body, loads) = (rig.plant.body(), rig.loads());
    for _ in 0..50 {
        rig.tell(&feet);
    }
    assert_eq!((rig.plant.body(), rig.loads()), (body, loads));
}
