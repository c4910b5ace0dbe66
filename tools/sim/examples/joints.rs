//! Writes what a run on TITAN VIII commands its joints, and what its body and feet did, a line for each cycle: twelve
//! angles (deg), x, y, z (mm), roll, pitch, yaw (deg), four loads (N) and the slip so far (mm).
//!
//! `joints PROGRAM.prg quasi-static|dynamic FRICTION`

use std::error::Error;
use std::fs;
use tip_runtime::hardware::JointCommand;
use tip_runtime::plant::{Scene, Simulation};
use tip_sim::{Robot, Run, load};

fn main() -> Result<(), Box<dyn Error>> {
    let [path, plant, friction] = &std::env::args().skip(1).collect::<Vec<_>>()[..] else {
        return Err("joints PROGRAM.prg quasi-static|dynamic FRICTION".into());
    };
    let mut scene = Scene::EMPTY;
    scene.friction = friction.parse()?;
    let chosen = Simulation::NAMES.iter().find(|(name, _)| name == plant);
    scene.plant = chosen.map(|(_, plant)| *plant);
    let robot = Robot::named("titan8")?.with_scene(&scene)?;
    let program = load(path, &fs::read_to_string(path)?, &robot)?;
    let mut run = Run::new(program, robot)?;
    while run.ending().is_none() {
        run.advance(None);
        let (motion, limbs) = (
            run.motion().ok_or("no motion")?,
            run.limbs().ok_or("no limbs")?,
        );
        let pose = motion.pose;
        let [x, y, z] = pose.position;
        let commands = run.commands().iter().copied().map(JointCommand::value);
        let loads = limbs.loads;
        let numbers = commands
            .chain([x, y, z, pose.roll, pose.pitch, pose.yaw])
            .chain(loads)
            .chain([motion.slip]);
        let line: Vec<String> = numbers.map(|number| number.to_string()).collect();
        println!("{}", line.join(","));
    }
    Ok(())
}
