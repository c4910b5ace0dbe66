//! Figures of a run on the motion of its robot, against closed forms.

use std::error::Error;
use tip_runtime::plant::{DynamicPlant, Object, Scene, Shape, Simulation};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Limit, Plant, Robot, Run, load};

type Outcome = Result<(), Box<dyn Error>>;

/// Standard gravity, m/s².
const G: f64 = 9.80665;
const STAND: &str = "STAND_UP 60\nWAIT_INPOS ALL\nSLEEP 500\n";

fn on(robot: Robot, text: &str) -> Result<Run, Box<dyn Error>> {
    let program = load("p.prg", text, &robot)?;
    Ok(Run::new(program, robot)?)
}

fn titan8(statements: &str) -> Result<Run, Box<dyn Error>> {
    let text = format!("3.1\nt\n{statements}END\n");
    on(Robot::named("titan8")?, &text)
}

fn close(left: f64, right: f64, tolerance: f64) {
    assert!((left - right).abs() <= tolerance, "{left} is not {right}");
}

#[test]
fn a_walk_travels_from_where_it_began_to_where_it_is() -> Outcome {
    let walk = include_str!("../../../../examples/walk/motions/walk.prg");
    let mut run = on(Robot::named("titan8")?, walk)?;
    let began = run.motion().expect("it walks").pose;
    run.to_end(Limit::NONE);
    let motion = run.motion().expect("it walks");
    let (travel, pose) = (motion.travel, motion.pose);
    close(travel.x, pose.position[0] - began.position[0], 1e-9);
    close(travel.y, pose.position[1] - began.position[1], 1e-9);
    close(travel.z, pose.position[2] - began.position[2], 1e-9);
    close(travel.turn, pose.yaw - began.yaw, 0.1);
    // Six strides of 200 mm, and it sits down as it sat.
    close(travel.y, 1200.0, 15.0);
    close(travel.z, 0.0, 2.0);
    assert_eq!((motion.falls, run.first_fall()), (0, None));
    assert!(motion.least_margin > 0.0 && motion.least_margin <= motion.margin);
    Ok(())
}

#[test]
fn a_walk_with_mass_goes_as_far_and_does_not_fall() -> Outcome {
    let walk = include_str!("../../../../examples/walk/motions/walk.prg");
    let mut run = on(Robot::named("titan8")?.with_plant(Plant::Dynamic), walk)?;
    assert_eq!(run.to_end(Limit::NONE), Ending::Program(End::Exit));
    let motion = run.motion().expect("it walks");
    // Six strides of 200 mm.
    close(motion.travel.y, 1200.0, 15.0);
    close(motion.travel.x, 0.0, 10.0);
    close(motion.travel.turn, 0.0, 1.0);
    assert_eq!((motion.falls, run.first_fall()), (0, None));
    assert!(motion.slip < 5.0, "{motion:?}");
    Ok(())
}

#[test]
fn a_trot_that_might_topple_falls_on_neither_plant() -> Outcome {
    let trot = include_str!("../../../../tests/external/mujoco/trot.prg");
    let mut motions = Vec::new();
    for plant in [Plant::Simulated, Plant::Dynamic] {
        let mut run = on(Robot::named("titan8")?.with_plant(plant), trot)?;
        assert_eq!(run.to_end(Limit::NONE), Ending::Program(End::Exit));
        let motion = run.motion().expect("it walks");
        assert_eq!((motion.falls, run.first_fall()), (0, None));
        // 17 strokes of 40 mm; on two feet it leans, and feet slide: MuJoCo's go 525 mm with friction 0.9.
        let strokes = 17.0 * 40.0;
        assert!((500.0..strokes).contains(&motion.travel.y), "{motion:?}");
        close(motion.travel.turn, 0.0, 10.0);
        motions.push(motion);
    }
    let unmodelled = motions[0].unmodelled.expect("it has no mass");
    assert!(unmodelled.tips > 0, "{unmodelled:?}");
    // On two feet the centre of mass is beside the line between them.
    assert!(motions[1].least_margin < 0.0, "{:?}", motions[1]);
    Ok(())
}

