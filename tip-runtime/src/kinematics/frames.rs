//! The frames of a leg's links, for whoever draws it, logs it or writes it in another form.

use super::chain::Growing;
use crate::model::{Joint, Point};

/// The frame of a link: its origin is the joint that carries the link, and it turns with that joint. While all joints
/// are at 0 it is parallel to the robot frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Its origin in the robot frame: mm.
    pub at: Point,
    /// Its x, y and z axis in the robot frame: unit vectors.
    pub axes: [[f64; 3]; 3],
}

impl Frame {
    /// A place of the link, given in this frame (mm), in the robot frame: mm.
    #[must_use]
    pub fn point(&self, inner: Point) -> Point {
        let [x, y, z] = self.at;
        let [along_x, along_y, along_z] = self.direction(inner);
        [x + along_x, y + along_y, z + along_z]
    }

    /// A direction of the link, given in this frame, in the robot frame.
    #[must_use]
    pub fn direction(&self, [a, b, c]: [f64; 3]) -> [f64; 3] {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.axes;
        [
            xx * a + yx * b + zx * c,
            xy * a + yy * b + zy * c,
            xz * a + yz * b + zz * c,
        ]
    }
}

/// The frame of each link of a leg with its first joint at `base` (mm), at these angles (deg), from base to foot. The foot
/// is where the `link` of the last joint leads in the last frame.
///
/// ```
/// use tip_runtime::kinematics::frames;
/// use tip_runtime::model::titan8;
///
/// let leg = &titan8::MODEL.legs[1];
/// let [_, _, shank] = &leg.joints;
/// let last = frames(leg.base, &leg.joints, &[0.0, 0.0, 90.0]).last().expect("it has joints");
/// assert!((last.at[0] - 391.0).abs() < 1e-9, "the knee is out on the right");
/// assert!((last.point(shank.link)[2] + 200.0).abs() < 1e-9, "the shank hangs down from it");
/// ```
pub fn frames<'a>(
    base: Point,
    joints: &'a [Joint],
    angles: &'a [f64],
) -> impl Iterator<Item = Frame> + 'a {
    let mut chain = Growing::at(base);
    joints.iter().zip(angles).map(move |(joint, angle)| {
        let (place, _) = chain.grow(joint, *angle);
        Frame {
            at: place.into(),
            axes: chain.axes(),
        }
    })
}
