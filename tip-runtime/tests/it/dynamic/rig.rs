//! A plant that is commanded directly, without a controller.

use tip_runtime::hardware::{Hardware, JointCommand, Outputs};
use tip_runtime::model::{Joint, Leg, Model, titan8};
use tip_runtime::plant::{Drives, DynamicPlant, Plant};
use tip_runtime::random::Random;

/// Standard gravity: m/s².
pub(crate) const GRAVITY: f64 = 9.80665;

/// Motors without friction.
pub(crate) const SMOOTH: Drives = Drives {
    friction: 0.0,
    ..DRIVES
};

const DRIVES: Drives = Drives {
    servos: tip_runtime::plant::ServoDynamics {
        lag: 15.0,
        speed: 360.0,
    },
    stiffness: 200.0,
    damping: 3.0,
    rotor: 7.5e-4,
    friction: 2.5e-3,
};

/// Returns TITAN VIII with its joints in the initial posture.
pub(crate) fn titan() -> DynamicPlant<4, 3> {
    DynamicPlant::new(&titan8::MODEL)
}

/// Returns outputs with one command for every joint, for `period` ms.
pub(crate) fn all<const L: usize, const J: usize>(
    joints: [[JointCommand; J]; L],
    period: f64,
) -> Outputs<L, J> {
    Outputs {
        joints,
        slider: [0.0; 3],
        lamps: [0; 8],
        period,
    }
}

/// Releases every motor for some cycles of `period` ms.
pub(crate) fn limp<const L: usize, const J: usize>(
    plant: &mut DynamicPlant<L, J>,
    period: f64,
    cycles: u32,
) {
    let outputs = all([[JointCommand::Torque(0.0); J]; L], period);
    for _ in 0..cycles {
        plant.write(&outputs).expect("it is simulated");
    }
}

/// Holds every joint at angles (deg) for some cycles of 20 ms.
pub(crate) fn hold<const L: usize, const J: usize>(
    plant: &mut DynamicPlant<L, J>,
    angles: [[f64; J]; L],
    cycles: u32,
) {
    let outputs = all(angles.map(|leg| leg.map(JointCommand::at)), 20.0);
    for _ in 0..cycles {
        plant.write(&outputs).expect("it is simulated");
    }
}

/// Moves to these angles (deg) evenly within a second, and rests for another.
pub(crate) fn go<const L: usize, const J: usize>(
    plant: &mut DynamicPlant<L, J>,
    to: [[f64; J]; L],
) {
    let from = plant.angles();
    for cycle in 1..=100 {
        let share = (f64::from(cycle) / 50.0).min(1.0);
        let mut angles = from;
        for (angle, to) in angles.iter_mut().flatten().zip(to.iter().flatten()) {
            *angle += (to - *angle) * share;
        }
        hold(plant, angles, 1);
    }
}

/// Returns the load of feet and belly, N.
pub(crate) fn loads<const L: usize, const J: usize>(plant: &DynamicPlant<L, J>) -> f64 {
    let feet: f64 = plant.feet().iter().map(|foot| foot.load).sum();
    feet + plant.belly_load()
}

/// Returns the number of falls.
pub(crate) fn falls<const L: usize, const J: usize>(plant: &DynamicPlant<L, J>) -> u32 {
    plant.motion().expect("it walks").falls
}

/// Returns a rod of 1 kg and 400 mm on one joint that turns about `axis`, bolted down; its motor
/// gives 10 N·m.
pub(crate) fn rod(axis: [f64; 3], link: [f64; 3], initial: f64) -> Model<1, 1> {
    let joint = Joint::revolute(axis, link).mass(1.0);
    Model {
        body: None,
        ..Model::generic("rod", [Leg::at([0.0; 3], [joint]).initial([initial])])
    }
}

/// Draws numbers from −`most` to `most`.
pub(crate) fn some<const N: usize>(random: &mut Random, most: f64) -> [f64; N] {
    [0.0; N].map(|_| random.within(-most, most))
}
