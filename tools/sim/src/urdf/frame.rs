//! Names and frames of exported files and of logs: m, x forward and y left (REP 103).
//!
//! ```
//! use tip_sim::urdf::frame;
//!
//! assert_eq!(frame::joint(2, 3), "J23");
//! assert_eq!(frame::metres([100.0, 2000.0, -50.0]), [2.0, -0.1, -0.05], "right is minus left");
//! ```

use crate::model::Limb;
use std::f64::consts::FRAC_PI_2;
use tip_runtime::command::Target;
use tip_runtime::model::{Point, Range, Slider};

/// The link to which robots are bolted down.
pub const WORLD: &str = "world";
/// Minimum size that is written, mm: readers refuse sizes of 0.
pub(crate) const MIN_SIZE: f64 = 1e-6;
/// Radius of drawn links, relative to the mean length of all links.
const THICKNESS: f64 = 0.1;

/// The robot frame.
pub const BASE: &str = "base_link";
/// The body of a walking robot.
pub const BODY: &str = "body";
/// The floor on a slider.
pub const FLOOR: &str = "floor";

/// Returns the name of a joint; legs and joints count from 1.
pub fn joint(leg: u8, joint: u8) -> String {
    Target::Joint(leg, joint).to_string()
}

/// Returns the name of the link after a joint.
pub fn link(leg: u8, joint: u8) -> String {
    format!("link{leg}{joint}")
}

/// Returns the name of a foot or fingertip.
pub fn foot(leg: u8) -> String {
    Target::Foot(leg).to_string()
}

/// Returns roll, pitch and yaw of the robot frame in the world, for a robot that is bolted down,
/// rad. If all joints turn about z, as in the hand, y is the height.
pub fn standing(is_planar: bool) -> [f64; 3] {
    [0.0, if is_planar { -FRAC_PI_2 } else { 0.0 }, 0.0]
}

/// Iterates over the axes along which a slider moves.
pub(crate) fn ways(slider: &Slider) -> impl Iterator<Item = usize> {
    let travel = slider.travel;
    (0..3).filter(move |axis| travel[*axis].min < travel[*axis].max)
}

/// Returns the name of the joint of a slider along an axis.
pub(crate) fn carriage(axis: usize) -> &'static str {
    ["floor_x", "floor_y", "floor_z"][axis]
}

/// Iterates over the joints of a slider, with their values (m) for a position in the robot frame
/// (mm); they are 0 in the initial position.
pub fn slide(slider: &Slider, at: Point) -> impl Iterator<Item = (&'static str, f64)> {
    let initial = slider.initial;
    ways(slider).map(move |axis| (carriage(axis), (at[axis] - initial[axis]) / 1000.0))
}

/// Converts a position of the robot frame (mm; x to the right, y forward) to URDF's (m; x forward,
/// y left).
pub fn metres(at: Point) -> [f64; 3] {
    direction(at).map(|mm| mm / 1000.0)
}

/// Converts a direction of the robot frame to URDF's.
pub fn direction([right, forward, up]: [f64; 3]) -> [f64; 3] {
    [forward, -right, up]
}

/// Converts a tensor (xx, yy, zz, xy, xz, yz) of the robot frame to URDF's.
pub(crate) fn tensor([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [f64; 6] {
    // Adding 0 makes of −0 a plain 0.
    [yy, xx, zz, -xy, yz, -xz].map(|element| element + 0.0)
}

/// Returns the box around every first joint, widened by `more` (mm) on each side.
pub(crate) fn around(legs: &[Limb], more: f64) -> [Range; 3] {
    [0, 1, 2].map(|axis| {
        let along = || legs.iter().map(|leg| leg.base[axis]);
        Range::new(
            along().fold(0.0, f64::min) - more,
            along().fold(0.0, f64::max) + more,
        )
    })
}

pub(crate) fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// Returns the radius of drawn links, mm.
pub(crate) fn thickness(legs: &[Limb]) -> f64 {
    let joints = legs.iter().flat_map(|leg| &leg.joints);
    let lengths: Vec<f64> = joints
        .map(|joint| length(joint.link))
        .filter(|length| *length >= MIN_SIZE)
        .collect();
    (THICKNESS * lengths.iter().sum::<f64>() / lengths.len().max(1) as f64).max(MIN_SIZE)
}

/// Returns roll, pitch and yaw (rad) of the axes x, y and z.
pub(crate) fn rpy_of_axes([x, y, z]: [[f64; 3]; 3]) -> [f64; 3] {
    /// Least horizontal length of an x axis that is not upright: for an upright one roll and yaw
    /// are about the same axis.
    const LEVEL: f64 = 1e-12;
    let level = (x[0] * x[0] + x[1] * x[1]).sqrt();
    let pitch = libm::atan2(-x[2], level);
    if level < LEVEL {
        return [0.0, pitch, libm::atan2(-y[0], y[1])];
    }
    let yaw = libm::atan2(x[1], x[0]);
    // The roll compensates the error of the yaw near that case.
    let (sin, cos) = libm::sincos(yaw);
    let roll = libm::atan2(sin * z[0] - cos * z[1], cos * y[1] - sin * y[0]);
    [roll, pitch, yaw]
}
