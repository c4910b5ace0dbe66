//! The names and frames of exported files, which logs have as well: m, x forward and y left (REP 103).
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

/// Where robots are bolted down.
pub const WORLD: &str = "world";
/// No size that is written is smaller, since readers refuse sizes of nothing: mm.
pub(crate) const LEAST: f64 = 1e-6;
/// How thick a link is drawn, against the mean length of all links.
const THICKNESS: f64 = 0.1;

/// The robot frame.
pub const BASE: &str = "base_link";
/// What the legs of a walking robot carry.
pub const BODY: &str = "body";
/// What the slider carries.
pub const FLOOR: &str = "floor";

/// What joint and leg number from 1 to 9 are called: the joint.
pub fn joint(leg: u8, joint: u8) -> String {
    Target::Joint(leg, joint).to_string()
}

/// The link after a joint.
pub fn link(leg: u8, joint: u8) -> String {
    format!("link{leg}{joint}")
}

/// The foot or fingertip.
pub fn foot(leg: u8) -> String {
    Target::Foot(leg).to_string()
}

/// Roll, pitch and yaw of the robot frame in the world, for a robot that is bolted down: rad. Where all joints turn about z, as
/// those of the hand, y is the height.
pub fn standing(is_planar: bool) -> [f64; 3] {
    [0.0, if is_planar { -FRAC_PI_2 } else { 0.0 }, 0.0]
}

/// The axes along which a slider goes.
pub(crate) fn ways(slider: &Slider) -> impl Iterator<Item = usize> {
    let travel = slider.travel;
    (0..3).filter(move |axis| travel[*axis].min < travel[*axis].max)
}

/// What the joint of a slider along x, y or z is called.
pub(crate) fn carriage(axis: usize) -> &'static str {
    ["floor_x", "floor_y", "floor_z"][axis]
}

/// The joints of a slider, and their values where it is at a place of the robot frame (mm): m from where it was at first.
pub fn slide(slider: &Slider, at: Point) -> impl Iterator<Item = (&'static str, f64)> {
    let initial = slider.initial;
    ways(slider).map(move |axis| (carriage(axis), (at[axis] - initial[axis]) / 1000.0))
}

/// A place of the robot frame (mm; x to the right, y forward) in URDF's: m; x forward, y left.
pub fn metres(at: Point) -> [f64; 3] {
    direction(at).map(|mm| mm / 1000.0)
}

/// A direction of the robot frame in URDF's.
pub fn direction([right, forward, up]: [f64; 3]) -> [f64; 3] {
    [forward, -right, up]
}

/// The elements xx, yy, zz, xy, xz and yz of a tensor of the robot frame in URDF's.
pub(crate) fn tensor([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [f64; 6] {
    // Adding 0 makes of −0 a plain 0.
    [yy, xx, zz, -xy, yz, -xz].map(|element| element + 0.0)
}

/// What holds every first joint, and `more` (mm) on each side of them.
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

/// How thick links are drawn: their radius in mm.
pub(crate) fn thickness(legs: &[Limb]) -> f64 {
    let joints = legs.iter().flat_map(|leg| &leg.joints);
    let lengths: Vec<f64> = joints
        .map(|joint| length(joint.link))
        .filter(|length| *length >= LEAST)
        .collect();
    (THICKNESS * lengths.iter().sum::<f64>() / lengths.len().max(1) as f64).max(LEAST)
}
