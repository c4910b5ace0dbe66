//! The transform of each frame of the robot to the one before, under the names that its URDF file
//! has.

use super::foxglove::{FrameTransform, FrameTransforms, Timestamp};
use nalgebra::{Matrix3, Rotation3, Unit, UnitQuaternion, Vector3};
use tip_runtime::plant::Pose;
use tip_sim::urdf::frame::{self, BASE, BODY, FLOOR, WORLD, direction, metres};
use tip_view::{Frame, Skeleton, robot_frame};

/// A frame in its parent's.
pub(super) struct Transform {
    parent: String,
    child: String,
    /// m.
    at: [f64; 3],
    /// x, y, z, w.
    turned: [f64; 4],
}

/// The quaternion without a turn.
pub(super) const STRAIGHT: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

impl Transform {
    fn straight(parent: &str, child: &str, at: [f64; 3]) -> Self {
        Transform {
            parent: parent.to_owned(),
            child: child.to_owned(),
            at: metres(at),
            turned: STRAIGHT,
        }
    }
}

/// Returns the transforms that never change.
pub(super) fn fixed(robot: &Skeleton) -> Vec<Transform> {
    let mut all = Vec::new();
    match robot.body {
        Some(_) => all.push(Transform::straight(BASE, BODY, [0.0; 3])),
        None => all.push(Transform {
            turned: standing(robot.is_planar),
            ..Transform::straight(WORLD, BASE, [0.0; 3])
        }),
    }
    for (number, leg) in (1..).zip(&robot.legs) {
        if let Some((last, joint)) = (1..).zip(&leg.joints).last() {
            let (parent, child) = (frame::link(number, last), frame::foot(number));
            all.push(Transform::straight(&parent, &child, joint.link));
        }
    }
    all
}

/// Returns the turn of the robot frame in the world for a robot that is bolted down.
fn standing(is_planar: bool) -> [f64; 4] {
    let [roll, pitch, yaw] = frame::standing(is_planar);
    UnitQuaternion::from_euler_angles(roll, pitch, yaw)
        .coords
        .into()
}

/// Returns the transforms that change, at the end of a cycle.
pub(super) fn moving(robot: &Skeleton, frame: &Frame) -> Vec<Transform> {
    let body = frame.pose.as_ref().filter(|_| robot.body.is_some());
    let body = body.map(|pose| Transform {
        turned: attitude(pose),
        ..Transform::straight(WORLD, BASE, pose.position)
    });
    let mut all: Vec<Transform> = body.into_iter().collect();
    for (number, (leg, angles)) in (1..).zip(robot.legs.iter().zip(&frame.angles)) {
        let (mut parent, mut at) = (BASE.to_owned(), leg.base);
        for (joint, (of, angle)) in (1..).zip(leg.joints.iter().zip(angles)) {
            let child = frame::link(number, joint);
            let axis = Unit::new_normalize(Vector3::from(direction(of.axis)));
            all.push(Transform {
                turned: UnitQuaternion::from_axis_angle(&axis, angle.to_radians())
                    .coords
                    .into(),
                ..Transform::straight(&parent, &child, at)
            });
            (parent, at) = (child, of.link);
        }
    }
    all.extend(frame.slider.map(|at| Transform::straight(BASE, FLOOR, at)));
    all
}

/// Returns the turn of the body, in axes with x forward and y left.
fn attitude(pose: &Pose) -> [f64; 4] {
    // Each inner array is a column.
    let turned = Rotation3::from_matrix_unchecked(Matrix3::from(robot_frame(pose).axes));
    let turned = UnitQuaternion::from_rotation_matrix(&turned);
    let [x, y, z] = direction(turned.imag().into());
    [x, y, z, turned.w]
}

/// Returns `foxglove.FrameTransforms`.
pub(super) fn message(time: u64, transforms: Vec<Transform>) -> FrameTransforms {
    let all = transforms.into_iter().map(|transform| FrameTransform {
        timestamp: Timestamp::of(time),
        parent_frame_id: transform.parent,
        child_frame_id: transform.child,
        translation: transform.at.into(),
        rotation: transform.turned.into(),
    });
    FrameTransforms {
        transforms: all.collect(),
    }
}