#[test]
fn a_leg_presses_by_its_force_or_its_spring_and_by_its_weight() -> Outcome {
    // The robot lies on its belly, a shank upright: its foot carries the shank and half of the thigh besides.
    let own = (0.4 + 0.4) * G;
    for (commands, force) in [
        ("FORCE F1 0 0 -20", 20.0),
        ("FORCE F1 0 0 -20\nSLEEP 500\nFORCE F1 0 0 R -25", 45.0),
        ("COMPLIANCE_POSITION F1 R 0 R 0 R -30", 30.0),
        (
            "SET_POSITION_STIFFNESS F1 2 2 2\nCOMPLIANCE_POSITION F1 R 0 R 0 R -15",
            30.0,
        ),
        (
            "COMPLIANCE_POSITION F1 R 0 R 0 R -30\nSLEEP 500\nNO_COMPLIANCE F1\nFORCE F1 0 0 -10",
            10.0,
        ),
    ] {
        let generic = Robot::named("generic")?.with_plant(Plant::Dynamic);
        let text = format!("3.1\nt\n{commands}\nSLEEP 9000\nEND\n");
        let mut run = on(generic, &text)?;
        // Before END, which holds every joint by angle.
        assert_eq!(run.to_end(Limit::cycles(150)), Ending::Limit);
        let load = run.limbs().expect("legs").loads[0];
        assert!((load - force - own).abs() < 0.5, "{text}: {load} N");
    }
    Ok(())
}

#[test]
fn a_scene_chooses_the_plant_unless_the_robot_does() -> Outcome {
    let mut scene = Scene::EMPTY;
    scene.plant = Some(Simulation::Dynamic);
    let by_scene = Robot::named("titan8")?.with_scene(&scene)?;
    scene.plant = Some(Simulation::QuasiStatic);
    let by_name = Robot::named("titan8")?.with_plant(Plant::Dynamic);
    let by_name = by_name.with_scene(&scene)?;
    let motion = |robot| {
        let mut run = on(robot, &format!("3.1\nt\n{STAND}END\n"))?;
        run.to_end(Limit::NONE);
        let has_mass = run.plant::<DynamicPlant<4, 3>>().is_some();
        Ok::<_, Box<dyn Error>>((run.motion(), has_mass))
    };
    let (one, other) = (motion(by_scene)?, motion(by_name)?);
    assert!(one.1 && other.1);
    assert_eq!(one, other, "equal bits");
    let (_, has_mass) = motion(Robot::named("titan8")?.with_scene(&scene)?)?;
    assert!(!has_mass);
    Ok(())
}

#[test]
fn events_of_mass_are_refused_where_there_is_none() -> Outcome {
    for event in ["3:push 1 2 3 for 4", "3:noise 0.1 0 seed 1"] {
        let refused = titan8("")?.events(event).expect_err("it has no mass");
        let reported = refused.to_string();
        assert!(
            reported.ends_with("is for walking robots with mass: --plant dynamic"),
            "{reported}"
        );
        let robot = Robot::named("titan8")?.with_plant(Plant::Dynamic);
        on(robot, "3.1\nt\nEND\n")?.events(event)?;
    }
    Ok(())
}

#[test]
fn a_turn_on_the_spot_is_a_turn_and_no_travel() -> Outcome {
    // Each foot goes 10 degrees round the centre, clockwise: the body turns to the left by as much.
    let turned = |x: f64, y: f64| {
        let (sin, cos) = 10.0_f64.to_radians().sin_cos();
        (x * cos + y * sin, y * cos - x * sin)
    };
    let feet = Robot::named("titan8")?.description().feet;
    let mut text = format!("{STAND}ALL_STOP\n");
    for (leg, [x, y, _]) in (1..).zip(feet) {
        let (to_x, to_y) = turned(x, y);
        text += &format!("REL_PTP F{leg} {:.3} {:.3} 0\n", to_x - x, to_y - y);
    }
    text += "ALL_STOP_RELEASE\nWAIT_INPOS ALL\nSLEEP 500\n";
    let mut run = titan8(&text)?;
    run.to_end(Limit::NONE);
    let motion = run.motion().expect("it walks");
    close(motion.travel.turn, 10.0, 0.2);
    close(motion.pose.yaw, 10.0, 0.2);
    close(motion.travel.x, 0.0, 1.0);
    close(motion.travel.y, 0.0, 1.0);
    Ok(())
}

