//! The cylinder is lifted and held, alike in both engines; grasps that are wrong fail the same
//! measure.

use grasp::outcome::{HOLD, LIFT, Outcome};
use grasp::run::{height, run};
use grasp::{CYLINDER, Grasp, SCENE, SOURCE};
use tip_runtime::plant::{Object, Scene};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Interpreter, Robot, load};

fn interpreted(text: &str) -> Interpreter {
    let hand = Robot::named("hand").expect("it has that name");
    load("grasp.prg", text, &hand).expect("it loads")
}

/// The program with pieces of its text exchanged, over a scene.
fn variant(changes: &[(&str, &str)], scene: &Scene) -> Outcome {
    let mut text = SOURCE.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    run(interpreted(&text), scene, (), |_, _| {}).expect("a program for the hand")
}

#[test]
fn the_cylinder_is_lifted_and_held_alike_in_both_engines() {
    let mut weight_carried = 0.0;
    let compiled = run(Grasp::new(), &SCENE, (), |time, hand| {
        // In the middle of the hold the fingers carry all of the cylinder's weight.
        if (6.999..7.002).contains(&time) {
            let up = |tip: &tip_runtime::plant::Fingertip| tip.on_objects[1];
            weight_carried = hand.fingertips().iter().map(up).sum();
            assert!(height(hand) >= LIFT);
        }
    });
    let compiled = compiled.expect("a program for the hand");
    assert!(compiled.is_good(), "{compiled}");
    assert_eq!(compiled.ending, Ending::Program(End::Exit));
    assert!(compiled.lift >= LIFT && compiled.held >= HOLD, "{compiled}");
    let weight = CYLINDER.mass * 9.80665;
    assert!(
        (weight_carried / weight - 1.0).abs() < 0.1,
        "{weight_carried} N"
    );
    let rival = run(interpreted(SOURCE), &SCENE, (), |_, _| {}).expect("a program for the hand");
    assert!(compiled.trace == rival.trace, "the traces differ");
    assert!(compiled.trace.contains("\"say\":\"The floor is at -155."));
    assert_eq!(compiled.trace.matches("\"say\":\"It feels (").count(), 3);
}

#[test]
fn a_loose_grasp_does_not_hold() {
    // 3 mm instead of 8: friction of 0.8 × 2.4 N bears 1.9 N of 2 N and more when it is jerked.
    let loose = variant(
        &[(" F1 8 0 0", " F1 3 0 0"), (" -8 0 0", " -3 0 0")],
        &SCENE,
    );
    assert!(!loose.is_good(), "{loose}");
}

#[test]
fn a_slippery_cylinder_is_not_lifted() {
    let mut scene = SCENE;
    scene.objects[0] = Some(Object {
        friction: 0.2,
        ..CYLINDER
    });
    let slipped = variant(&[], &scene);
    assert!(!slipped.is_good() && slipped.lift < LIFT, "{slipped}");
}

#[test]
fn without_a_cylinder_nothing_is_held() {
    let nothing = variant(&[], &Scene::EMPTY);
    assert!(!nothing.is_good(), "{nothing}");
}

#[test]
fn a_shorter_lift_is_too_low() {
    let low = variant(&[(" 0 42 0", " 0 25 0"), (" 0 -42 0", " 0 -25 0")], &SCENE);
    assert_eq!(low.ending, Ending::Program(End::Exit));
    assert!(low.lift > 15.0 && low.lift < LIFT, "{low}");
    assert!(!low.is_good());
}

#[test]
fn a_closed_output_is_an_error_and_no_panic() {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let outcome = std::process::Command::new(env!("CARGO_BIN_EXE_grasp"))
        .stdout(writer)
        .output()
        .expect("it starts");
    assert_eq!(outcome.status.code(), Some(1));
    let told = String::from_utf8_lossy(&outcome.stderr);
    assert!(
        told.starts_with("grasp: ") && !told.contains("panicked"),
        "{told}"
    );
}
