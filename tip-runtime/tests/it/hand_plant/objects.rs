//! Objects on the floor, alone.

use crate::hand_plant::rig::{close, cycles, held, object, outputs, over, write};
use tip_runtime::plant::{Floor, Object, Scene, SceneError, Shape};

const G: f64 = 9.80665;

const DISC: Object = Object {
    shape: Shape::Disc { radius: 20.0 },
    mass: 0.05,
    friction: 0.5,
    x: 0.0,
    y: None,
    angle: 0.0,
};

const BOX: Object = Object {
    shape: Shape::Box {
        width: 40.0,
        height: 30.0,
    },
    ..DISC
};

fn with(objects: &[Object]) -> Scene {
    objects.iter().fold(Scene::EMPTY, |scene, object| {
        scene.with_object(*object).expect("a good object")
    })
}

/// Returns a scene with a floor that rises to the right.
fn on_slope(rise: f64, object: Object) -> Scene {
    Scene {
        floor: Floor {
            height: 0.0,
            slope: [rise, 0.0],
        },
        ..with(&[object])
    }
}

#[test]
fn objects_stand_on_the_floor_by_themselves() {
    for (thing, height) in [(DISC, 20.0), (BOX, 15.0)] {
        let mut plant = over(&with(&[thing]));
        close(object(&plant).position[1], -130.0 + height, 1e-9);
        write(&mut plant, &outputs(held()), cycles(0.5));
        // 0.49 N on one contact of 5 N/mm, or two.
        let state = object(&plant);
        let contacts = if thing == BOX { 2.0 } else { 1.0 };
        close(state.clearance, -0.05 * G / 5.0 / contacts, 1e-4);
        close(state.position[0], 0.0, 1e-9);
        close(state.velocity[1], 0.0, 1e-6);
        assert!(state.on_floor && !state.at_palm);
    }
}

#[test]
fn a_box_that_falls_comes_to_rest_flat() {
    let falling = Object {
        y: Some(-90.0),
        angle: 20.0,
        ..BOX
    };
    let mut plant = over(&with(&[falling]));
    let mut deepest = 0.0_f64;
    for _ in 0..cycles(2.0) {
        write(&mut plant, &outputs(held()), 1);
        deepest = deepest.min(object(&plant).clearance);
    }
    let state = object(&plant);
    close(state.angle, 0.0, 1e-3);
    close(state.position[1], -115.0, 0.06);
    close(state.spin, 0.0, 1e-3);
    // All of the fall's energy in one spring: k d²/2 = m g h, h less than 25 mm.
    assert!(
        deepest > -(2.0 * 0.05 * G * 25.0 / 5.0_f64).sqrt(),
        "{deepest}"
    );
}

#[test]
fn a_box_slides_down_a_slope_as_friction_lets_it() {
    let tilted = |slope: f64| Object {
        angle: slope.atan().to_degrees(),
        friction: 0.3,
        ..BOX
    };
    // Friction of 0.3 holds it on a slope of 0.25.
    let mut plant = over(&on_slope(0.25, tilted(0.25)));
    write(&mut plant, &outputs(held()), cycles(0.5));
    let settled = object(&plant).position;
    write(&mut plant, &outputs(held()), cycles(1.0));
    close(object(&plant).position[0], settled[0], 1e-4);
    // On 0.5 it goes with g (sin a − 0.3 cos a).
    let mut plant = over(&on_slope(0.5, tilted(0.5)));
    write(&mut plant, &outputs(held()), cycles(0.1));
    let before = object(&plant).velocity;
    write(&mut plant, &outputs(held()), cycles(0.1));
    let after = object(&plant).velocity;
    let gained = (after[0] - before[0]).hypot(after[1] - before[1]) / 1000.0 / 0.1;
    let angle = 0.5_f64.atan();
    close(gained / (G * (angle.sin() - 0.3 * angle.cos())), 1.0, 0.01);
}

