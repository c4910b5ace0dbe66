//! Export of robots as MuJoCo models (MJCF), with their motors and surroundings.
//!
//! Lengths are in m, angles in rad. The world is that of a run: z up, the robot starts at the
//! origin, with x to its right and y ahead, in the pose of
//! [`DynamicPlant`](tip_runtime::plant::DynamicPlant). Masses, motors and contacts represent those
//! of this project's plants, so that the same commands lead to the same motion as far as two
//! simulations agree.
//!
//! ```
//! use tip_runtime::plant::Scene;
//! use tip_sim::{Robot, mjcf};
//!
//! let titan = mjcf::export(&Robot::named("titan8")?);
//! assert!(titan.contains("<freejoint name=\"base_link\"/>"), "it walks");
//! assert!(titan.contains("<position name=\"J11\" joint=\"J11\""));
//!
//! let hand = Robot::named("hand")?.with_scene(&Scene::CYLINDER)?;
//! assert!(mjcf::export(&hand).contains("<body name=\"O1\""), "what it grasps");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod limb;
mod parts;
mod surroundings;

use crate::robot::Robot;
use parts::Parts;
use tip_runtime::model::Point;
use tip_runtime::plant::Pose;

/// Radius of a contact shape around a point or line of the plants, m.
const SKIN: f64 = 1e-3;

/// Returns a robot in its [scene](Robot::with_scene) as MJCF.
///
/// Joints, and the position motors that turn them, are called `J11` to `Jnm`, the bodies that they carry `link11` to `linknm`; feet
/// or fingertips are the sites and touch sensors `F1` to `Fn`. The first keyframe, `initial`, is the initial posture.
#[must_use]
pub fn export(robot: &Robot) -> String {
    let (anatomy, shapes) = (robot.anatomy(), robot.shapes());
    let initial_state = robot.initial_state();
    let mut parts = Parts::default();
    if initial_state.pose.is_some() {
        surroundings::ground(&mut parts, robot.scene());
    }
    limb::base(&mut parts, &anatomy, &initial_state, &shapes.body);
    for (number, leg) in (1..).zip(&anatomy.legs) {
        limb::leg(
            &mut parts,
            number,
            leg,
            &anatomy,
            shapes,
            initial_state.objects.is_some(),
        );
    }
    if let Some(slider) = &anatomy.slider {
        surroundings::slider(&mut parts, slider, &anatomy, robot.scene());
    }
    if let Some(objects) = &initial_state.objects {
        surroundings::objects(&mut parts, &anatomy, robot.scene(), objects);
    }
    parts.world.close("body");
    parts.text(robot.name())
}

/// Converts a point or vector from mm to m.
fn metres(of: Point) -> [f64; 3] {
    of.map(|mm| mm / 1000.0)
}

/// Returns the attitude of a body: w, x, y, z.
fn quaternion(pose: &Pose) -> [f64; 4] {
    let half = |degrees: f64| libm::sincos(degrees.to_radians() / 2.0);
    let ((sy, cy), (sp, cp), (sr, cr)) = (half(pose.yaw), half(pose.pitch), half(pose.roll));
    // Yaw about z, then pitch about x, then roll about y.
    let [w, x, y, z] = [cy * cp, cy * sp, sy * sp, sy * cp];
    [
        w * cr - y * sr,
        x * cr - z * sr,
        w * sr + y * cr,
        x * sr + z * cr,
    ]
}
