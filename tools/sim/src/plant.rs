//! The choice of a plant.

/// How the robot's joints and surroundings are simulated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Plant {
    /// As the runtime simulates them: servos, gravity, contact.
    #[default]
    Simulated,
    /// Joints that are at once where they are commanded to be: cheap, for comparing engines.
    Echo,
}
