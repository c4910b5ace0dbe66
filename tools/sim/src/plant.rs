//! The choice of a plant.

use tip_runtime::plant::{Scene, Simulation};

/// The simulation of the robot's joints and surroundings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Plant {
    /// The simulation that the scene asks for; by default a walking robot rests on its feet and has
    /// no inertia.
    #[default]
    Simulated,
    /// Everything has mass, whatever the scene asks for.
    Dynamic,
    /// Joints that are immediately where they are commanded to be: cheap, for comparing engines.
    Echo,
}

impl Plant {
    /// Returns the simulation of a walking robot in a scene; `None` if only its joints are
    /// simulated.
    pub(crate) fn walking(self, scene: &Scene) -> Option<Simulation> {
        // Nothing but mass meets a block.
        let open = match scene.blocks.iter().flatten().next() {
            Some(_) => Simulation::Dynamic,
            None => Simulation::QuasiStatic,
        };
        match self {
            Plant::Simulated => Some(scene.plant.unwrap_or(open)),
            Plant::Dynamic => Some(Simulation::Dynamic),
            Plant::Echo => None,
        }
    }
}
