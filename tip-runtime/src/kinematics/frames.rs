//! The frames of a leg's links, for drawing, logging and export.

use super::chain::ChainBuilder;
use crate::model::{Joint, Point};

/// The frame of a link: its origin is the joint that carries the link, and it turns with that
/// joint. While all joints are at 0 it is parallel to the robot frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Origin in the robot frame, mm.
    pub at: Point,
    /// The x, y and z axes in the robot frame, unit vectors.
    pub axes: [[f64; 3]; 3],
}

impl Frame {
    /// Transforms a point of this frame (mm) into the robot frame, mm.
    #[must_use]
    pub fn point(&self, inner: Point) -> Point {
        let [x, y, z] = self.at;
        let [along_x, along_y, along_z] = self.direction(inner);
        [x + along_x, y + along_y, z + along_z]
    }

    /// Transforms a direction of this frame into the robot frame.
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

/// Iterates over the frames of a leg's links, from base to foot; the first joint is at `base` (mm),
/// the angles are in deg. In the last frame, the `link` of the last joint leads to the foot.
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
    let mut chain = ChainBuilder::at(base);
    joints.iter().zip(angles).map(move |(joint, angle)| {
        let (place, _) = chain.append(joint, *angle);
        Frame {
            at: place.into(),
            axes: chain.axes(),
        }
    })
}
