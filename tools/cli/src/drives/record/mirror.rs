//! Left and right of a robot: the joint angles of the mirror image of a pose.

use tip_runtime::model::Joint;
use tip_sim::{Limb, RobotDescription};

/// Largest difference of places that count as mirrored, mm, and of components of axes.
const NEAR: f64 = 0.5;
const PARALLEL: f64 = 1e-3;

/// The legs of a robot as mirror images of each other, left and right (x changes its sign).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mirror {
    /// For each joint, leg by leg: the joint whose image it is, and the factor of the angle.
    sources: Vec<(usize, f64)>,
}

impl Mirror {
    /// Finds the mirror image of each leg.
    ///
    /// # Errors
    /// The first leg that has none, from 0.
    pub(super) fn of(description: &RobotDescription) -> Result<Self, usize> {
        let mut sources = Vec::new();
        for (number, leg) in description.legs.iter().enumerate() {
            let others = description.legs.iter().enumerate();
            let mut images =
                others.filter_map(|(other, source)| Some((other, signs(source, leg)?)));
            let (other, signs) = images.next().ok_or(number)?;
            let first = other * description.joints;
            sources.extend((first..).zip(signs));
        }
        Ok(Mirror { sources })
    }

    /// Returns the angles of the mirror image of a pose.
    pub(super) fn image(&self, angles: &[f64]) -> Vec<f64> {
        let image = |(source, sign): &(usize, f64)| sign * angles[*source] + 0.0;
        self.sources.iter().map(image).collect()
    }
}

/// Returns the factors of the joint angles if one leg is the mirror image of another one.
fn signs(source: &Limb, image: &Limb) -> Option<Vec<f64>> {
    let joints = source.joints.iter().zip(&image.joints);
    let is_image = is_near(reflected(source.base), image.base, NEAR)
        && source.joints.len() == image.joints.len();
    is_image
        .then(|| joints.map(|(source, image)| sign(source, image)).collect())
        .flatten()
}

/// Returns the factor of the angle of a joint that is the mirror image of another one. A reflection turns a rotation round: about the
/// reflected axis the angle has the other sign.
fn sign(source: &Joint, image: &Joint) -> Option<f64> {
    let axis = reflected(source.axis);
    if !is_near(reflected(source.link), image.link, NEAR) {
        return None;
    }
    match image.axis {
        same if is_near(axis, same, PARALLEL) => Some(-1.0),
        opposite if is_near(axis, opposite.map(|part| -part), PARALLEL) => Some(1.0),
        _ => None,
    }
}

fn reflected([x, y, z]: [f64; 3]) -> [f64; 3] {
    [-x, y, z]
}

fn is_near(one: [f64; 3], other: [f64; 3], most: f64) -> bool {
    let mut parts = one.into_iter().zip(other);
    parts.all(|(one, other)| (one - other).abs() <= most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tip_runtime::random::Random;
    use tip_sim::Robot;

    /// Compares the feet of a mirrored pose, by the kinematics of the robot, with the mirrored feet of the pose.
    #[test]
    fn feet_of_the_image_are_images_of_feet() {
        for name in ["phantomx", "spotmicro", "a1", "titan8"] {
            let description = Robot::named(name).expect("a robot").description();
            let mirror = Mirror::of(&description).expect("mirrored legs");
            let mut random = Random::new(7);
            let pose: Vec<f64> = mirror
                .sources
                .iter()
                .map(|_| random.within(-40.0, 40.0))
                .collect();
            let image = mirror.image(&pose);
            let foot = |angles: &[f64], leg: usize| {
                let first = leg * description.joints;
                description.legs[leg].foot(&angles[first..first + description.joints])
            };
            let mut seen = vec![];
            for leg in 0..description.legs.len() {
                let source = mirror.sources[leg * description.joints].0 / description.joints;
                let wanted = reflected(foot(&pose, source));
                assert!(
                    is_near(foot(&image, leg), wanted, 2.0 * NEAR),
                    "{name}: F{}",
                    leg + 1
                );
                seen.push(source);
            }
            seen.sort_unstable();
            let all: Vec<usize> = (0..description.legs.len()).collect();
            assert_eq!(seen, all, "{name}: each leg is one image");
            assert_eq!(mirror.image(&image), pose, "{name}: twice is nothing");
        }
    }

    #[test]
    fn a_leg_without_an_image_is_named() {
        let two = |other: &str| {
            let text = format!(
                "name = \"two\"\njoint = [{{ axis = \"z\", link = [50, 0, 0], limits = [-90, 90] }}]\n\
                 leg = [{{ base = [-80, 0, 0], mirror = \"x\" }}, {{ base = [{other}, 0] }}]\n"
            );
            let description = Robot::from_description(&text)
                .expect("a description")
                .description();
            Mirror::of(&description)
        };
        assert!(two("80, 0").is_ok());
        assert_eq!(two("80, 10"), Err(0));
        // Both are images of themselves, but their links point to one side.
        assert_eq!(two("0, 10"), Err(0));
    }
}
