//! `tipc run`: a program on the simulated robot, by the reference interpreter.

mod emergency;
mod interrupt;
mod logs;
mod progress;
mod screen;
mod simulation;
mod trace;

use super::arguments::Run;
use super::choices::RobotName;
use super::error::Error;
use super::robot::ChosenRobot;
use super::{Status, input, report, scene};
use emergency::describe;
use progress::Progress;
use screen::Screen;
use simulation::{Simulated, Simulation};
use tip_runtime::console::LogFiles;
use tip_runtime::model::{Model, generic, hand, titan8};
use tip_runtime::plant::{Plant, Scene, SimulatedHand, SimulatedPlant};
use tip_runtime::record::Ending;
use tip_runtime::special::Special;
use tip_runtime::special::hand::HandSpecials;
use tipc::description::WithModel;
use tipc::interp::Interpreter;
use tipc::lockstep::Inputs;
use tipc::program::Program;
use tipc::source::Source;
use tipc::{Facts, Robot};
use trace::Trace;

/// Runs the program until it ends, the cycles are used up, or somebody presses Ctrl-C.
pub(super) fn run(arguments: &Run) -> Result<Status, Error> {
    interrupt::catch();
    let robot = match arguments.source.robot.load() {
        Ok(robot) => robot,
        Err(loaded) => {
            report::findings(&loaded, arguments.source.message_format);
            return Ok(Status::Failure);
        }
    };
    let format = arguments.source.message_format;
    let Some(scene) = scene::load(arguments.inputs.scene.as_ref(), format) else {
        return Ok(Status::Failure);
    };
    let run = PlantRun {
        scene: &scene,
        arguments,
    };
    match &robot {
        ChosenRobot::Described(description) => description.with_model(run),
        ChosenRobot::Named(RobotName::Titan8) => run.walk(&titan8::MODEL),
        ChosenRobot::Named(RobotName::Generic) => run.walk(&generic::MODEL),
        ChosenRobot::Named(RobotName::Hand) => run.grasp(&hand::MODEL),
    }
}

/// A run on a robot of any size, over a scene.
struct PlantRun<'a> {
    scene: &'a Scene,
    arguments: &'a Run,
}

impl WithModel for PlantRun<'_> {
    type Output = Result<Status, Error>;

    fn with<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Self::Output {
        self.walk(model)
    }
}

impl PlantRun<'_> {
    /// Runs the program on a walking robot.
    fn walk<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Result<Status, Error> {
        let floor = scene::floor(self.scene, model.name)?;
        let robot = Simulated {
            model,
            plant: SimulatedPlant::new(model).with_floor(floor),
            special: (),
        };
        run_on(robot, self.arguments)
    }

    /// Runs the program on a hand.
    fn grasp<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Result<Status, Error> {
        let robot = Simulated {
            model,
            plant: SimulatedHand::new(model).with_scene(self.scene),
            special: HandSpecials::new(),
        };
        run_on(robot, self.arguments)
    }
}

/// Loads the program and runs it on `robot`.
fn run_on<P: Plant<L, J> + Clone, S: Special, const L: usize, const J: usize>(
    simulated: Simulated<'_, P, S, L, J>,
    arguments: &Run,
) -> Result<Status, Error> {
    let inputs = arguments.inputs.inputs();
    check_sensors(&simulated, &inputs)?;
    let robot = Robot::Described(Facts::of(simulated.model));
    let loaded = input::load(&arguments.file, &arguments.source.options(robot));
    report::findings(&loaded, arguments.source.message_format);
    // The trace first: it changes nothing before the end, and where it cannot be written no log is touched.
    let trace = match (&arguments.trace, &loaded.program) {
        (Some(path), Some(_)) => Some(Trace::begin(path, arguments.trace_state, &arguments.file)?),
        _ => None,
    };
    let logs = match &arguments.out_dir {
        Some(folder) if input::was_read(&loaded) => Some(logs::claim(folder, &loaded)?),
        _ => None,
    };
    match loaded.program {
        Some(program) => simulate(simulated, &inputs, &loaded.source, program, trace, logs),
        None => Ok(Status::Failure),
    }
}

/// Runs a program that was loaded, and tells how it ended.
fn simulate<P: Plant<L, J>, S: Special, const L: usize, const J: usize>(
    robot: Simulated<'_, P, S, L, J>,
    inputs: &Inputs,
    source: &Source,
    program: Program,
    mut trace: Option<Trace>,
    logs: Option<LogFiles<()>>,
) -> Result<Status, Error> {
    let messages = !trace.as_ref().is_some_and(Trace::takes_standard_output);
    let screen = Screen::new(Progress::new(inputs.cycles), messages, logs);
    let mut simulation = Simulation::new(Interpreter::new(program), robot, screen, inputs)?;
    let ending = simulation.run(inputs.cycles, trace.as_mut());
    interrupt::hold();
    let cycles = simulation.cycles();
    let logged = simulation.close();
    let traced = trace.map_or(Ok(()), |trace| trace.end(ending, cycles));
    if let Ending::Emergency(emergency) = &ending {
        report::complain(&describe(emergency, source, simulation.program()));
    }
    traced.and(logged)?;
    Ok(status(&ending))
}

/// The exit status that belongs to an ending.
fn status(ending: &Ending) -> Status {
    match ending {
        Ending::Program(_) | Ending::Limit => Status::Success,
        Ending::Emergency(_) => Status::Emergency,
        Ending::Interrupted => Status::Interrupted,
    }
}

/// Refuses inputs that the robot lacks.
fn check_sensors<P: Plant<L, J> + Clone, S, const L: usize, const J: usize>(
    robot: &Simulated<'_, P, S, L, J>,
    inputs: &Inputs,
) -> Result<(), Error> {
    let mut plant = robot.plant.clone();
    let mut sensors = inputs.sensors.iter();
    match sensors.find(|sensor| !plant.set_sensor(sensor.port, sensor.volts)) {
        None => Ok(()),
        Some(sensor) => {
            let (robot, name) = (robot.model.name, sensor.port);
            Err(Error::Usage(format!("{robot} has no input {name}")))
        }
    }
}
