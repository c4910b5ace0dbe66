//! A debugger goes through a run in both directions, and finds at each cycle what a run without it has there.

mod hits;
mod logs;
mod places;
mod threads;
mod walks;
mod watches;

use std::error::Error;
use tip_sim::debug::Debugger;
use tip_sim::{Plant, Robot, load};

type Outcome = Result<(), Box<dyn Error>>;

fn debugger(text: &str, robot: &Robot) -> Result<Debugger, Box<dyn Error>> {
    let program = load("debugged.prg", text, robot).map_err(|error| error.to_string())?;
    Ok(Debugger::new(program.program().clone(), robot)?)
}

fn titan() -> Robot {
    let titan = Robot::named("titan8").expect("it has a name");
    titan.with_plant(Plant::Echo)
}