#[test]
fn a_disc_rolls_down_a_slope_and_slides_where_friction_is_small() {
    for (friction, slides) in [(0.5, false), (0.05, true)] {
        let disc = Object { friction, ..DISC };
        let mut plant = over(&on_slope(0.3, disc));
        write(&mut plant, &outputs(held()), cycles(0.1));
        let before = object(&plant);
        write(&mut plant, &outputs(held()), cycles(0.1));
        let after = object(&plant);
        let speed = |velocity: [f64; 3]| velocity[0].hypot(velocity[1]) / 1000.0;
        let gained = (speed(after.velocity) - speed(before.velocity)) / 0.1;
        let spun = (after.spin - before.spin).to_radians() / 0.1;
        let angle = 0.3_f64.atan();
        // Rolling: two thirds of g sin a, which needs friction of tan a / 3. Sliding: friction μ m g
        // cos a turns it against m r²/2.
        let (expected, turning) = if slides {
            let drag = G * friction * angle.cos();
            (G * angle.sin() - drag, 2.0 * drag / 0.02)
        } else {
            let rolling = G * angle.sin() * 2.0 / 3.0;
            (rolling, rolling / 0.02)
        };
        close(gained / expected, 1.0, 0.01);
        // Downhill is to the left, which is a turn from x to y.
        close(spun / turning, 1.0, 0.01);
    }
}

#[test]
fn objects_rest_on_each_other() {
    let above = |object: Object, y: f64| Object {
        y: Some(y),
        ..object
    };
    for scene in [
        with(&[BOX, above(BOX, -85.0)]),
        with(&[above(BOX, -85.0), BOX]),
        with(&[BOX, above(DISC, -80.0)]),
        with(&[above(DISC, -80.0), BOX]),
    ] {
        let mut plant = over(&scene);
        let before = plant.objects();
        write(&mut plant, &outputs(held()), cycles(1.0));
        for (now, before) in plant.objects().iter().zip(before).take(2) {
            let (now, before) = (now.expect("an object"), before.expect("an object"));
            close(now.position[1], before.position[1], 0.3);
            close(now.position[0], before.position[0], 0.01);
            close(now.velocity[1], 0.0, 0.01);
        }
    }
    // Discs side by side push each other apart.
    let mut plant = over(&with(&[DISC, Object { x: 39.0, ..DISC }]));
    write(&mut plant, &outputs(held()), cycles(0.1));
    let [first, second, ..] = plant
        .objects()
        .map(|object| object.map(|object| object.position));
    assert!(second.expect("an object")[0] - first.expect("an object")[0] > 40.0);
}

#[test]
fn energy_is_never_gained() {
    let falling = Object {
        y: Some(-80.0),
        angle: 30.0,
        ..BOX
    };
    let mut plant = over(&with(&[falling]));
    let inertia = 0.05 * (0.04_f64.powi(2) + 0.03_f64.powi(2)) / 12.0;
    let mut least = f64::INFINITY;
    for _ in 0..cycles(1.5) {
        write(&mut plant, &outputs(held()), 1);
        let state = object(&plant);
        let [x, y, _] = state.velocity.map(|velocity| velocity / 1000.0);
        let spin = state.spin.to_radians();
        let motion = 0.05 * (x * x + y * y) / 2.0 + inertia * spin * spin / 2.0;
        let height = 0.05 * G * (state.position[1] + 130.0) / 1000.0;
        // What contacts store is not counted: a little comes back as they let go.
        let total = motion + height;
        assert!(total < least + 2e-4, "{total} after {least}");
        if !state.on_floor {
            least = least.min(total);
        }
    }
}

#[test]
fn what_cannot_be_simulated_is_refused() {
    let refused = |object: Object| Scene::EMPTY.with_object(object).expect_err("it is bad");
    let small = Shape::Disc { radius: 1.0 };
    assert_eq!(
        refused(Object {
            shape: small,
            ..BOX
        }),
        SceneError::Size
    );
    let endless = Shape::Box {
        width: 40.0,
        height: f64::INFINITY,
    };
    assert_eq!(
        refused(Object {
            shape: endless,
            ..BOX
        }),
        SceneError::Size
    );
    assert_eq!(
        refused(Object {
            mass: 0.0009,
            ..BOX
        }),
        SceneError::Mass
    );
    assert_eq!(
        refused(Object {
            friction: -0.1,
            ..BOX
        }),
        SceneError::Friction
    );
    assert_eq!(refused(Object { x: f64::NAN, ..BOX }), SceneError::Place);
    let full = with(&[BOX; 4]).with_object(BOX);
    assert_eq!(full, Err(SceneError::Full));
}
