//! Simulated robots of any size.

use crate::dyn_machine::{DynMachine, NativeCommands};

use crate::ideal_joints::IdealJoints;
use crate::model::{DynModel, Miss, RobotDescription};
use crate::program_runner::ProgramRunner;
use crate::sim_hardware::{DynHardware, OfSize, SimHardware};
use std::fmt;
use std::sync::Arc;
use tip_runtime::command::{Op, Port, Target};
use tip_runtime::machine::Mismatch;
use tip_runtime::model::{Model, Range, generic, hand, titan8};
use tip_runtime::plant::{self, Distances, Scene, SimulatedHand, Simulation};
use tip_runtime::special::Special;
use tip_runtime::special::hand::{HandSpecials, NUMBERS};
use tipc::description::Shapes;
use tipc::{Facts, Options, published};

/// A robot before its first control cycle: its model, how it is simulated, and its SPECIAL commands.
#[derive(Clone)]
pub struct Robot {
    model: Arc<dyn DynModel>,
    facts: Facts,
    hardware: Hardware,
    plant: Plant,
    scene: Scene,
    special: Box<dyn NativeCommands>,
    /// The SPECIAL commands that are the robot's own; `None` if user code answers.
    answers: Option<&'static [u8]>,
    shapes: Arc<Shapes>,
}

/// The kind of robot that is simulated.
#[derive(Clone)]
enum Hardware {
    Walker,
    /// Creates a hand. The function comes from a place where its size is known, so that only hands of that size are
    /// compiled.
    Hand(fn(&Scene) -> Box<dyn DynHardware>),
    Own(Box<dyn DynHardware>),
}

/// State of a robot and the objects around it before the first control cycle.
pub(crate) struct InitialState {
    /// Pose of the body; `None` if it is bolted down.
    pub(crate) pose: Option<plant::Pose>,
    /// The objects that a hand is to grasp, in the order of the scene; `None` for any other robot.
    pub(crate) objects: Option<Vec<plant::ObjectState>>,
}

impl Robot {
    /// Returns a robot that has a name: `titan8`, `hand` or `generic`, which the language knows, or
    /// one of those that are [`published`](tipc::published). The hand has its SPECIAL commands.
    ///
    /// # Errors
    /// There is no robot of that name.
    pub fn named(name: &str) -> Result<Self, UnknownRobot> {
        let walker = |model| Ok(Self::of(model));
        match name {
            _ if name == titan8::MODEL.name => walker(&titan8::MODEL),
            _ if name == generic::MODEL.name => walker(&generic::MODEL),
            _ if name == hand::MODEL.name => {
                let hand = Self::new(&hand::MODEL, Hardware::Hand(simulated_hand));
                Ok(Robot {
                    answers: Some(NUMBERS),
                    ..hand.with_special(HandSpecials::new())
                })
            }
            _ => Self::published(name).ok_or_else(|| UnknownRobot(name.to_owned())),
        }
    }

    /// Creates a walking robot of a model, such as `include_robot!` makes.
    pub fn of<const L: usize, const J: usize>(model: &Model<L, J>) -> Self {
        Self::new(model, Hardware::Walker)
    }

    /// Creates a robot of a model with a plant of its own.
    pub fn on<const L: usize, const J: usize>(
        model: &Model<L, J>,
        plant: impl plant::Plant<L, J> + Clone + Send + 'static,
    ) -> Self {
        Self::new(model, Hardware::Own(OfSize::boxed(plant)))
    }

    fn new<const L: usize, const J: usize>(model: &Model<L, J>, hardware: Hardware) -> Self {
        Robot {
            model: Arc::new(*model),
            facts: Facts::copied(model),
            hardware,
            plant: Plant::default(),
            scene: Scene::EMPTY,
            special: Box::new(()),
            answers: Some(&[]),
            shapes: Arc::default(),
        }
    }

    /// Sets the kind of simulation. A robot with a plant of its own keeps that.
    #[must_use]
    pub fn with_plant(mut self, plant: Plant) -> Self {
        self.plant = plant;
        self
    }

    /// Puts a floor under the robot, and objects if it is a hand. A robot with a plant of its own has its own
    /// surroundings.
    ///
    /// # Errors
    /// There are objects, and the robot cannot grasp.
    pub fn with_scene(mut self, scene: &Scene) -> Result<Self, GraspsNothing> {
        let has_objects = scene.objects.iter().any(Option::is_some);
        if has_objects && matches!(self.hardware, Hardware::Walker) {
            return Err(GraspsNothing(self.name()));
        }
        self.scene = *scene;
        Ok(self)
    }

