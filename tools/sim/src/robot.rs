//! Simulated robots, whatever their size.

use crate::body::{Anatomy, Around, Body, Miss, Seats, Sized};
use crate::desk::Desk;
use crate::engine::Engine;
use crate::native::Native;
use crate::outside::Outside;
use crate::plant::Plant;
use crate::shell::Shell;
use std::fmt;
use std::rc::Rc;
use tip_runtime::command::{Op, Port, Target};
use tip_runtime::machine::Mismatch;
use tip_runtime::model::{Model, generic, hand, titan8};
use tip_runtime::plant::{self, Scene};
use tip_runtime::special::Special;
use tip_runtime::special::hand::{HandSpecials, NUMBERS};
use tipc::description::Shapes;
use tipc::{Facts, Options, published};

/// A robot before its first control cycle: its model, how it is simulated, and its SPECIAL commands.
#[derive(Clone)]
pub struct Robot {
    body: Rc<dyn Body>,
    facts: Facts,
    grasps: bool,
    around: Around,
    special: Native,
    /// The SPECIAL commands that are the robot's own; `None` if someone else's code answers.
    answers: Option<&'static [u8]>,
    shapes: Rc<Shapes>,
}

impl Robot {
    /// A robot that has a name: `titan8`, `hand` or `generic`, which the language knows, or one of those that are
    /// [`published`](tipc::published). The hand has its SPECIAL commands.
    ///
    /// # Errors
    /// There is no robot of that name.
    pub fn named(name: &str) -> Result<Self, UnknownRobot> {
        let walker = |model| Ok(Self::of(model));
        match name {
            _ if name == titan8::MODEL.name => walker(&titan8::MODEL),
            _ if name == generic::MODEL.name => walker(&generic::MODEL),
            _ if name == hand::MODEL.name => {
                let body = Rc::new(Sized::hand(&hand::MODEL));
                let hand = Self::new(body, Facts::of(&hand::MODEL), true);
                Ok(Robot {
                    answers: Some(NUMBERS),
                    ..hand.with_special(HandSpecials::new())
                })
            }
            _ => Self::published(name).ok_or_else(|| UnknownRobot(name.to_owned())),
        }
    }

    /// A walking robot of a model, such as `include_robot!` makes.
    pub fn of<const L: usize, const J: usize>(model: &'static Model<L, J>) -> Self {
        Self::new(Rc::new(Sized::walker(model)), Facts::of(model), false)
    }

    /// A robot of a model with a plant of its own.
    pub fn on<const L: usize, const J: usize>(
        model: &'static Model<L, J>,
        plant: impl plant::Plant<L, J> + Clone + 'static,
    ) -> Self {
        let body = Rc::new(Sized::own(model, plant));
        Self::new(body, Facts::of(model), true)
    }

    pub(crate) fn new(body: Rc<dyn Body>, facts: Facts, grasps: bool) -> Self {
        Robot {
            body,
            facts,
            grasps,
            around: Around {
                plant: Plant::default(),
                scene: Scene::EMPTY,
            },
            special: Native::new(()),
            answers: Some(&[]),
            shapes: Rc::default(),
        }
    }

    /// Chooses how it is simulated. A robot with a plant of its own keeps it.
    #[must_use]
    pub fn with_plant(mut self, plant: Plant) -> Self {
        self.around.plant = plant;
        self
    }

    /// Puts a floor under the robot, and objects if it is a hand. A robot with a plant of its own has its own
    /// surroundings.
    ///
    /// # Errors
    /// There are objects, and the robot cannot grasp.
    pub fn with_scene(mut self, scene: &Scene) -> Result<Self, GraspsNothing> {
        let has_objects = scene.objects.iter().any(Option::is_some);
        if has_objects && !self.grasps {
            return Err(GraspsNothing(self.name()));
        }
        self.around.scene = *scene;
        Ok(self)
    }

    /// What surrounds it, unless it has a plant of its own.
    pub fn scene(&self) -> &Scene {
        &self.around.scene
    }

    /// Answers SPECIAL by native code of its owner; for a hand that is usually
    /// [`HandSpecials::with_user`](tip_runtime::special::hand::HandSpecials::with_user) it.
    #[must_use]
    pub fn with_special(mut self, special: impl Special + Clone + 'static) -> Self {
        self.special = Native::new(special);
        self.answers = None;
        self
    }

    /// The SPECIAL commands that are its own; `None` if its owner's code answers.
    pub(crate) fn answers(&self) -> Option<&'static [u8]> {
        self.answers
    }

    /// What it is called.
    pub fn name(&self) -> &'static str {
        self.facts.signature.robot
    }

    /// What programs for it are checked for.
    pub fn facts(&self) -> Facts {
        self.facts
    }

    /// What it has.
    pub fn anatomy(&self) -> Anatomy {
        self.body.anatomy()
    }

    /// What a description says that it looks like.
    pub fn shapes(&self) -> &Shapes {
        &self.shapes
    }

    pub(crate) fn with_shapes(mut self, shapes: Shapes) -> Self {
        self.shapes = Rc::new(shapes);
        self
    }

    /// How it and what is around it begin.
    pub(crate) fn beginning(&self) -> crate::body::Beginning {
        self.body.beginning(&self.around)
    }

    /// How programs for it are loaded.
    pub fn options(&self) -> Options {
        Options {
            robot: tipc::Robot::Described(self.facts),
            ..Options::default()
        }
    }

    /// Whether it has this input.
    pub fn has_input(&self, port: Port) -> bool {
        self.body.has_input(&self.around, port)
    }

    /// What a PTP or PTP_ANGLE to these numbers misses, if it does.
    pub(crate) fn miss(&self, op: Op, target: Target, values: &[f64]) -> Option<Miss> {
        self.body.miss(op, target, values)
    }

    /// Puts a program on it.
    pub(crate) fn start(&self, program: Engine, desk: Desk) -> Result<Box<dyn Shell>, Mismatch> {
        self.body.start(&self.around, self.seats(program, desk))
    }

    /// Puts a program on it, and has it simulated outside.
    pub(crate) fn start_outside(
        &self,
        program: Engine,
        desk: Desk,
        outside: Box<dyn Outside>,
    ) -> Result<Box<dyn Shell>, Mismatch> {
        let mut seats = self.seats(program, desk);
        seats.outside = Some(outside);
        self.body.start(&self.around, seats)
    }

    fn seats(&self, program: Engine, desk: Desk) -> Seats {
        Seats {
            program,
            desk,
            special: self.special.clone(),
            outside: None,
        }
    }
}

impl fmt::Debug for Robot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Robot")
            .field("name", &self.name())
            .field("around", &self.around)
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
