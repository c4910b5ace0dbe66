//! A program on the simulated robot with the commands of its owner, and what became of it.

use crate::native::Native;
use tip_runtime::console::Transcript;
use tip_runtime::machine::Mismatch;
use tip_runtime::model::{Point, titan8};
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;
use tip_runtime::record::Ending;
use tip_sim::{Interpreter, Limit, Observer, Robot, load};

/// The simulated TITAN VIII.
pub type Plant = SimulatedPlant<4, 3>;

/// The result for a run.
#[derive(Clone, Debug)]
pub struct Run {
    /// How it ended.
    pub ending: Ending,
    /// Its trace, with a hash of the robot's state in each record.
    pub trace: String,
    /// Where the body was after each cycle.
    pub path: Vec<Point>,
    /// What the program said, line by line.
    pub said: Vec<String>,
    /// The robot at its end.
    pub plant: Plant,
}

impl Run {
    /// How far the body ever was from its start: mm.
    pub fn excursion(&self) -> f64 {
        self.path.iter().copied().map(away).fold(0.0, f64::max)
    }

    /// How far it was from there in the end: mm.
    pub fn rest(&self) -> f64 {
        self.path.last().copied().map_or(0.0, away)
    }
}

/// How far a point of the path is from its start, along the floor: mm.
fn away([x, y, _]: Point) -> f64 {
    x.hypot(y)
}

/// Runs a program to its end.
///
/// # Errors
/// The program was checked for another robot.
pub fn run(program: impl Program + Clone + Send + 'static, plant: Plant) -> Result<Run, Mismatch> {
    let robot = Robot::on(&titan8::MODEL, plant).with_special(Native::default());
    let mut run = tip_sim::Run::new(program, robot)?
        .with_console(Transcript::default())
        .with_trace(true);
    let mut path = Path(Vec::new());
    let ending = run.observed(Limit::NONE, &mut path);
    let said = run
        .console()
        .map(|shown: &Transcript| shown.messages.clone());
    Ok(Run {
        ending,
        trace: run.trace(),
        path: path.0,
        said: said.unwrap_or_default(),
        plant: run.plant::<Plant>().expect("it was put there").clone(),
    })
}

/// Notes where the body is.
struct Path(Vec<Point>);

impl Observer for Path {
    fn after(&mut self, run: &mut tip_sim::Run) {
        let pose = run.motion().map(|motion| motion.pose);
        self.0.extend(pose.map(|pose| pose.position));
    }
}

/// The reference interpreter of a program's text; `None` if it has errors.
pub fn interpreter(name: &str, text: &str) -> Option<Interpreter> {
    load(name, text, &Robot::of(&titan8::MODEL)).ok()
}
