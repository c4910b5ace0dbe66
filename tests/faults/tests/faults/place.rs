//! Where a sensor can go wrong.

use tip_runtime::hardware::Sensors;

/// One number that a robot measures; legs and joints count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Angle(usize, usize),
    Torque(usize, usize),
    Knob(usize),
    Sole(usize),
    Antenna,
    Slider(usize),
}

impl Place {
    /// Every place of a robot of `L` legs with `J` joints.
    pub(crate) fn all<const L: usize, const J: usize>() -> Vec<Place> {
        let joints = || (0..L).flat_map(|n| (0..J).map(move |m| (n, m)));
        let mut all: Vec<Place> = joints().map(|(n, m)| Place::Angle(n, m)).collect();
        all.extend(joints().map(|(n, m)| Place::Torque(n, m)));
        all.extend((0..3).map(Place::Knob));
        all.extend((0..L).map(Place::Sole));
        all.push(Place::Antenna);
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
            Place::Knob(i) => &mut sensors.knobs[i],
            Place::Sole(n) => &mut sensors.paws[n],
            Place::Antenna => &mut sensors.antenna,
            Place::Slider(axis) => &mut sensors.slider[axis],
        }
    }

    /// What the table calls it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Place::Angle(..) => "joint angle",
            Place::Torque(..) => "joint torque",
            Place::Knob(_) => "knob",
            Place::Sole(_) => "sole",
            Place::Antenna => "antenna",
            Place::Slider(_) => "slider",
        }
    }
}
