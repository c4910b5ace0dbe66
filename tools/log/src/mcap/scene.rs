//! The moving parts of a log: objects, forces as arrows, trails of the feet, and the transform of each frame of the robot to
//! the one before, under the names of its URDF file.

use super::messages::{
    ArrowPrimitive, CubePrimitive, CylinderPrimitive, FrameTransform, FrameTransforms,
    LinePrimitive, Pose, SceneEntity, SceneUpdate, Timestamp,
};
use nalgebra::{Matrix3, Rotation3, Unit, UnitQuaternion, Vector3};
use std::collections::VecDeque;
use tip_runtime::model::Point;
use tip_runtime::plant::{self, Block, Floor, Object, Scene, Shape};
use tip_sim::urdf::frame::{self, BASE, BODY, FLOOR, WORLD, direction, metres};
use tip_view::{Frame, Skeleton, robot_frame};

/// Length of an arrow for each newton, m.
const METRES_PER_NEWTON: f64 = 0.002;
/// Length of an arrow for each newton of a hand, whose forces are smaller, m.
const METRES_PER_NEWTON_OF_A_HAND: f64 = 0.02;
/// Length below which an arrow is not shown, m.
const SHORTEST: f64 = 0.001;
/// Time between two places of a trail, ns.
const STEP: u64 = 100_000_000;
/// Number of places of a trail: five seconds.
const PLACES: usize = 51;

const ARROW: [f64; 4] = [0.9, 0.2, 0.2, 1.0];
const OBJECT: [f64; 4] = [0.3, 0.55, 0.8, 0.9];
const BLOCK: [f64; 4] = [0.6, 0.63, 0.67, 1.0];
/// One colour for each leg; the fifth has that of the first.
const TRAILS: [[f64; 4]; 4] = [
    [0.9, 0.6, 0.0, 1.0],
    [0.35, 0.7, 0.9, 1.0],
    [0.0, 0.6, 0.5, 1.0],
    [0.8, 0.5, 0.7, 1.0],
];

/// Makes the updates of a run, one after the other.
pub(super) struct Stage<'a> {
    robot: &'a Skeleton,
    objects: Vec<Object>,
    /// Blocks on the floor, as cubes, which never move.
    blocks: Vec<CubePrimitive>,
    trails: Vec<VecDeque<Point>>,
    /// Time at which the trails go on, ns.
    due: u64,
}

impl<'a> Stage<'a> {
    pub(super) fn new(robot: &'a Skeleton, scene: &Scene) -> Self {
        Stage {
            robot,
            objects: scene.objects.into_iter().flatten().collect(),
            blocks: blocks(scene),
            trails: vec![VecDeque::new(); robot.legs.len()],
            due: 0,
        }
    }

    /// Returns the `foxglove.SceneUpdate` for the end of a cycle, ns.
    pub(super) fn update(&mut self, time: u64, frame: &Frame) -> SceneUpdate {
        let feet: Vec<Point> = self.robot.feet(frame).collect();
        let mut entities = vec![self.forces(time, frame, &feet)];
        if !frame.objects.is_empty() {
            entities.push(self.things(time, frame));
        }
        if !self.blocks.is_empty() {
            // Who looks at a log from its middle on sees them as well.
            entities.push(SceneEntity {
                cubes: self.blocks.clone(),
                ..self.entity(time, "blocks")
            });
        }
        if time >= self.due {
            self.due = time + STEP;
            for (number, foot) in (1..).zip(feet) {
                entities.extend(self.trail(time, number, foot));
            }
        }
        SceneUpdate {
            entities,
            ..SceneUpdate::default()
        }
    }

    /// Returns the frame of all coordinates: the world, in which the body moves, or the robot
    /// frame.
    fn frame(&self) -> &'static str {
        if self.robot.body.is_some() {
            WORLD
        } else {
            BASE
        }
    }

    fn entity(&self, time: u64, id: &str) -> SceneEntity {
        SceneEntity {
            timestamp: Timestamp::of(time),
            frame_id: self.frame().to_owned(),
            id: id.to_owned(),
            ..SceneEntity::default()
        }
    }

    /// Returns the forces of the floor on the feet, or of the fingers on what they touch, N.
    fn forces(&self, time: u64, frame: &Frame, feet: &[Point]) -> SceneEntity {
        let (scale, forces) = match frame.pushes.is_empty() {
            true if frame.forces.is_empty() => {
                let up = frame.loads.iter().map(|load| [0.0, 0.0, *load]);
                (METRES_PER_NEWTON, up.collect())
            }
            true => (METRES_PER_NEWTON, frame.forces.clone()),
            false => (METRES_PER_NEWTON_OF_A_HAND, frame.pushes.clone()),
        };
        let arrows = feet.iter().zip(forces);
        let arrows = arrows.filter_map(|(foot, force)| arrow(*foot, force, scale));
        SceneEntity {
            arrows: arrows.collect(),
            ..self.entity(time, "forces")
        }
    }

    fn things(&self, time: u64, frame: &Frame) -> SceneEntity {
        let (mut cubes, mut cylinders) = (Vec::new(), Vec::new());
        let depth = self.depth();
        for (object, thing) in self.objects.iter().zip(&frame.objects) {
            // About the z axis, which URDF's axes share.
            let half = thing.angle.to_radians() / 2.0;
            let turned = [0.0, 0.0, libm::sin(half), libm::cos(half)];
            let pose = Pose::new(metres(thing.position), turned);
            match object.shape {
                Shape::Box { width, height } => {
                    let size = metres([width, height, depth]).map(f64::abs);
                    cubes.push(CubePrimitive {
                        pose,
                        size: size.into(),
                        color: OBJECT.into(),
                    });
                }
                Shape::Disc { radius } => {
                    let size = metres([2.0 * radius, 2.0 * radius, depth]).map(f64::abs);
                    cylinders.push(CylinderPrimitive {
                        pose,
                        size: size.into(),
                        bottom_scale: 1.0,
                        top_scale: 1.0,
                        color: OBJECT.into(),
                    });
                }
            }
        }
        SceneEntity {
            cubes,
            cylinders,
            ..self.entity(time, "objects")
        }
    }

    /// Returns the width of objects along z: that of the hand, mm.
    fn depth(&self) -> f64 {
        let along = || self.robot.legs.iter().map(|leg| leg.base[2]);
        let (least, most) = (along().fold(0.0, f64::min), along().fold(0.0, f64::max));
        (most - least).max(20.0)
    }

    /// Returns the places where a foot has been; none as long as that is one place.
    fn trail(&mut self, time: u64, number: u8, foot: Point) -> Option<SceneEntity> {
        let leg = usize::from(number) - 1;
        let trail = self.trails.get_mut(leg)?;
        trail.push_back(foot);
        if trail.len() > PLACES {
            trail.pop_front();
        }
        if trail.len() < 2 {
            return None;
        }
        let line = LinePrimitive {
            pose: Pose::new([0.0; 3], STRAIGHT),
            thickness: 2.0,
            scale_invariant: true,
            points: trail.iter().map(|at| metres(*at).into()).collect(),
            color: TRAILS[leg % TRAILS.len()].into(),
            ..LinePrimitive::default()
        };
        let id = format!("trail/{}", frame::foot(number));
        Some(SceneEntity {
            lines: vec![line],
            ..self.entity(time, &id)
        })
    }
}

