//! A plant whose feet are moved along straight lines, without a controller.

use tip_runtime::hardware::{Hardware, JointCommand, Outputs, Sensors};
use tip_runtime::model::{Model, titan8};
use tip_runtime::plant::SimulatedPlant;

/// Feet in the robot frame: mm.
pub(crate) type Feet = [[f64; 3]; 4];

pub(crate) const CENTIMETRE: f64 = 10.0;

/// The weight of TITAN VIII: 20 kg under standard gravity, in N.
pub(crate) const WEIGHT: f64 = 20.0 * 9.80665;

/// Side (x) and end (y) of each leg.
const CORNERS: [[f64; 2]; 4] = [[-1.0, 1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];

pub(crate) struct Rig {
    pub(crate) plant: SimulatedPlant<4, 3>,
    pub(crate) feet: Feet,
    /// The sampling time: ms.
    pub(crate) period: f64,
}

/// Returns feet below mid-stroke, at a height under the body.
pub(crate) fn stance(z: f64) -> Feet {
    CORNERS.map(|[side, end]| [391.0 * side, 201.0 * end, z])
}

impl Rig {
    pub(crate) fn new() -> Self {
        Self::on(SimulatedPlant::new(&titan8::MODEL))
    }

    pub(crate) fn on(plant: SimulatedPlant<4, 3>) -> Self {
        Rig {
            plant,
            feet: stance(-200.0),
            period: 20.0,
        }
    }

    /// Returns the robot standing with the belly 50 mm above the floor.
    pub(crate) fn standing() -> Self {
        let mut rig = Self::new();
        rig.move_to(stance(-250.0));
        rig
    }

    /// Moves all feet at 5 mm each 20 ms, then lets the servos arrive.
    pub(crate) fn move_to(&mut self, to: Feet) {
        let from = self.feet;
        let longest = (from.iter().flatten().zip(to.iter().flatten()))
            .map(|(from, to)| (to - from).abs())
            .fold(0.0, f64::max);
        let shorter = 20.0 / self.period;
        let cycles = (longest / 5.0).ceil().max(1.0) as u32 * shorter as u32;
        for cycle in 1..=cycles {
            let share = f64::from(cycle) / f64::from(cycles);
            let mut feet = from;
            for (foot, to) in feet.iter_mut().flatten().zip(to.iter().flatten()) {
                *foot += (to - *foot) * share;
            }
            self.tell(&feet);
        }
        for _ in 0..20 * shorter as u32 {
            self.tell(&to);
        }
        self.feet = to;
    }

    /// Changes some feet and moves.
    pub(crate) fn change(&mut self, change: impl FnOnce(&mut Feet)) {
        let mut feet = self.feet;
        change(&mut feet);
        self.move_to(feet);
    }

    pub(crate) fn tell(&mut self, feet: &Feet) {
        self.command(
            angles(feet).map(|leg| leg.map(JointCommand::at)),
            self.period,
        );
    }

    pub(crate) fn command(&mut self, joints: [[JointCommand; 3]; 4], period: f64) {
        self.plant
            .write(&Outputs {
                joints,
                lamps: [0; 8],
                slider: [0.0; 3],
                period,
            })
            .expect("a plant never fails");
    }

    pub(crate) fn sensors(&mut self) -> Sensors<4, 3> {
        let mut sensors = Sensors::ZERO;
        self.plant.read(&mut sensors).expect("a plant never fails");
        sensors
    }

    pub(crate) fn loads(&self) -> [f64; 4] {
        self.plant.feet().map(|foot| foot.load)
    }
}

/// Returns the joint angles (deg) of feet in the robot frame, by the cosine rule.
pub(crate) fn angles(feet: &Feet) -> [[f64; 3]; 4] {
    let mut angles = [[0.0; 3]; 4];
    for ((angles, foot), [side, end]) in angles.iter_mut().zip(feet).zip(CORNERS) {
        let (out, forward) = (side * foot[0] - 101.0, foot[1] - 201.0 * end);
        let reach = libm::hypot(out, forward) - 50.0;
        let distance = libm::hypot(reach, foot[2]);
        let cos = (distance * distance - 240.0 * 240.0 - 200.0 * 200.0) / (2.0 * 240.0 * 200.0);
        let knee = libm::acos(cos);
        let thigh =
            libm::atan2(foot[2], reach) + libm::atan2(200.0 * libm::sin(knee), 240.0 + 200.0 * cos);
        *angles = [libm::atan2(forward, out), thigh, knee].map(f64::to_degrees);
    }
    angles
}

pub(crate) fn close(left: f64, right: f64, tolerance: f64) -> bool {
    (left - right).abs() <= tolerance
}

/// Returns TITAN VIII with its belly higher, so that it stands in its initial posture.
pub(crate) fn high_bellied() -> Model<4, 3> {
    let mut model = titan8::MODEL;
    model.body.as_mut().expect("it walks").z.min = -150.0;
    model
}