    /// Returns its surroundings, unless it has a plant of its own.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Sets the native code that answers SPECIAL. For a hand that is usually
    /// [`HandSpecials::with_user`](tip_runtime::special::hand::HandSpecials::with_user) with that code.
    #[must_use]
    pub fn with_special(mut self, special: impl Special + Clone + Send + 'static) -> Self {
        self.special = Box::new(special);
        self.answers = None;
        self
    }

    /// Returns the SPECIAL commands that are its own; `None` if its owner's code answers.
    pub(crate) fn answers(&self) -> Option<&'static [u8]> {
        self.answers
    }

    /// Returns its name.
    pub fn name(&self) -> &'static str {
        self.facts.signature.robot
    }

    /// Returns the facts that programs for it are checked for.
    pub fn facts(&self) -> Facts {
        self.facts
    }

    /// Returns its parts.
    pub fn description(&self) -> RobotDescription {
        self.model.description()
    }

    /// Returns its shapes in a description.
    pub fn shapes(&self) -> &Shapes {
        &self.shapes
    }

    pub(crate) fn with_shapes(mut self, shapes: Shapes) -> Self {
        self.shapes = Arc::new(shapes);
        self
    }

    /// Returns its initial state and that of the objects around it, if everything has mass.
    pub(crate) fn initial_state(&self) -> InitialState {
        let hardware = self.clone().with_plant(Plant::Dynamic).simulated();
        InitialState {
            pose: hardware.pose(),
            objects: hardware.grasp().map(|grasp| grasp.objects),
        }
    }

    /// Returns the options for loading programs for it.
    pub fn options(&self) -> Options {
        Options {
            robot: tipc::Robot::Described(self.facts),
            ..Options::default()
        }
    }

    /// Returns true if it has this input.
    pub fn has_input(&self, port: Port) -> bool {
        SimHardware::new(self.simulated()).has_input(port)
    }

    /// Returns the miss of a PTP or PTP_ANGLE to these numbers, if it does not reach them.
    pub(crate) fn miss(
        &self,
        op: Op,
        target: Target,
        values: &[f64],
        limits: &[Range],
    ) -> Option<Miss> {
        self.model.miss(op, target, values, limits)
    }

    /// Returns the joints that a PTP or PTP_ANGLE turns, with their angles at its end.
    pub(crate) fn turns(
        &self,
        op: Op,
        target: Target,
        values: &[f64],
        from: &[f64],
    ) -> Vec<(usize, f64)> {
        self.model.turns(op, target, values, from)
    }

    /// Returns the distances between its parts.
    pub fn distances(&self) -> Distances {
        self.model.distances()
    }

    /// Returns true if two links, by leg and joint from 0, are compared in a search for collisions.
    pub(crate) fn compares(&self, one: (usize, usize), other: (usize, usize)) -> bool {
        self.model.compares(one, other)
    }

    /// Puts a program on it.
    pub(crate) fn start(&self, program: ProgramRunner) -> Result<Box<dyn DynMachine>, Mismatch> {
        self.start_on(self.simulated(), program)
    }

    /// Puts a program on it, simulated by other hardware of its size.
    pub(crate) fn start_on(
        &self,
        hardware: Box<dyn DynHardware>,
        program: ProgramRunner,
    ) -> Result<Box<dyn DynMachine>, Mismatch> {
        let hardware = SimHardware::new(hardware);
        self.model.machine(program, hardware, self.special.clone())
    }

    fn simulated(&self) -> Box<dyn DynHardware> {
        match (self.plant.walking(&self.scene), &self.hardware) {
            (_, Hardware::Own(hardware)) => hardware.clone(),
            (None, _) => Box::new(IdealJoints::new(&self.description())),
            (Some(_), Hardware::Hand(make)) => make(&self.scene),
            (Some(simulation), Hardware::Walker) => self.model.walker(simulation, &self.scene),
        }
    }
}

fn simulated_hand(scene: &Scene) -> Box<dyn DynHardware> {
    OfSize::boxed(SimulatedHand::new(&hand::MODEL).with_scene(scene))
}

impl fmt::Debug for Robot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Robot")
            .field("name", &self.name())
            .field("plant", &self.plant)
            .field("scene", &self.scene)
            .finish_non_exhaustive()
    }
}

/// No robot has this name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownRobot(String);

impl fmt::Display for UnknownRobot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "'{}' is not a robot: the robots are titan8, hand and generic, ",
            self.0
        )?;
        for robot in published::ALL {
            write!(f, "{}, ", robot.name)?;
        }
        f.write_str("and any other one by its description")
    }
}

impl std::error::Error for UnknownRobot {}

/// A scene has objects, and this robot cannot grasp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GraspsNothing(&'static str);

impl fmt::Display for GraspsNothing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} grasps nothing", self.0)
    }
}

impl std::error::Error for GraspsNothing {}

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
        // Only a robot with mass can touch a block.
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