/// Returns the blocks of a scene as `CubePrimitive`s, down to the lowest place of the floor under
/// each.
fn blocks(scene: &Scene) -> Vec<CubePrimitive> {
    let blocks = scene.blocks.iter().flatten();
    let cubes = blocks.map(|block| {
        let Block { x, y, height } = *block;
        let foot = foot(&scene.floor, block).min(height);
        let middle =
            [[x[0], x[1]], [y[0], y[1]], [foot, height]].map(|[from, to]| (from + to) / 2.0);
        let size = metres([x[1] - x[0], y[1] - y[0], height - foot]).map(f64::abs);
        CubePrimitive {
            pose: Pose::new(metres(middle), STRAIGHT),
            size: size.into(),
            color: BLOCK.into(),
        }
    });
    cubes.collect()
}

/// Returns the lowest height of the floor under a block.
fn foot(floor: &Floor, block: &Block) -> f64 {
    let Floor { height, slope } = *floor;
    let corners = block.x.into_iter().flat_map(|x| block.y.map(|y| [x, y]));
    let heights = corners.map(|[x, y]| height + slope[0] * x + slope[1] * y);
    heights.fold(f64::INFINITY, f64::min)
}

/// Returns an `ArrowPrimitive`, which points along x of its pose.
fn arrow(at: Point, force: [f64; 3], scale: f64) -> Option<ArrowPrimitive> {
    let force = Vector3::from(direction(force));
    let length = scale * force.norm();
    if length < SHORTEST {
        return None;
    }
    let along = Unit::new_normalize(force);
    let turn = UnitQuaternion::rotation_between_axis(&Vector3::x_axis(), &along);
    let turned = turn.map_or([0.0, 0.0, 1.0, 0.0], |turn| turn.coords.into());
    let head = (0.25 * length).min(0.03);
    Some(ArrowPrimitive {
        pose: Pose::new(metres(at), turned),
        shaft_length: length - head,
        shaft_diameter: 0.2 * head,
        head_length: head,
        head_diameter: 0.5 * head,
        color: ARROW.into(),
    })
}

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
const STRAIGHT: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

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
fn attitude(pose: &plant::Pose) -> [f64; 4] {
    // Each inner array is a column.
    let turned = Rotation3::from_matrix_unchecked(Matrix3::from(robot_frame(pose).axes));
    let turned = UnitQuaternion::from_rotation_matrix(&turned);
    let [x, y, z] = direction(turned.imag().into());
    [x, y, z, turned.w]
}

/// Returns `foxglove.FrameTransforms`.
pub(super) fn transforms(time: u64, transforms: Vec<Transform>) -> FrameTransforms {
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

#[cfg(test)]
mod tests {
    use super::*;
    use tip_sim::Robot;

    #[test]
    fn arrows_lean_as_forces_do_and_stand_where_only_loads_are_known() {
        let robot = Robot::named("titan8").expect("it has a name");
        let skeleton = Skeleton::of(&robot);
        let stage = Stage::new(&skeleton, &Scene::EMPTY);
        let feet = [[391.0, 201.0, 0.0]];
        let arrows = |loads: &[f64], forces: &[[f64; 3]]| {
            let mut frame = Frame::default();
            frame.loads = loads.to_vec();
            frame.forces = forces.to_vec();
            stage.forces(0, &frame, &feet)
        };
        let upright = arrows(&[40.0], &[]);
        assert_eq!(arrows(&[40.0], &[[0.0, 0.0, 40.0]]), upright);
        // 50 N, to the right and up.
        let leaning = arrows(&[40.0], &[[30.0, 0.0, 40.0]]);
        let expected = arrow(feet[0], [30.0, 0.0, 40.0], 0.002).expect("it is seen");
        assert_eq!(leaning.arrows, [expected]);
        assert_ne!(leaning, upright);
    }
}
