//! The surroundings of a simulated robot: a floor, blocks, and objects to grasp.
//!
//! ```
//! use tip_runtime::scene::{Object, Scene, SceneError, Shape};
//!
//! let ball = Object {
//!     shape: Shape::Disc { radius: 20.0 },
//!     mass: 0.2,
//!     friction: 0.8,
//!     x: 0.0,
//!     y: None,
//!     angle: 0.0,
//! };
//! let scene = Scene::EMPTY.with_object(ball)?;
//! assert_eq!(scene.objects[0], Some(ball));
//!
//! let grain = Object { shape: Shape::Disc { radius: 1.0 }, ..ball };
//! assert_eq!(scene.with_object(grain), Err(SceneError::Size));
//! # Ok::<(), SceneError>(())
//! ```

use core::fmt;

/// Maximum number of blocks in a scene.
pub const BLOCKS: usize = 8;

/// Maximum number of objects in a scene.
pub const OBJECTS: usize = 4;

/// Minimum mass of an object, kg. Lighter objects would need too many time steps.
const LIGHTEST: f64 = 0.001;

/// Minimum size of an object, mm. Smaller objects would slip through contacts.
const SMALLEST: f64 = 2.0;

/// The outline of an object in the x–y plane; along z it is as wide as the hand. A cylinder that
/// stands upright shows the outline of a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A cylinder that lies along z.
    Disc {
        /// The radius, mm.
        radius: f64,
    },
    /// A box.
    Box {
        /// Along x at angle 0: mm.
        width: f64,
        /// Along y at angle 0: mm.
        height: f64,
    },
}

/// An object that may move in the x–y plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its outline.
    pub shape: Shape,
    /// kg.
    pub mass: f64,
    /// The coefficient of Coulomb friction; where two things touch the smaller one counts.
    pub friction: f64,
    /// Initial x of its centre, mm.
    pub x: f64,
    /// Initial y of its centre, mm; `None` for an object that stands on the floor.
    pub y: Option<f64>,
    /// Initial angle, deg.
    pub angle: f64,
}

/// A plane on which the robot stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Floor {
    /// Height above the world's origin, mm.
    pub height: f64,
    /// Rise for each mm along x and along y.
    pub slope: [f64; 2],
}

impl Floor {
    /// A level floor at height 0.
    pub const LEVEL: Self = Floor {
        height: 0.0,
        slope: [0.0, 0.0],
    };
}

/// A box that stands on the floor and never moves, for robots with mass: a step, or an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Extent along x, mm.
    pub x: [f64; 2],
    /// Extent along y, mm.
    pub y: [f64; 2],
    /// Height of its upper side above the world's origin, mm.
    pub height: f64,
}

/// The kind of simulation of a walking robot. A hand has mass either way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Simulation {
    /// Without mass: [`SimulatedPlant`](crate::plant::SimulatedPlant).
    QuasiStatic,
    /// The body has mass: [`DynamicPlant`](crate::plant::DynamicPlant).
    Dynamic,
}

impl Simulation {
    /// The names of all kinds, as scenes and `--plant` write them.
    pub const NAMES: [(&str, Self); 2] = [
        ("quasi-static", Simulation::QuasiStatic),
        ("dynamic", Simulation::Dynamic),
    ];
}

/// A floor and up to [`OBJECTS`] objects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scene {
    /// The kind of simulation of a walking robot; `None` leaves it open: quasi-static.
    pub plant: Option<Simulation>,
    /// The floor of a walking robot. Under a hand, the slider carries it: its height counts from
    /// the slider's, and it rises along x only.
    pub floor: Floor,
    /// The floor's coefficient of Coulomb friction.
    pub friction: f64,
    /// The objects.
    pub objects: [Option<Object>; OBJECTS],
    /// Obstacles for a robot with mass.
    pub blocks: [Option<Block>; BLOCKS],
}

impl Scene {
    /// A level floor (friction 0.5) and nothing on it.
    pub const EMPTY: Self = Scene {
        plant: None,
        floor: Floor::LEVEL,
        friction: 0.5,
        objects: [None; OBJECTS],
        blocks: [None; BLOCKS],
    };

