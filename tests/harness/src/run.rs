//! A run as a case wants it.

use crate::settings::Settings;
use tip_runtime::model::Model;
use tip_runtime::plant::Scene;
use tip_runtime::program::Program;
use tip_stage::Robot;
use tipc::description::Description;

/// The trace of a run, with the state in each record.
///
/// # Errors
/// The program is for another robot, an input has no such name, or the program never ends.
pub fn run(program: Box<dyn Program>, settings: &Settings) -> Result<String, String> {
    tip_stage::run(program, &robot(settings)?, &settings.events)
}

fn robot(settings: &Settings) -> Result<Robot, String> {
    if let Some(description) = &settings.description {
        return described(description);
    }
    match settings.load.robot {
        tipc::Robot::Titan8 => Ok(Robot::Titan8),
        tipc::Robot::Generic => Ok(Robot::Generic),
        tipc::Robot::Hand => Ok(Robot::Hand(Box::new(scene(settings)?))),
        tipc::Robot::Described(_) => Err("the robot has no description".to_owned()),
    }
}

fn scene(settings: &Settings) -> Result<Scene, String> {
    match &settings.scene {
        Some(name) => Scene::by_name(name).ok_or_else(|| format!("no scene is called {name}")),
        None => Ok(Scene::EMPTY),
    }
}

fn described(description: &Description) -> Result<Robot, String> {
    let one = sized(description).map(Robot::OneJoint);
    let six = sized(description).map(Robot::Hexapod);
    let nine = sized(description).map(Robot::Largest);
    one.or(six).or(nine).ok_or_else(|| {
        let name = description.name();
        format!("no case has had a robot of the size of {name}: it is to be listed here")
    })
}

fn sized<const L: usize, const J: usize>(description: &Description) -> Option<Box<Model<L, J>>> {
    description.model().map(Box::new)
}
