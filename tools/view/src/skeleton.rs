//! Geometry of the body and the links of a robot.

use tip_runtime::kinematics::Frame;
use tip_runtime::model::{Body, Inverse, Point, Slider, TorqueUnit};
use tip_runtime::plant::Pose;
use tip_sim::{Limb, Robot};

/// A robot as links and joints, whatever its size.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    /// Name of the robot.
    pub name: String,
    /// Its body, if it walks; its frame stays where it is if not.
    pub body: Option<Body>,
    /// Its legs or fingers, F1 first.
    pub legs: Vec<Limb>,
    /// The slider that carries the floor under a hand, if it has one.
    pub slider: Option<Slider>,
    /// Unit of torques.
    pub torque_unit: TorqueUnit,
    /// All its joints turn about z, and y is the height: it is a hand.
    pub is_planar: bool,
}

impl Skeleton {
    /// Returns the skeleton of a robot.
    pub fn of(robot: &Robot) -> Self {
        let anatomy = robot.anatomy();
        Skeleton {
            name: robot.name().to_owned(),
            body: anatomy.body,
            legs: anatomy.legs,
            slider: anatomy.slider,
            torque_unit: anatomy
                .forces
                .map_or(TorqueUnit::NewtonMetre, |forces| forces.unit),
            is_planar: anatomy.inverse == Inverse::Planar,
        }
    }

    /// Returns the joints of a leg, counted from 0, and then its foot, at these angles (deg), in
    /// the robot's frame, mm. A leg that does not exist has no points.
    pub fn points(&self, leg: usize, angles: &[f64]) -> Vec<Point> {
        let Some(limb) = self.legs.get(leg) else {
            return Vec::new();
        };
        let joints = limb.frames(angles).into_iter().map(|frame| frame.at);
        joints.chain([limb.foot(angles)]).collect()
    }
}

/// Returns the robot's frame in the world: turned by yaw about z first, then by pitch about x, then
/// by roll about y.
pub fn robot_frame(pose: &Pose) -> Frame {
    let sin_cos = |angle: f64| libm::sincos(angle.to_radians());
    let ((sr, cr), (sp, cp), (sy, cy)) =
        (sin_cos(pose.roll), sin_cos(pose.pitch), sin_cos(pose.yaw));
    Frame {
        at: pose.position,
        axes: [
            [cy * cr - sy * sp * sr, sy * cr + cy * sp * sr, -cp * sr],
            [-sy * cp, cy * cp, sp],
            [cy * sr + sy * sp * cr, sy * sr - cy * sp * cr, cp * cr],
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(one: Point, other: Point) -> bool {
        let far = one
            .iter()
            .zip(other)
            .map(|(one, other)| (one - other).abs());
        far.fold(0.0, f64::max) < 1e-9
    }

    #[test]
    fn a_leg_of_titan_stands_where_its_links_lead() {
        let titan = Skeleton::of(&Robot::named("titan8").expect("it has a name"));
        // Base, 50 and 240 mm outwards, 200 mm down.
        let points = titan.points(1, &[0.0, 0.0, 90.0]);
        let expected = [
            [101.0, 201.0, 0.0],
            [151.0, 201.0, 0.0],
            [391.0, 201.0, 0.0],
            [391.0, 201.0, -200.0],
        ];
        assert_eq!(points.len(), expected.len());
        assert!(
            points.iter().zip(expected).all(|(at, to)| near(*at, to)),
            "{points:?}"
        );
        assert!(titan.points(4, &[0.0; 3]).is_empty(), "it has no fifth leg");
    }

    #[test]
    fn a_pose_turns_as_its_angles_say() {
        let placed = |[roll, pitch, yaw]: [f64; 3], point| {
            let position = [1.0, 2.0, 3.0];
            robot_frame(&Pose {
                position,
                roll,
                pitch,
                yaw,
            })
            .point(point)
        };
        let (right, forward) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        // A yaw of 90 deg turns forward to the left, a pitch raises the front, a roll lowers the right side.
        assert!(near(placed([0.0, 0.0, 90.0], forward), [0.0, 2.0, 3.0]));
        assert!(near(placed([0.0, 90.0, 0.0], forward), [1.0, 2.0, 4.0]));
        assert!(near(placed([90.0, 0.0, 0.0], right), [1.0, 2.0, 2.0]));
        // The pitch is about the x axis that the yaw has turned, the roll about the y axis that both have.
        assert!(near(placed([0.0, 90.0, 90.0], forward), [1.0, 2.0, 4.0]));
        assert!(near(placed([90.0, 90.0, 0.0], right), [1.0, 3.0, 3.0]));
    }
}
