//! A robot of some size, ready to be simulated.

use crate::desk::Desk;
use crate::echo::Echo;
use crate::engine::Engine;
use crate::native::Native;
use crate::plant::Plant;
use crate::rig::Rig;
use crate::shell::Shell;
use tip_runtime::command::Port;
use tip_runtime::machine::{Machine, Mismatch};
use tip_runtime::model::Model;
use tip_runtime::plant::{self, Scene, SimulatedHand, SimulatedPlant};
use tipc::Facts;

/// What a robot is made of, whatever its size.
pub(crate) trait Body {
    fn boxed(&self) -> Box<dyn Body>;
    fn facts(&self) -> Facts;
    fn grasps(&self) -> bool;
    fn has_input(&self, plant: Plant, scene: &Scene, port: Port) -> bool;
    fn start(
        &self,
        plant: Plant,
        scene: &Scene,
        program: Engine,
        desk: Desk,
        special: Native,
    ) -> Result<Box<dyn Shell>, Mismatch>;
}

impl Clone for Box<dyn Body> {
    fn clone(&self) -> Self {
        (**self).boxed()
    }
}

/// A model, and what simulates it.
#[derive(Clone)]
pub(crate) struct Sized<const L: usize, const J: usize> {
    model: &'static Model<L, J>,
    hardware: Hardware<L, J>,
}

#[derive(Clone)]
enum Hardware<const L: usize, const J: usize> {
    Walker,
    /// Made where its size is known, so that only hands of that size are compiled.
    Hand(fn(&Model<L, J>, &Scene) -> Rig<L, J>),
    Own(Rig<L, J>),
}

impl<const L: usize, const J: usize> Sized<L, J> {
    pub(crate) fn walker(model: &'static Model<L, J>) -> Self {
        Sized {
            model,
            hardware: Hardware::Walker,
        }
    }

    pub(crate) fn hand(model: &'static Model<L, J>) -> Self {
        Sized {
            model,
            hardware: Hardware::Hand(|model, scene| {
                Rig::new(SimulatedHand::new(model).with_scene(scene))
            }),
        }
    }

    pub(crate) fn own(
        model: &'static Model<L, J>,
        plant: impl plant::Plant<L, J> + Clone + 'static,
    ) -> Self {
        Sized {
            model,
            hardware: Hardware::Own(Rig::new(plant)),
        }
    }

    fn rig(&self, plant: Plant, scene: &Scene) -> Rig<L, J> {
        match (plant, &self.hardware) {
            (_, Hardware::Own(rig)) => rig.clone(),
            (Plant::Echo, _) => Rig::new(Echo::new(self.model)),
            (Plant::Simulated, Hardware::Hand(make)) => make(self.model, scene),
            (Plant::Simulated, Hardware::Walker) => {
                Rig::new(SimulatedPlant::new(self.model).with_floor(scene.floor))
            }
        }
    }
}

impl<const L: usize, const J: usize> Body for Sized<L, J> {
    fn boxed(&self) -> Box<dyn Body> {
        Box::new(self.clone())
    }

    fn facts(&self) -> Facts {
        Facts::of(self.model)
    }

    fn grasps(&self) -> bool {
        !matches!(self.hardware, Hardware::Walker)
    }

    fn has_input(&self, plant: Plant, scene: &Scene, port: Port) -> bool {
        plant::Plant::set_sensor(&mut self.rig(plant, scene), port, 0.0)
    }

    fn start(
        &self,
        plant: Plant,
        scene: &Scene,
        program: Engine,
        desk: Desk,
        special: Native,
    ) -> Result<Box<dyn Shell>, Mismatch> {
        let rig = self.rig(plant, scene);
        let machine = Machine::new(program, self.model, rig, desk, special)?;
        Ok(Box::new(machine))
    }
}