    /// A cylinder that stands upright under the middle of the palm: 200 mm across, 60 mm high, 0.6
    /// kg, as rough as rubber (1.5).
    ///
    /// Fingers in their initial posture nearly touch it. Equal torques in all joints push a fingertip
    /// along a line that is parallel to the straight finger above it, 50 deg upwards, and only so
    /// rough a side does not let it slip.
    pub const CYLINDER: Self = {
        let mut scene = Scene::EMPTY;
        scene.objects[0] = Some(Object {
            shape: Shape::Box {
                width: 200.0,
                height: 60.0,
            },
            mass: 0.6,
            friction: 1.5,
            x: 0.0,
            y: None,
            angle: 0.0,
        });
        scene
    };

    /// The scenes that have a name.
    pub const NAMES: &'static [&'static str] = &["cylinder"];

    /// Returns the scene of a name of `--scene`.
    pub fn by_name(name: &str) -> Option<Self> {
        (Scene::NAMES.contains(&name)).then_some(Scene::CYLINDER)
    }

    /// Adds a block to the scene.
    ///
    /// # Errors
    /// The block is invalid, or the scene is full.
    pub fn with_block(mut self, block: Block) -> Result<Self, SceneError> {
        let Block { x, y, height } = block;
        let numbers = [x[0], x[1], y[0], y[1], height];
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(SceneError::Place);
        }
        if !(x[1] - x[0] >= SMALLEST && y[1] - y[0] >= SMALLEST) {
            return Err(SceneError::Size);
        }
        let place = self.blocks.iter_mut().find(|place| place.is_none());
        *place.ok_or(SceneError::Blocks)? = Some(block);
        Ok(self)
    }

    /// Adds an object to the scene.
    ///
    /// # Errors
    /// The object is invalid, or the scene is full.
    pub fn with_object(mut self, object: Object) -> Result<Self, SceneError> {
        object.check()?;
        let place = self.objects.iter_mut().find(|place| place.is_none());
        *place.ok_or(SceneError::Full)? = Some(object);
        Ok(self)
    }
}

impl Object {
    /// Checks that the scene can be simulated.
    ///
    /// # Errors
    /// The first invalid part of the scene.
    pub fn check(&self) -> Result<(), SceneError> {
        let sizes = match self.shape {
            Shape::Disc { radius } => [radius, radius],
            Shape::Box { width, height } => [width, height],
        };
        let large = |size: &f64| size.is_finite() && *size >= SMALLEST;
        let placed = [self.x, self.y.unwrap_or(0.0), self.angle];
        if !sizes.iter().all(large) {
            Err(SceneError::Size)
        } else if !(self.mass.is_finite() && self.mass >= LIGHTEST) {
            Err(SceneError::Mass)
        } else if !(self.friction.is_finite() && self.friction >= 0.0) {
            Err(SceneError::Friction)
        } else if !placed.iter().all(|number| number.is_finite()) {
            Err(SceneError::Place)
        } else {
            Ok(())
        }
    }
}

impl Default for Scene {
    fn default() -> Self {
        Scene::EMPTY
    }
}

/// The reason why a scene or a part of it is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneError {
    /// The scene already has [`OBJECTS`] objects.
    Full,
    /// The scene already has [`BLOCKS`] blocks.
    Blocks,
    /// It is too small, or its size is not a number.
    Size,
    /// It is too light, or its mass is not a number.
    Mass,
    /// Its friction is negative or no number.
    Friction,
    /// Its position is not a number.
    Place,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneError::Full => write!(f, "a scene has room for {OBJECTS} objects"),
            SceneError::Blocks => write!(f, "a scene has room for {BLOCKS} blocks"),
            SceneError::Size => write!(f, "an object measures at least {SMALLEST} mm"),
            SceneError::Mass => write!(f, "an object's mass is at least {LIGHTEST} kg"),
            SceneError::Friction => f.write_str("friction is 0 or more"),
            SceneError::Place => f.write_str("a place and an angle are finite numbers"),
        }
    }
}

impl core::error::Error for SceneError {}
