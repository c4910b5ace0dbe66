//! The body rises and sinks three times, ten millimetres higher each time.

use build_script::pushing_up;
use tip_runtime::console::{Scripted, Transcript};
use tip_runtime::machine::Status;
use tip_runtime::program::End;

/// Height of the body's centre while the belly rests on the floor, mm.
const RESTING: f64 = 200.0;

#[test]
fn three_push_ups_reach_40_50_and_60_mm() {
    let mut robot = pushing_up(());
    let mut heights = Vec::new();
    while robot.cycle().is_running() {
        heights.push(robot.hardware().body().position[2] - RESTING);
    }
    assert_eq!(robot.status(), Status::Finished(End::End));
    assert_eq!(robot.hardware().falls(), 0);
    let raised = heights
        .chunk_by(|a, b| (*a > 20.0) == (*b > 20.0))
        .filter(|run| run[0] > 20.0);
    let tops: Vec<f64> = raised
        .map(|run| run.iter().copied().fold(0.0, f64::max))
        .collect();
    assert_eq!(tops.len(), 3, "{tops:?}");
    for (top, asked) in tops.iter().zip([40.0, 50.0, 60.0]) {
        assert!((top - asked).abs() < 3.0, "{top} mm, not {asked}");
    }
    assert!(heights.last().is_some_and(|height| height.abs() < 3.0));
}

#[test]
fn a_halt_request_ends_it_after_the_push_up_at_hand() {
    let mut robot = pushing_up(Scripted::new(Vec::new()).halt(10));
    while robot.cycle().is_running() {}
    let shown: &Transcript = robot.console().inner();
    assert_eq!(shown.messages, ["push-up 1: 40 mm", "done"]);
}
