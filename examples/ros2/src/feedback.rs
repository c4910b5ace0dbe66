//! The angles of the robot's joints, as messages of other nodes report them, with their age.

/// Legs of the robot.
pub const LEGS: usize = 4;
/// Joints of each leg.
pub const JOINTS: usize = 3;

/// Cycles after which an angle is too old to move the robot by it.
pub const SILENCE: u32 = 10;

/// The angle of a joint.
#[derive(Clone, Copy, Debug, Default)]
struct Angle {
    /// deg.
    value: f64,
    /// Cycles since it was reported.
    age: u32,
}

/// The last angle of each joint. The robot has feedback while all of them are known and none is old.
#[derive(Clone, Debug, Default)]
pub struct Feedback([[Option<Angle>; JOINTS]; LEGS]);

/// Returns the name of a joint (leg and joint, from 0) in messages.
pub fn name(leg: usize, joint: usize) -> String {
    format!("J{}{}", leg + 1, joint + 1)
}

impl Feedback {
    /// Takes in a message: names, and a position for each of them, rad. Other names, names without a position and positions that
    /// are not finite are left out. Returns true if it held the angle of a joint.
    pub fn take(&mut self, names: &[String], positions: &[f64]) -> bool {
        let mut is_ours = false;
        for (leg, angles) in self.0.iter_mut().enumerate() {
            for (joint, angle) in angles.iter_mut().enumerate() {
                let own = self::name(leg, joint);
                let reported = names.iter().zip(positions);
                let mut positions =
                    reported.filter(|(name, position)| **name == own && position.is_finite());
                if let Some((_, position)) = positions.next_back() {
                    let value = position.to_degrees();
                    *angle = Some(Angle { value, age: 0 });
                    is_ours = true;
                }
            }
        }
        is_ours
    }

    /// Lets a cycle pass.
    pub fn grow_older(&mut self) {
        for angle in self.0.iter_mut().flatten().flatten() {
            angle.age = angle.age.saturating_add(1);
        }
    }

    /// Returns the angles, deg.
    ///
    /// # Errors
    /// The first joint (leg and joint, from 1) whose angle is unknown or too old.
    pub fn angles(&self) -> Result<[[f64; JOINTS]; LEGS], (u8, u8)> {
        let mut angles = [[0.0; JOINTS]; LEGS];
        for ((leg, known), angles) in (1..).zip(&self.0).zip(&mut angles) {
            for ((joint, known), angle) in (1..).zip(known).zip(angles) {
                let fresh = known.filter(|known| known.age <= SILENCE);
                *angle = fresh.ok_or((leg, joint))?.value;
            }
        }
        Ok(angles)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> Vec<String> {
        let joints = (0..LEGS).flat_map(|leg| (0..JOINTS).map(move |joint| name(leg, joint)));
        joints.collect()
    }

    const ALL: [f64; 12] = [0.5; 12];

    #[test]
    fn finite_positions_of_all_joints_are_feedback() {
        let mut feedback = Feedback::default();
        assert_eq!(feedback.angles(), Err((1, 1)));
        assert!(feedback.take(&names(), &ALL));
        let angles = feedback.angles().expect("all are known");
        assert_eq!(angles, [[0.5_f64.to_degrees(); 3]; 4]);
    }

    #[test]
    fn what_is_no_angle_of_the_robot_is_no_feedback() {
        let gripper = ["left_finger".to_owned(), "right_finger".to_owned()];
        for (names, positions) in [
            (&gripper[..], &[0.1, 0.1][..]),
            (&names(), &[f64::NAN; 12]),
            (&names(), &[f64::INFINITY; 12]),
            // Velocities or efforts alone.
            (&names(), &[]),
            (&[], &ALL),
        ] {
            let mut feedback = Feedback::default();
            assert!(!feedback.take(names, positions), "{names:?} {positions:?}");
            assert_eq!(feedback.angles(), Err((1, 1)), "{names:?} {positions:?}");
        }
    }

    #[test]
    fn each_joint_has_to_be_known_whatever_message_it_comes_in() {
        let names = names();
        let mut feedback = Feedback::default();
        // A message may hold fewer positions than names, and joints of others in between.
        assert!(feedback.take(&names, &ALL[..5]));
        assert_eq!(feedback.angles(), Err((2, 3)));
        let mut others = names[5..].to_vec();
        others.insert(3, "gripper".to_owned());
        let mut positions = vec![0.5; 8];
        positions[7] = f64::NAN;
        assert!(feedback.take(&others, &positions));
        assert_eq!(feedback.angles(), Err((4, 3)));
        assert!(feedback.take(&names[11..], &[0.5]));
        assert!(feedback.angles().is_ok());
    }

    #[test]
    fn each_angle_grows_old_by_itself() {
        let names = names();
        let mut feedback = Feedback::default();
        feedback.take(&names, &ALL);
        for _ in 0..SILENCE {
            feedback.grow_older();
            // All joints but J23 are reported, which reports nonsense.
            let mut positions = ALL;
            positions[5] = f64::NAN;
            feedback.take(&names, &positions);
            assert!(feedback.angles().is_ok());
        }
        feedback.grow_older();
        assert_eq!(feedback.angles(), Err((2, 3)));
        feedback.take(&names, &ALL);
        assert!(feedback.angles().is_ok(), "it is back");
    }
}
