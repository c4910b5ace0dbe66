//! The foot waves three times and the robot stays where it is.

use tip_runtime::console::Transcript;
use tip_runtime::machine::Status;
use tip_runtime::program::End;
use wave::waving;

#[test]
fn the_front_right_foot_swings_three_times_and_comes_back() {
    let mut robot = waving(());
    let mut turns = Vec::new();
    let mut yaw = 0.0_f64;
    let mut rising = true;
    while robot.cycle().is_running() {
        let now = robot.sensors().angles[1][0];
        if (now - yaw).abs() > 0.5 {
            if (now > yaw) != rising {
                turns.push(yaw);
            }
            rising = now > yaw;
            yaw = now;
        }
    }
    assert_eq!(robot.status(), Status::Finished(End::End));
    // NEAR is 5 deg: each swing turns round within 5 deg of 40 and of 0.
    let crests = turns
        .iter()
        .filter(|turn| (35.0..=41.0).contains(*turn))
        .count();
    assert_eq!(crests, 3, "{turns:?}");
    let initial = [0.0, 0.0, 90.0];
    for (angle, rest) in robot.sensors().angles[1].iter().zip(initial) {
        assert!((angle - rest).abs() < 1.0, "{angle} deg, not {rest}");
    }
}

#[test]
fn the_belly_carries_the_robot_all_the_time() {
    let mut robot = waving(());
    while robot.cycle().is_running() {
        let [_, _, up] = robot.hardware().body().position;
        assert!(up < 205.0, "{up} mm up");
    }
    let [x, y, _] = robot.hardware().body().position;
    assert!(x.abs().max(y.abs()) < 5.0, "moved to ({x}, {y})");
    assert_eq!(robot.hardware().falls(), 0);
}

#[test]
fn it_says_hello_and_goodbye() {
    let mut robot = waving(Transcript::default());
    while robot.cycle().is_running() {}
    assert_eq!(robot.console().messages, ["hello", "goodbye"]);
}