#[test]
fn the_feet_of_a_standing_robot_carry_its_weight_and_its_margin_is_that_of_its_feet() -> Outcome {
    let mut run = titan8(STAND)?;
    assert_eq!(run.limbs().expect("legs").angles.len(), 4);
    run.to_end(Limit::NONE);
    let limbs = run.limbs().expect("legs");
    // 20 kg.
    close(limbs.loads.iter().sum(), 20.0 * G, 0.1);
    assert!(limbs.angles.iter().all(|leg| leg.len() == 3));
    // The centre of mass is in the middle: the sides of the rectangle are as far as the feet.
    let feet = Robot::named("titan8")?.description().feet;
    let nearest = |axis: usize| {
        feet.iter()
            .map(|foot| foot[axis].abs())
            .fold(f64::MAX, f64::min)
    };
    let motion = run.motion().expect("it walks");
    close(motion.margin, nearest(0).min(nearest(1)), 1.0);
    assert!(motion.least_margin <= motion.margin && motion.least_margin > 100.0);
    assert!(motion.slip < 1.0 && motion.falls == 0);
    Ok(())
}

#[test]
fn two_feet_lifted_are_a_fall_in_the_cycle_and_step_of_the_lift() -> Outcome {
    // Steps 0 to 2 stand up; 3 lifts one foot, 4 the other, 5 waits for them.
    let mut run = titan8(&format!(
        "{STAND}REL_PTP F1 0 0 60\nREL_PTP F2 0 0 60\nWAIT_INPOS ALL\nSLEEP 200\n"
    ))?;
    let mut mark = run.snapshot();
    while run.first_fall().is_none() {
        mark = run.snapshot();
        run.cycle();
    }
    let fall = run.first_fall().expect("it fell");
    assert_eq!(fall.cycle + 1, run.cycles());
    close(fall.time, 20.0 * fall.cycle as f64, 1e-6);
    assert_eq!(fall.step, 5);
    assert!(fall.margin < 0.0);
    run.to_end(Limit::NONE);
    let motion = run.motion().expect("it walks");
    assert_eq!((motion.falls, run.first_fall()), (1, Some(fall)));
    // The hind feet alone carry it: the centre is in front of them.
    assert!(motion.least_margin < -1.0);
    run.restore(&mark);
    assert_eq!(run.first_fall(), None);
    assert_eq!(
        run.to_end(Limit::NONE),
        Ending::Program(tip_runtime::program::End::End)
    );
    assert_eq!(run.first_fall(), Some(fall));
    Ok(())
}

#[test]
fn what_does_not_walk_or_is_not_a_hand_says_nothing_about_it() -> Outcome {
    let bolted = "name = \"bolted\"\njoint = [{ axis = \"y\", link = [0, 0, -100], limits = [-90, 90] }]\n\
                  leg = [{ base = [0, 0, 0] }]\n";
    let mut run = on(
        Robot::from_description(bolted)?,
        "3.1\nt\nPTP_ANGLE J11 5\nSLEEP 200\nEND\n",
    )?;
    run.to_end(Limit::NONE);
    assert_eq!(
        (run.motion(), run.first_fall(), run.grasp()),
        (None, None, None)
    );
    let limbs = run.limbs().expect("a leg");
    assert_eq!((limbs.loads, limbs.angles.len()), (vec![], 1));
    let echo = Robot::named("titan8")?.with_plant(Plant::Echo);
    let mut run = on(echo, "3.1\nt\nEND\n")?;
    run.to_end(Limit::NONE);
    assert_eq!((run.motion(), run.limbs(), run.grasp()), (None, None, None));
    let hand = on(Robot::named("hand")?, "3.1\nt\nEND\n")?;
    assert_eq!((hand.motion(), hand.first_fall()), (None, None));
    assert_eq!(hand.grasp().map(|grasp| grasp.objects), Some(vec![]));
    Ok(())
}

