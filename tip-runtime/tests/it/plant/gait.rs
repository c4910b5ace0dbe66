//! A crawl: one foot in the air at a time, the body shifted over the other three before.

use crate::plant::rig::{Rig, close};

const STRIDE: f64 = 80.0;
const SHIFT: [f64; 2] = [45.0, 60.0];

/// A flaw of a gait.
#[derive(Clone, Copy, PartialEq)]
enum Flaw {
    None,
    /// Foot 3 sweeps the wrong way.
    ReversedSweep,
    /// Feet 1 and 3 are lifted at the same time.
    AdjacentLift,
}

/// Moves the body by moving all feet on the floor the other way.
fn sway(rig: &mut Rig, x: f64, y: f64, flaw: Flaw) {
    rig.change(|feet| {
        for (leg, foot) in feet.iter_mut().enumerate() {
            let reversed = flaw == Flaw::ReversedSweep && leg == 2;
            foot[0] -= x;
            foot[1] -= if reversed { -y } else { y };
        }
    });
}

fn lift(rig: &mut Rig, leg: usize, height: f64, flaw: Flaw) {
    rig.change(|feet| {
        feet[leg][2] += height;
        if flaw == Flaw::AdjacentLift && leg == 0 {
            feet[2][2] += height;
        }
    });
}

/// Runs one cycle of the gait: every foot takes a step of [`STRIDE`], and the body follows by as
/// much.
fn crawl(rig: &mut Rig, flaw: Flaw) {
    for (leg, [side, end]) in [
        (2, [-1.0, -1.0]),
        (0, [-1.0, 1.0]),
        (3, [1.0, -1.0]),
        (1, [1.0, 1.0]),
    ] {
        let [x, y] = [-side * SHIFT[0], -end * SHIFT[1]];
        sway(rig, x, y, Flaw::None);
        lift(rig, leg, 50.0, flaw);
        rig.change(|feet| feet[leg][1] += STRIDE);
        lift(rig, leg, -50.0, flaw);
        sway(rig, -x, -y, Flaw::None);
    }
    sway(rig, 0.0, STRIDE, flaw);
}

#[test]
fn the_body_travels_one_stride_with_each_cycle_of_a_crawl_whatever_the_period() {
    for period in [20.0, 1.0] {
        travels(period);
    }
}

fn travels(period: f64) {
    let mut rig = Rig::standing();
    rig.period = period;
    for cycle in 1..=3 {
        crawl(&mut rig, Flaw::None);
        let body = rig.plant.body();
        assert!(
            close(body.position[1], f64::from(cycle) * STRIDE, 1.0),
            "{body:?}"
        );
        assert!(
            close(body.position[0], 0.0, 1.0) && close(body.yaw, 0.0, 0.3),
            "{body:?}"
        );
    }
    assert_eq!(rig.plant.falls(), 0, "{:?}", rig.plant.first_fall());
    assert!(rig.plant.worst_slip() <= 1.0, "{}", rig.plant.worst_slip());
}

#[test]
fn a_crawl_with_one_sweep_reversed_is_found_out() {
    let mut rig = Rig::standing();
    crawl(&mut rig, Flaw::ReversedSweep);
    assert!(rig.plant.worst_slip() > 10.0);
    assert!(rig.plant.body().position[1] < 0.9 * STRIDE);
}

#[test]
fn a_crawl_that_lifts_two_adjacent_feet_is_found_out() {
    let mut rig = Rig::standing();
    crawl(&mut rig, Flaw::AdjacentLift);
    assert!(rig.plant.falls() > 0);
}

#[test]
fn the_same_gait_gives_the_same_bits() {
    let run = || {
        let mut rig = Rig::standing();
        crawl(&mut rig, Flaw::None);
        (rig.plant.body(), rig.plant.angles(), rig.loads())
    };
    assert_eq!(run(), run());
}
