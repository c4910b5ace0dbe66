//! Vibration as the joint sensors of the hand see it.

use crate::hand_plant::rig::{Rig, close};
use tip_runtime::command::{Op, Target};
use tip_runtime::vibration::{Vibration, Waveform};

/// Returns measurements of the fingertip joint of finger `n` in a second: the number of crossings
/// of its mean, and its amplitude to either side.
fn second(rig: &mut Rig, n: usize) -> (usize, f64) {
    let angles: Vec<f64> = (0..500)
        .map(|_| {
            rig.cycle(None).expect("nothing goes wrong");
            rig.sensors().angles[n - 1][2]
        })
        .collect();
    let mean = angles.iter().sum::<f64>() / angles.len() as f64;
    let crossings = angles
        .windows(2)
        .filter(|pair| (pair[0] > mean) != (pair[1] > mean));
    let reach = angles
        .iter()
        .map(|angle| (angle - mean).abs())
        .fold(0.0, f64::max);
    (crossings.count(), reach)
}

fn vibrate(rig: &mut Rig, n: u8, frequency: f64) {
    let vibration = Vibration {
        waveform: Waveform::Sine,
        amplitude: 2.0,
        frequency,
    };
    let commanded = rig.controller.vibrate(Target::Joint(n, 3), Some(vibration));
    commanded.expect("the joint vibrates");
}

// clauses: 7.48
#[test]
fn the_sensors_see_the_frequencies_of_the_fingers() {
    let mut rig = Rig::new();
    let frequencies = [(1, 30.0), (2, 40.0), (3, 60.0)];
    for (n, frequency) in frequencies {
        vibrate(&mut rig, n, frequency);
    }
    rig.idle(0.5);
    for (n, frequency) in frequencies {
        let (crossings, reach) = second(&mut rig, usize::from(n));
        // Two in each wave; one more or less where the second begins or ends on one.
        close(crossings as f64, 2.0 * frequency, 1.0);
        // Two volts ask for one degree; the servos may lose much of it, but not all.
        assert!((0.1..2.0).contains(&reach), "{reach}");
    }
}

// clauses: 7.9 7.48
#[test]
fn a_free_finger_under_torque_vibrates_as_well() {
    let mut rig = Rig::new();
    rig.run(Op::Torque, Target::Joint(1, 3), &[0.0]);
    vibrate(&mut rig, 1, 20.0);
    rig.idle(0.5);
    let (crossings, reach) = second(&mut rig, 1);
    close(crossings as f64, 40.0, 1.0);
    assert!(reach > 0.1, "{reach}");
}
