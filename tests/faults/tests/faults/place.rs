//! Places of sensor faults.

use tip_runtime::command::Port;
use tip_runtime::hardware::Sensors;

/// One number that a robot measures; legs and joints count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Angle(usize, usize),
    Torque(usize, usize),
    Input(Port),
    Slider(usize),
}

impl Place {
    /// Every place of a robot of `L` legs with `J` joints.
    pub(crate) fn all<const L: usize, const J: usize>() -> Vec<Place> {
        let joints = || (0..L).flat_map(|n| (0..J).map(move |m| (n, m)));
        let mut all: Vec<Place> = joints().map(|(n, m)| Place::Angle(n, m)).collect();
        all.extend(joints().map(|(n, m)| Place::Torque(n, m)));
        let soles = (1..).take(L).map(Port::Paw);
        let inputs = Port::Knob(1).named().chain(soles).chain([Port::Antenna]);
        all.extend(inputs.map(Place::Input));
        all.extend((0..3).map(Place::Slider));
        all
    }

    pub(crate) fn of<const L: usize, const J: usize>(
        self,
        sensors: &mut Sensors<L, J>,
    ) -> &mut f64 {
        match self {
            Place::Angle(n, m) => &mut sensors.angles[n][m],
            Place::Torque(n, m) => &mut sensors.torques[n][m],
            Place::Input(port) => sensors.inputs.get_mut(port).expect("a robot may have it"),
            Place::Slider(axis) => &mut sensors.slider[axis],
        }
    }

    /// Returns its name in the table.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Place::Angle(..) => "joint angle",
            Place::Torque(..) => "joint torque",
            Place::Input(Port::Knob(_)) => "knob",
            Place::Input(Port::Paw(_)) => "sole",
            Place::Input(Port::Antenna) => "antenna",
            Place::Input(Port::Channel(_) | Port::Joint(..)) => unreachable!(),
            Place::Slider(_) => "slider",
        }
    }
}
