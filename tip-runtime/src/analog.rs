//! The analogue inputs of the control box: the use of each A/D channel, and the conversions between
//! volts, angles and forces.

use crate::command::Port;
use crate::model::Range;

/// Channels of the A/D board.
pub(crate) const CHANNELS: u8 = 16;

/// Volts of a potentiometer at the ends of its range.
const POTENTIOMETER: f64 = 5.0;

/// Volts of a sole's pressure sensor under its full load.
const PAW: f64 = 5.0;

/// The full load of a sole's pressure sensor: N.
const PAW_FULL: f64 = 200.0;

/// The connection of a channel of the A/D board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Connection {
    /// A joint: leg and joint, from 0.
    Joint(usize, usize),
    /// An input with a name.
    Input(Port),
    /// No connection.
    Open,
}

/// Returns the connection of `channel` on a robot of `legs` × `joints`; `None` past the board's
/// last channel.
pub(crate) fn connection(channel: u8, legs: usize, joints: usize) -> Option<Connection> {
    if channel >= CHANNELS {
        return None;
    }
    if let knob @ Port::Knob(_) = Port::Channel(channel).by_name() {
        return Some(Connection::Input(knob));
    }
    let index = usize::from(channel);
    match index.checked_div(joints) {
        Some(leg) if leg < legs => Some(Connection::Joint(leg, index - leg * joints)),
        _ => Some(Connection::Open),
    }
}

/// Returns the voltage of a potentiometer that covers `range` (deg) at `angle` (deg), V.
pub(crate) fn volts_of_angle(range: Range, angle: f64) -> f64 {
    let middle = (range.min + range.max) / 2.0;
    POTENTIOMETER * (angle - middle) / (range.max - middle)
}

/// Returns the angle at which a potentiometer that covers `range` (deg) gives `volts` (V), deg.
pub(crate) fn angle_of_volts(range: Range, volts: f64) -> f64 {
    let middle = (range.min + range.max) / 2.0;
    middle + volts / POTENTIOMETER * (range.max - middle)
}

/// Returns the voltage of a sole's pressure sensor under `load` (N), V.
pub fn volts_of_load(load: f64) -> f64 {
    (PAW * load / PAW_FULL).clamp(0.0, PAW)
}

#[cfg(test)]
mod tests {
    use super::*;

    // clauses: 7.32
    #[test]
    fn the_board_has_joints_first_and_knobs_last() {
        assert_eq!(connection(0, 4, 3), Some(Connection::Joint(0, 0)));
        assert_eq!(connection(11, 4, 3), Some(Connection::Joint(3, 2)));
        assert_eq!(connection(12, 4, 3), Some(Connection::Open));
        assert_eq!(connection(13, 4, 3), Some(Connection::Input(Port::Knob(1))));
        assert_eq!(connection(15, 4, 3), Some(Connection::Input(Port::Knob(3))));
        assert_eq!(connection(16, 4, 3), None);
        // A robot of many joints does not push the knobs off their channels.
        assert_eq!(connection(13, 9, 9), Some(Connection::Input(Port::Knob(1))));
    }

    #[test]
    fn potentiometers_span_ten_volts_over_the_outer_limits() {
        let range = Range::new(-65.0, 85.0);
        assert_eq!(volts_of_angle(range, -65.0), -5.0);
        assert_eq!(volts_of_angle(range, 10.0), 0.0);
        assert_eq!(volts_of_angle(range, 85.0), 5.0);
        assert_eq!(angle_of_volts(range, 5.0), 85.0);
        assert_eq!(angle_of_volts(range, -2.5), -27.5);
    }

    #[test]
    fn soles_give_five_volts_at_two_hundred_newtons_and_no_more() {
        assert_eq!(volts_of_load(0.0), 0.0);
        assert_eq!(volts_of_load(100.0), 2.5);
        assert_eq!(volts_of_load(300.0), 5.0);
    }
}