#[test]
fn fingertips_that_hold_an_object_in_the_air_push_it_up_by_its_weight() -> Outcome {
    let cylinder = Object {
        shape: Shape::Box {
            width: 100.0,
            height: 60.0,
        },
        mass: 0.2,
        friction: 0.8,
        x: 0.0,
        y: None,
        angle: 0.0,
    };
    let hand = Robot::named("hand")?.with_scene(&Scene::EMPTY.with_object(cylinder)?)?;
    let mut run = on(
        hand,
        include_str!("../../../../examples/grasp/motions/grasp.prg"),
    )?;
    while run.cycle().messages != ["Lifted."] {
        assert_eq!(run.ending(), None);
    }
    let grasp = run.grasp().expect("a hand");
    let held = grasp.objects[0];
    assert!(held.clearance > 25.0 && held.highest >= held.clearance);
    let up: f64 = grasp.fingertips.iter().map(|tip| tip.on_objects[1]).sum();
    close(up, 0.2 * G, 0.05);
    for (tip, load) in grasp
        .fingertips
        .iter()
        .zip(run.limbs().expect("fingers").loads)
    {
        close(load, tip.on_objects[0].hypot(tip.on_objects[1]), 1e-12);
        assert!(tip.greatest >= load);
    }
    run.to_end(Limit::NONE);
    let released = run.grasp().expect("a hand");
    close(released.objects[0].clearance, 0.0, 0.5);
    assert!(released.objects[0].highest >= held.highest);
    assert!(
        released
            .fingertips
            .iter()
            .all(|tip| tip.force() == 0.0 && tip.greatest > 0.5)
    );
    Ok(())
}

/// Both front and both rear legs of a side turn towards each other, until their thighs would cross.
const CROSSING: &str = "PTP_ANGLE J11 -55\nPTP_ANGLE J31 55\nSLEEP 3000\n";

#[test]
fn legs_that_meet_are_reported_in_both_plants() -> Outcome {
    for plant in [Plant::Simulated, Plant::Dynamic] {
        let robot = Robot::named("titan8")?.with_plant(plant);
        let mut run = on(robot, &format!("3.1\nt\n{CROSSING}END\n"))?;
        run.to_end(Limit::NONE);
        let clearance = run.clearance().expect("its links are compared");
        let first = run.first_collision().expect("thighs meet");
        let nearest = run.nearest_approach().expect("it ran");
        assert!(clearance.collisions > 0, "{plant:?}: {clearance:?}");
        assert!(first.gap.distance < 0.0 && nearest.gap.distance <= first.gap.distance);
        assert_eq!(nearest.gap.parts, clearance.least.parts, "{plant:?}");
        assert_eq!(nearest.cycle, clearance.cycle, "{plant:?}");
        let links = first.gap.parts.map(|part| part.to_string());
        assert!(
            links[0].starts_with("link3") && links[1].starts_with("link1"),
            "{links:?}"
        );
        assert_eq!(run.program().line(first.step), 5, "they meet in SLEEP");
        // What is reported survives a restore.
        let mark = run.snapshot();
        run.restore(&mark);
        assert_eq!(run.first_collision(), Some(first));
    }
    // By 20 degrees they stay apart.
    let mut run = titan8("PTP_ANGLE J11 -20\nPTP_ANGLE J31 20\nSLEEP 3000\n")?;
    run.to_end(Limit::NONE);
    assert_eq!(run.first_collision(), None);
    assert!(
        run.clearance()
            .is_some_and(|clearance| clearance.collisions == 0)
    );
    Ok(())
}

#[test]
fn no_example_collides() -> Outcome {
    macro_rules! example {
        ($path:literal) => {
            include_str!(concat!("../../../../examples/", $path))
        };
    }
    // The stick of a gait is ahead, turned, and to the side.
    let steer =
        "0:VR1=5, 0:VR2=5, 0:VR3=5, 200..500:VR1=10, 500..800:VR2=10, 800..1100:VR3=10, 1200:halt";
    let programs = [
        ("titan8", example!("walk/motions/walk.prg"), ""),
        ("hand", example!("grasp/motions/grasp.prg"), ""),
        ("titan8", example!("published/crawl-titan8.prg"), steer),
        ("solo12", example!("published/trot-solo12.prg"), steer),
        ("spotmicro", example!("published/trot-spotmicro.prg"), steer),
        ("a1", example!("published/trot-a1.prg"), steer),
        ("phantomx", example!("published/tripod.prg"), steer),
        ("trifinger", example!("published/fingertips.prg"), ""),
    ];
    for (name, program, events) in programs {
        for plant in [Plant::Simulated, Plant::Dynamic] {
            let run = on(Robot::named(name)?.with_plant(plant), program)?;
            let mut run = run.events(events)?;
            run.to_end(Limit::cycles(3000));
            let clearance = run.clearance().expect("its parts are compared");
            assert_eq!(clearance.collisions, 0, "{name} {plant:?}: {clearance:?}");
        }
    }
    Ok(())
}
